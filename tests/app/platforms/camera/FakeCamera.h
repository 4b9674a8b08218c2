// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "app/platforms/camera/VideoCalls.h"

namespace app::test {

/// A camera behind the calls of the operating system, which gives the images that a test gives it. It checks
/// the order of calls as a driver does. Any thread.
class FakeCamera final : public VideoCalls {
 public:
  static constexpr std::uint32_t kBrightness = V4L2_CID_BRIGHTNESS, kExposure = V4L2_CID_EXPOSURE;

  /// The formats that it has, in its order.
  std::vector<std::uint32_t> formats{V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV};
  /// The only size that it has, and bytes between rows beyond the width; 0: as wide as the image.
  std::uint32_t width = 8, height = 4, step = 0;
  std::uint32_t capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  /// The errno of open(); 0: it opens.
  std::atomic<int> refusal{0};
  std::map<std::uint32_t, std::int32_t> values{{kBrightness, 10}, {kExposure, 100}};

  /// Gives the next image; `flags` as in v4l2_buffer.
  void give(std::string bytes, std::uint32_t flags = 0) {
    {
      const std::lock_guard lock(mutex_);
      images_.push_back({std::move(bytes), flags});
    }
    changed_.notify_all();
  }
  void unplug(bool unplugged) {
    unplugged_ = unplugged;
    changed_.notify_all();
  }
  /// The value of a control while the camera is used.
  std::int32_t value(std::uint32_t control) {
    const std::lock_guard lock(mutex_);
    return values[control];
  }
  void setValue(std::uint32_t control, std::int32_t value) {
    const std::lock_guard lock(mutex_);
    values[control] = value;
  }
  /// How many files are open, and how many buffers are mapped.
  int opened() const { return opened_; }
  int mapped() const { return mapped_; }
  int openings() const { return openings_; }
  std::uint32_t chosenFormat() const { return format_; }
  v4l2_fract period() const { return period_; }
  std::size_t waiting() {
    const std::lock_guard lock(mutex_);
    return images_.size();
  }

  int open(const char*) override {
    if (refusal != 0 || unplugged_) {
      errno = unplugged_ ? ENOENT : refusal.load();
      return -1;
    }
    ++openings_;
    return 7 + opened_++;
  }
  void close(int) override {
    --opened_;
    queued_.clear();
    isStreaming_ = false;
  }
  int ioctl(int, unsigned long request, void* argument) override {
    if (unplugged_) return fail(ENODEV);
    switch (request) {
      case VIDIOC_QUERYCAP:
        return queryCap(*static_cast<v4l2_capability*>(argument));
      case VIDIOC_ENUM_FMT:
        return enumFormat(*static_cast<v4l2_fmtdesc*>(argument));
      case VIDIOC_S_FMT:
        return setFormat(*static_cast<v4l2_format*>(argument));
      case VIDIOC_S_PARM:
        period_ = static_cast<v4l2_streamparm*>(argument)->parm.capture.timeperframe;
        return 0;
      case VIDIOC_G_PARM:
        static_cast<v4l2_streamparm*>(argument)->parm.capture.timeperframe = period_;
        return 0;
      case VIDIOC_QUERYCTRL:
        return queryControl(*static_cast<v4l2_queryctrl*>(argument));
      case VIDIOC_S_CTRL: {
        const std::lock_guard lock(mutex_);
        const auto& control = *static_cast<v4l2_control*>(argument);
        if (!values.contains(control.id)) return fail(EINVAL);
        values[control.id] = control.value;
        return 0;
      }
      case VIDIOC_G_CTRL: {
        const std::lock_guard lock(mutex_);
        auto& control = *static_cast<v4l2_control*>(argument);
        if (!values.contains(control.id)) return fail(EINVAL);
        control.value = values[control.id];
        return 0;
      }
      case VIDIOC_REQBUFS:
        static_cast<v4l2_requestbuffers*>(argument)->count = kBuffers;
        return 0;
      case VIDIOC_QUERYBUF: {
        auto& buffer = *static_cast<v4l2_buffer*>(argument);
        buffer.length = kLength;
        buffer.m.offset = buffer.index * kLength;
        return 0;
      }
      case VIDIOC_QBUF:
        queued_.push_back(static_cast<v4l2_buffer*>(argument)->index);
        return 0;
      case VIDIOC_DQBUF:
        return dequeue(*static_cast<v4l2_buffer*>(argument));
      case VIDIOC_STREAMON:
        isStreaming_ = true;
        return 0;
      case VIDIOC_STREAMOFF:
        isStreaming_ = false;
        return 0;
      default:
        return fail(ENOTTY);
    }
  }
  void* map(int, std::size_t, std::int64_t offset) override {
    ++mapped_;
    return memory_.data() + offset;
  }
  void unmap(void*, std::size_t) override { --mapped_; }
  int wait(int, int milliseconds) override {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::milliseconds(milliseconds),
                      [this] { return unplugged_ || !images_.empty(); });
    return unplugged_ ? -1 : (images_.empty() ? 0 : 1);
  }

 private:
  static constexpr std::uint32_t kBuffers = 4, kLength = 65536;
  struct Given {
    std::string bytes;
    std::uint32_t flags = 0;
  };

  static int fail(int error) {
    errno = error;
    return -1;
  }
  template <std::size_t kSize>
  static void write(const char* text, unsigned char (&field)[kSize]) {
    std::memset(field, 0, kSize);
    std::memcpy(field, text, std::min(kSize, std::strlen(text)));
  }
  int queryCap(v4l2_capability& about) const {
    write("Fake camera", about.card);
    about.capabilities = capabilities;
    return 0;
  }
  int enumFormat(v4l2_fmtdesc& format) const {
    if (format.index >= formats.size()) return fail(EINVAL);
    format.pixelformat = formats[format.index];
    return 0;
  }
  int setFormat(v4l2_format& format) {
    format.fmt.pix.width = width;
    format.fmt.pix.height = height;
    format.fmt.pix.bytesperline = step;
    format_ = format.fmt.pix.pixelformat;
    return 0;
  }
  static int queryControl(v4l2_queryctrl& control) {
    const std::uint32_t after = control.id & ~V4L2_CTRL_FLAG_NEXT_CTRL;
    const std::uint32_t next = after < kBrightness ? kBrightness : after < kExposure ? kExposure : 0;
    if (next == 0) return fail(EINVAL);
    control = {};
    control.id = next;
    control.type = V4L2_CTRL_TYPE_INTEGER;
    write(next == kBrightness ? "Brightness" : "Exposure Time, Absolute", control.name);
    control.minimum = 0;
    control.maximum = 255;
    control.step = 1;
    return 0;
  }
  int dequeue(v4l2_buffer& buffer) {
    const std::lock_guard lock(mutex_);
    if (!isStreaming_) return fail(EINVAL);
    if (images_.empty() || queued_.empty()) return fail(EAGAIN);
    buffer.index = queued_.front();
    queued_.pop_front();
    const Given given = std::move(images_.front());
    images_.pop_front();
    std::memcpy(memory_.data() + static_cast<std::size_t>(buffer.index) * kLength, given.bytes.data(),
                given.bytes.size());
    buffer.bytesused = static_cast<std::uint32_t>(given.bytes.size());
    buffer.flags = given.flags;
    return 0;
  }

  std::mutex mutex_;  // protects images_, which a test gives while another thread takes them
  std::condition_variable changed_;
  std::deque<Given> images_;
  std::deque<std::uint32_t> queued_;
  std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(std::size_t{kBuffers} * kLength);
  std::atomic<bool> unplugged_{false};
  std::atomic<int> opened_{0}, mapped_{0}, openings_{0};
  std::atomic<std::uint32_t> format_{0};
  v4l2_fract period_{1, 30};
  bool isStreaming_ = false;
};

}  // namespace app::test
