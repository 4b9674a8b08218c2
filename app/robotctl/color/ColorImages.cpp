// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/color/ColorImages.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "foxglove/Image.pb.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/images/ImageCoding.h"
#include "logplayer/images/PictureFile.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace app {

using colortool::ColorImage;
using robotlink::failure;
using robotlink::Image;
using robotlink::Result;

namespace {

namespace fs = std::filesystem;

constexpr int kYuyvWidth = 320, kYuyvHeight = 240;
constexpr std::size_t kYuyvBytes = std::size_t{kYuyvWidth} * kYuyvHeight * 4;

Result<ColorImage> yuyvImage(const std::string& bytes, const fs::path& file) {
  if (bytes.size() != kYuyvBytes) {
    return failure("image.size",
                   "a .yuyv image has " + std::to_string(kYuyvBytes) + " bytes, this has " +
                       std::to_string(bytes.size()),
                   {file.string(), 0, 0});
  }
  ColorImage image(kYuyvWidth, kYuyvHeight);
  const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
  for (robotlink::YCbCr& pixel : image.pixels) {
    pixel = {from[2], from[1], from[3]};
    from += 4;
  }
  return image;
}

Result<std::shared_ptr<const foxglove::RawImage>> rawImageOf(const robotlink::StreamMessage& message) {
  if (auto raw = std::dynamic_pointer_cast<const foxglove::RawImage>(message.value)) return raw;
  const auto* compressed = dynamic_cast<const foxglove::CompressedImage*>(message.value.get());
  if (compressed == nullptr) return failure("image.type", message.path + " holds no images");
  return logplayer::rawImage(*compressed);
}

/// The path of the stream with the true classes of the same robot.
std::string classesBeside(const std::string& stream) {
  return stream.substr(0, stream.find('/') + 1) + robotlink::kOracleClasses.name;
}

}  // namespace

Result<ColorImages> ColorImages::open(const fs::path& folderOrLog) {
  std::error_code error;
  if (fs::is_regular_file(folderOrLog, error)) return openLog(folderOrLog);
  ColorImages images;
  images.path_ = folderOrLog;
  for (fs::directory_iterator entry(folderOrLog, error), end; !error && entry != end;
       entry.increment(error)) {
    if (logplayer::isPictureFile(entry->path())) images.names_.push_back(entry->path().filename().string());
  }
  if (error) {
    return failure("image.folder", "cannot read this folder of images: " + error.message(),
                   {folderOrLog.string(), 0, 0});
  }
  if (images.names_.empty()) {
    return failure("image.folder", "there are no images here (.png, .jpg, .yuyv)",
                   {folderOrLog.string(), 0, 0});
  }
  std::ranges::sort(images.names_);
  return images;
}

Result<ColorImages> ColorImages::openLog(const fs::path& file) {
  ColorImages images;
  images.path_ = file;
  auto log = logplayer::LogFile::open(file, {});
  if (!log) return tl::unexpected(log.error());
  images.log_ = *log;
  const std::string raw = foxglove::RawImage::descriptor()->full_name();
  const std::string compressed = foxglove::CompressedImage::descriptor()->full_name();
  for (const auto& stream : images.log_->streams()) {
    if (!stream.holds(raw) && !stream.holds(compressed)) continue;
    if (stream.path == classesBeside(stream.path)) continue;
    for (const robotlink::Instant time : images.log_->times(stream.path)) {
      std::array<char, 24> name{};
      std::snprintf(name.data(), name.size(), "%03zu", images.names_.size());
      images.names_.emplace_back(name.data());
      images.logged_[name.data()] = {stream.path, time.time_since_epoch().count()};
    }
  }
  if (images.names_.empty())
    return failure("image.log", "there are no images in this log", {file.string(), 0, 0});
  return images;
}

Result<ColorImage> ColorImages::load(const std::string& name) const {
  if (log_ != nullptr) return loadLogged(fs::path(name).stem().string());
  const auto exact = std::ranges::find(names_, name);
  if (exact != names_.end()) return loadFile(path_ / name);
  const auto like = std::ranges::find_if(
      names_, [&](const std::string& file) { return fs::path(file).stem() == fs::path(name).stem(); });
  if (like != names_.end()) return loadFile(path_ / *like);
  return failure("image.missing", "there is no image " + name, {path_.string(), 0, 0}, {name});
}

Result<ColorImage> ColorImages::loadLogged(const std::string& name) const {
  const auto found = logged_.find(name);
  if (found == logged_.end()) {
    return failure("image.missing", "there is no image " + name + "; its images are 000 to " + names_.back(),
                   {path_.string(), 0, 0}, {name});
  }
  const auto message =
      log_->latest(found->second.stream, robotlink::Instant(robotlink::Duration(found->second.time)));
  if (!message)
    return failure("image.damaged", "image " + name + " cannot be read", {path_.string(), 0, 0}, {name});
  const auto raw = rawImageOf(*message);
  if (!raw) return tl::unexpected(raw.error());
  return ColorImage::of(robotlink::imageView(**raw));
}

Result<std::optional<Image>> ColorImages::trueClasses(const std::string& name) const {
  const auto found = logged_.find(fs::path(name).stem().string());
  if (found == logged_.end()) return std::nullopt;
  const robotlink::Instant time{robotlink::Duration(found->second.time)};
  const auto message = log_->latest(classesBeside(found->second.stream), time);
  if (!message || message->time != time) return std::nullopt;
  const auto raw = rawImageOf(*message);
  if (!raw) return tl::unexpected(raw.error());
  const robotlink::ImageView view = robotlink::imageView(**raw);
  if (view.empty() || view.format != robotlink::PixelFormat::kMono8)
    return failure("image.labels", "the true classes of image " + name + " are damaged",
                   {path_.string(), 0, 0}, {name});
  Image labels(view.width, view.height, view.format);
  for (int y = 0; y < view.height; ++y) std::copy_n(view.row(y), view.width, labels.row(y));
  return labels;
}

Result<ColorImage> ColorImages::loadFile(const fs::path& file) {
  if (robotlink::fileSuffix(file) == ".yuyv") {
    const auto bytes = robotlink::readFile(file, kYuyvBytes + 1);
    return bytes ? yuyvImage(*bytes, file) : tl::unexpected(bytes.error());
  }
  const auto image = logplayer::readPicture(file);
  if (!image) return tl::unexpected(image.error());
  return ColorImage::of(image->view());
}

Result<Image> ColorImages::loadLabels(const fs::path& file) {
  auto image = logplayer::readPicture(file);
  if (image && image->format != robotlink::PixelFormat::kMono8) {
    return failure("image.labels", "labels are a gray PNG with the classes' numbers; this one has colors",
                   {file.string(), 0, 0});
  }
  return image;
}

}  // namespace app
