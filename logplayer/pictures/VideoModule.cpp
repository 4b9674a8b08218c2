// SPDX-License-Identifier: GPL-3.0-or-later
// The module that decodes and encodes videos.
#include "logplayer/pictures/VideoModule.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <opencv2/videoio.hpp>
#include <string_view>

namespace {

using logplayer::VideoReader;
using logplayer::VideoWriter;

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

class OpenCvOutput final : public VideoWriter {
 public:
  OpenCvOutput(const char* file, const char* codec, cv::Size size, double rate)
      : size_(size),
        writer_(file, cv::CAP_FFMPEG, cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]), rate,
                size) {}

  bool isOpen() const { return writer_.isOpened(); }

  bool write(const std::uint8_t* data, int step) override try {
    // OpenCV takes no constant bytes; it only reads them.
    writer_.write(cv::Mat(size_, CV_8UC3, const_cast<std::uint8_t*>(data), static_cast<std::size_t>(step)));
    return true;
  } catch (const std::exception&) {
    return false;
  }

 private:
  cv::Size size_;
  cv::VideoWriter writer_;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) VideoWriter* robotcontrol_create_video(const char* file,
                                                                                         int width,
                                                                                         int height,
                                                                                         double rate) {
  try {
    const bool isAvi = std::string_view(file).ends_with(".avi");
    for (const char* codec : {isAvi ? "MJPG" : "avc1", isAvi ? "MJPG" : "mp4v"}) {
      auto video = std::make_unique<OpenCvOutput>(file, codec, cv::Size(width, height), rate);
      if (video->isOpen()) return video.release();
    }
  } catch (const std::exception&) {
    // Reported as null, as all failures are.
  }
  return nullptr;
}

extern "C" __attribute__((visibility("default"))) VideoReader* robotcontrol_open_video(const char* file) {
  try {
    auto video = std::make_unique<OpenCvVideo>(file);
    return video->isOpen() ? video.release() : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}
