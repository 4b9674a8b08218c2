// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/images/PictureFile.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Image;
using robotlink::Result;

constexpr std::size_t kMaxFileBytes = 256U << 20U;
constexpr int kYuyvWidth = 320, kYuyvHeight = 240;
constexpr std::size_t kYuyvBytes = std::size_t{kYuyvWidth} * kYuyvHeight * 4;

Result<Image> yuyvImage(const std::string& bytes, const fs::path& file, YuyvPixels pixels) {
  if (bytes.size() != kYuyvBytes) {
    return failure("image.size",
                   "a .yuyv picture has 320 x 240 pixels of four bytes, 307200 in all; this file has " +
                       std::to_string(bytes.size()),
                   {file.string(), 0, 0});
  }
  if (pixels == YuyvPixels::kAll) {
    Image image(2 * kYuyvWidth, kYuyvHeight, robotlink::PixelFormat::kYuyv);
    std::ranges::copy(bytes, image.data.begin());
    return image;
  }
  Image image(kYuyvWidth, kYuyvHeight, robotlink::PixelFormat::kYuyv);
  const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
  for (std::size_t i = 0; i < image.data.size(); i += 4, from += 8) {
    const auto mean = [&](std::size_t at) {
      return static_cast<std::uint8_t>((from[at] + from[at + 4] + 1) / 2);
    };
    image.data[i] = from[2];
    image.data[i + 1] = mean(1);
    image.data[i + 2] = from[6];
    image.data[i + 3] = mean(3);
  }
  return image;
}

}  // namespace

bool isPictureFile(const fs::path& file) {
  constexpr std::array<const char*, 4> kEndings = {".png", ".jpg", ".jpeg", ".yuyv"};
  return std::ranges::find(kEndings, robotlink::fileSuffix(file)) != kEndings.end();
}

Result<Image> readPicture(const fs::path& file, YuyvPixels yuyv) {
  const auto bytes = robotlink::readFile(file, kMaxFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  if (robotlink::fileSuffix(file) == ".yuyv") return yuyvImage(*bytes, file, yuyv);
  const std::span data(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
  auto image = robotlink::fileSuffix(file) == ".png" ? decodePng(data) : decodeJpeg(data);
  if (!image) image.error().where = {file.string(), 0, 0};
  return image;
}

Result<std::vector<fs::path>> pictureFiles(const std::vector<fs::path>& filesOrFolders) {
  std::vector<fs::path> files;
  for (const fs::path& given : filesOrFolders) {
    std::error_code error;
    if (!fs::is_directory(given, error)) {
      files.push_back(given);
      continue;
    }
    const auto begin = static_cast<std::ptrdiff_t>(files.size());
    for (fs::directory_iterator entry(given, error), end; !error && entry != end; entry.increment(error)) {
      std::error_code unknown;
      if (isPictureFile(entry->path()) && !entry->is_directory(unknown)) files.push_back(entry->path());
    }
    if (error)
      return failure("image.folder", "this folder cannot be read: " + error.message(),
                     {given.string(), 0, 0});
    std::sort(files.begin() + begin, files.end());
  }
  if (files.empty()) {
    return failure("image.folder", "there are no pictures here: files that end in .png, .jpg, .jpeg or .yuyv",
                   {filesOrFolders.empty() ? std::string() : filesOrFolders.front().string(), 0, 0});
  }
  return files;
}

}  // namespace logplayer
