// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a folder as frames of a camera.
#include "logplayer/pictures/PictureFrames.h"

#include <algorithm>

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "logplayer/images/PictureFile.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/NaturalOrder.h"
#include "robotlink/packages/Conversions.h"

namespace logplayer {

using robotlink::Result;

namespace {

constexpr std::size_t kMaxFile = 256U << 20U;

}  // namespace

bool isPictureFolder(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::is_directory(folder, error) && pictureFiles({folder}).has_value();
}

Result<PictureFrames> PictureFrames::open(const std::filesystem::path& folder) {
  auto files = pictureFiles({folder});
  if (!files) return tl::unexpected(files.error());
  std::ranges::sort(*files, [](const auto& a, const auto& b) {
    return robotlink::comesNaturallyBefore(a.filename().string(), b.filename().string());
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
