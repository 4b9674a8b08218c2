// SPDX-License-Identifier: GPL-3.0-or-later
// Makes frames of what the video module decodes.
#include "logplayer/pictures/VideoFrames.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "logplayer/pictures/VideoLibrary.h"
#include "logplayer/pictures/VideoModule.h"
#include "robotlink/packages/Conversions.h"

namespace logplayer {

namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Result;

namespace {

/// High enough that colors keep their classes.
constexpr int kQuality = 95;

}  // namespace

bool isVideo(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;  // reading a named pipe would wait
  std::array<char, 16> head{};
  std::ifstream in(file, std::ios::binary);
  if (!in.read(head.data(), head.size())) return false;
  const std::string_view bytes(head.data(), head.size());
  using namespace std::string_view_literals;
  const std::string_view box = bytes.substr(4, 4);  // of ISO media files and QuickTime
  const bool isIso = box == "ftyp" || box == "moov" || box == "mdat" || box == "wide";
  const bool isAvi = bytes.starts_with("RIFF") && bytes.substr(8, 4) == "AVI ";
  return isIso || isAvi || bytes.starts_with("\x1a\x45\xdf\xa3"sv) || bytes.starts_with("\0\0\1\xba"sv) ||
         bytes.starts_with("\0\0\1\xb3"sv);
}

Result<VideoFrames> VideoFrames::open(const fs::path& file) {
  const VideoLibrary& loaded = videoLibrary();
  if (loaded.open == nullptr)
    return failure("video.module", "this installation cannot read videos: " + loaded.problem,
                   {file.string(), 0, 0}, {loaded.problem});
  std::error_code error;
  // An absolute path, so that no part of it can be taken for a protocol.
  std::unique_ptr<VideoReader> reader(loaded.open(fs::absolute(file, error).c_str()));
  if (!reader)
    return failure("video.open",
                   "this video cannot be decoded; convert it, for instance with: ffmpeg -i VIDEO out.mp4",
                   {file.string(), 0, 0});
  return VideoFrames(file, std::move(reader));
}

VideoFrames::VideoFrames(fs::path file, std::unique_ptr<VideoReader> reader)
    : file_(std::move(file)), reader_(std::move(reader)) {}
VideoFrames::VideoFrames(VideoFrames&&) noexcept = default;
VideoFrames::~VideoFrames() = default;

double VideoFrames::share() const {
  const std::uint64_t all = reader_->frames();
  return all == 0 ? 0 : std::min(1.0, static_cast<double>(count_) / static_cast<double>(all));
}

Result<std::optional<FrameSource::Frame>> VideoFrames::next() {
  VideoReader::Frame decoded;
  if (ended_ || !reader_->next(decoded)) {
    const std::uint64_t stated = reader_->frames();
    // Containers state about how many there are: one second more or less is no damage.
    if (!std::exchange(ended_, true) && count_ + 30 < stated)
      return failure("video.truncated",
                     "the video breaks off after " + std::to_string(count_) + " of " +
                         std::to_string(stated) + " frames",
                     {file_.string(), 0, 0}, {std::to_string(count_), std::to_string(stated)});
    return std::optional<Frame>();
  }
  ++count_;
  const auto jpeg = encodeJpeg(
      {decoded.width, decoded.height, decoded.step, robotlink::PixelFormat::kBgr8, decoded.data}, kQuality);
  if (!jpeg) return tl::unexpected(jpeg.error());
  auto image = std::make_shared<foxglove::CompressedImage>();
  const robotlink::Duration time = robotlink::fromSeconds(decoded.time);
  robotlink::assign(*image->mutable_timestamp(), robotlink::Instant(time));
  image->set_frame_id("camera");
  image->set_format("jpeg");
  image->set_data(jpeg->data(), jpeg->size());
  return std::optional(Frame{time, std::move(image), decoded.width, decoded.height});
}

}  // namespace logplayer
