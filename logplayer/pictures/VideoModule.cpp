// SPDX-License-Identifier: GPL-3.0-or-later
// The module that decodes videos.
#include "logplayer/pictures/VideoModule.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <opencv2/videoio.hpp>

namespace {

using logplayer::VideoReader;

class OpenCvVideo final : public VideoReader {
 public:
  /// Only FFmpeg, since OpenCV's other readers also take patterns and addresses for names.
  explicit OpenCvVideo(const char* file) : capture_(file, cv::CAP_FFMPEG) {}

  bool isOpen() const { return capture_.isOpened(); }

  std::uint64_t frames() const override {
    const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
    return count > 0 && count < 1e9 ? static_cast<std::uint64_t>(count) : 0;
  }

  bool next(Frame& frame) override try {
    if (!capture_.read(image_) || image_.type() != CV_8UC3) return false;
    const double rate = capture_.get(cv::CAP_PROP_FPS);
    const double stated = capture_.get(cv::CAP_PROP_POS_MSEC) / 1e3;
    if (count_ == 0) first_ = stated;
    const double period = rate > 0.1 && rate < 1e4 ? 1 / rate : 0.04;
    // Some files state no times, or the same for all frames.
    const double time = count_ == 0 ? 0 : stated > first_ + last_ ? stated - first_ : last_ + period;
    last_ = std::max(last_, time);
    ++count_;
    frame = {image_.cols, image_.rows, static_cast<int>(image_.step[0]), image_.data, last_};
    return true;
  } catch (const std::exception&) {
    return false;  // cv::Exception, or no memory for a frame of absurd size
  }

 private:
  cv::VideoCapture capture_;
  cv::Mat image_;
  std::uint64_t count_ = 0;
  double first_ = 0, last_ = 0;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) VideoReader* robotcontrol_open_video(const char* file) {
  try {
    auto video = std::make_unique<OpenCvVideo>(file);
    return video->isOpen() ? video.release() : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}
