// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/pictures/VideoOutput.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "logplayer/pictures/VideoLibrary.h"

namespace logplayer {

namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Result;

namespace {

/// The number of frames that are written between two checks of the free space.
constexpr std::uint64_t kFramesPerLook = 8;

std::string lowerSuffix(const fs::path& file) {
  std::string suffix = file.extension().string();
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::uintmax_t freeSpaceOf(const fs::path& folder) {
  std::error_code error;
  const auto space = fs::space(folder, error);
  // A file system that does not report its free space is assumed to have enough.
  return error ? ~std::uintmax_t{0} : space.available;
}

Result<void> checkOptions(const fs::path& file, const VideoOutput::Options& options) {
  const auto isSide = [](int side) { return side >= VideoOutput::kMinSide && side <= VideoOutput::kMaxSide; };
  if (!isSide(options.width) || !isSide(options.height))
    return failure("video.size",
                   "a video is " + std::to_string(VideoOutput::kMinSide) + " to " +
                       std::to_string(VideoOutput::kMaxSide) + " pixels wide and high, not " +
                       std::to_string(options.width) + " x " + std::to_string(options.height),
                   {file.string(), 0, 0});
  if (std::isfinite(options.rate) && options.rate >= VideoOutput::kMinRate &&
      options.rate <= VideoOutput::kMaxRate)
    return {};
  return failure("video.rate", "a video has 0.1 to 240 frames a second", {file.string(), 0, 0});
}

}  // namespace

Result<void> VideoOutput::checkName(const fs::path& file) {
  const std::string suffix = lowerSuffix(file);
  if (suffix == ".avi" || suffix == ".mp4") return {};
  return failure("video.suffix",
                 "the name of a video ends in .mp4 (H.264) or .avi (Motion JPEG)" +
                     (suffix.empty() ? std::string() : ", not in " + suffix),
                 {file.string(), 0, 0}, {suffix});
}

VideoOutput::VideoOutput(OutputFile output, fs::path file, Options options)
    : file_(std::move(file)),
      options_(std::move(options)),
      output_(std::move(output)),
      encoded_(output_.temporary().string() + lowerSuffix(file_)),
      unfinished_(std::in_place, encoded_) {}

VideoOutput::VideoOutput(VideoOutput&& other) noexcept
    : file_(std::move(other.file_)),
      options_(std::move(other.options_)),
      output_(std::move(other.output_)),
      encoded_(std::exchange(other.encoded_, {})),
      unfinished_(std::move(other.unfinished_)),
      writer_(std::move(other.writer_)),
      frames_(other.frames_) {}

VideoOutput::~VideoOutput() {
  writer_.reset();  // the destructor of the writer still writes
  std::error_code error;
  if (!encoded_.empty()) fs::remove(encoded_, error);
}

Result<VideoOutput> VideoOutput::create(const fs::path& file, const Options& options) {
  if (auto done = checkName(file); !done) return tl::unexpected(done.error());
  if (auto done = checkOptions(file, options); !done) return tl::unexpected(done.error());
  auto output = OutputFile::create(file, true);
  if (!output) return tl::unexpected(output.error());
  VideoOutput video(std::move(*output), file, options);
  if (auto done = video.checkSpace(); !done) return tl::unexpected(done.error());
  const VideoLibrary& library = videoLibrary();
  if (library.create == nullptr)
    return failure(
        "video.module",
        "this installation cannot write videos (" + library.problem + "); export a series of images instead",
        {file.string(), 0, 0}, {library.problem});
  std::error_code error;
  // An absolute path, so that no part of it can be taken for a protocol.
  video.writer_.reset(library.create(fs::absolute(video.encoded_, error).c_str(), evenSize(options.width),
                                     evenSize(options.height), options.rate));
  if (video.writer_) return video;
  const bool isAvi = lowerSuffix(file) == ".avi";
  return failure("video.encoder",
                 std::string("this installation has no encoder for ") + (isAvi ? ".avi" : ".mp4") +
                     " of this size and rate; choose " + (isAvi ? ".mp4" : ".avi") +
                     ", or export a series of images",
                 {file.string(), 0, 0});
}

Result<void> VideoOutput::checkSpace() const {
  const auto space = options_.freeSpace ? options_.freeSpace : freeSpaceOf;
  if (space(folderOf(encoded_)) >= kMinFree) return {};
  return failure("file.full", "the disk is full; the video was deleted", {file_.string(), 0, 0});
}

Result<void> VideoOutput::write(const std::uint8_t* data, int step) {
  if (frames_++ % kFramesPerLook == 0) {
    if (auto done = checkSpace(); !done) return done;
  }
  if (writer_->write(data, step)) return {};
  return failure("video.encode", "frame " + std::to_string(frames_) + " could not be encoded",
                 {file_.string(), 0, 0});
}

Result<void> VideoOutput::finish() {
  writer_.reset();
  std::error_code error;
  // An encoder does not say whether its last bytes reached the disk.
  const std::unique_ptr<VideoReader> reader(videoLibrary().open(fs::absolute(encoded_, error).c_str()));
  if (!reader || reader->frames() < frames_)
    return failure("video.incomplete", "the video is incomplete and was deleted: perhaps the disk is full",
                   {file_.string(), 0, 0});
  fs::rename(encoded_, output_.temporary(), error);
  if (error)
    return failure("file.io", "cannot give the video its name: " + error.message(), {file_.string(), 0, 0},
                   {error.message()});
  encoded_.clear();
  return output_.commit();
}

}  // namespace logplayer
