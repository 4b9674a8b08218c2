// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a folder as frames of a camera.
#include "logplayer/pictures/PictureFrames.h"

#include <algorithm>
#include <cctype>
#include <span>

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "logplayer/images/PictureFile.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/packages/Conversions.h"

namespace logplayer {

using robotlink::Result;

namespace {

constexpr std::size_t kMaxFile = 256U << 20U;

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The digits at a place, without leading zeros; moves the place behind them.
std::string_view numberAt(const std::string& text, std::size_t& at) {
  while (at < text.size() && text[at] == '0') ++at;
  const std::size_t begin = at;
  while (at < text.size() && isDigit(text[at])) ++at;
  return std::string_view(text).substr(begin, at - begin);
}

}  // namespace

bool isPictureFolder(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::is_directory(folder, error) && pictureFiles({folder}).has_value();
}

bool isNaturallyBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (isDigit(a[i]) && isDigit(b[k])) {
      const std::string_view left = numberAt(a, i), right = numberAt(b, k);
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    } else {
      if (a[i] != b[k]) return a[i] < b[k];
      ++i, ++k;
    }
  }
  return i < a.size() || k < b.size() ? k < b.size() : a < b;
}

Result<PictureFrames> PictureFrames::open(const std::filesystem::path& folder) {
  auto files = pictureFiles({folder});
  if (!files) return tl::unexpected(files.error());
  std::ranges::sort(*files, [](const auto& a, const auto& b) {
    return isNaturallyBefore(a.filename().string(), b.filename().string());
  });
  return PictureFrames(std::move(*files));
}

double PictureFrames::share() const {
  return static_cast<double>(next_) / static_cast<double>(files_.size());
}

Result<std::optional<FrameSource::Frame>> PictureFrames::next() {
  if (next_ == files_.size()) return std::optional<Frame>();
  const std::filesystem::path& file = files_[next_];
  Frame frame{.time = kPeriod * static_cast<std::int64_t>(next_)};
  ++next_;
  // Each is decoded once, so that a broken file is named here.
  const auto image = readPicture(file);
  if (!image) return tl::unexpected(image.error());
  frame.width = image->width;
  frame.height = image->height;
  const std::string suffix = robotlink::fileSuffix(file);
  if (suffix == ".yuyv") {
    auto raw = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*raw, image->view(), robotlink::Instant(frame.time), "camera");
    frame.image = std::move(raw);
    return std::optional(std::move(frame));
  }
  auto bytes = robotlink::readFile(file, kMaxFile);
  if (!bytes) return tl::unexpected(bytes.error());
  auto compressed = std::make_shared<foxglove::CompressedImage>();
  robotlink::assign(*compressed->mutable_timestamp(), robotlink::Instant(frame.time));
  compressed->set_frame_id("camera");
  compressed->set_format(suffix == ".png" ? "png" : "jpeg");
  compressed->set_data(std::move(*bytes));
  frame.image = std::move(compressed);
  return std::optional(std::move(frame));
}

}  // namespace logplayer
