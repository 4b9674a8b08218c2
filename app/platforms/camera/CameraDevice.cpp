// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/CameraDevice.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>

#include "logplayer/images/ImageCoding.h"

namespace app {
namespace {

using robotlink::Error;
using robotlink::failure;
using robotlink::Image;
using robotlink::PixelFormat;
using robotlink::Result;

constexpr std::uint32_t kCapture = V4L2_BUF_TYPE_VIDEO_CAPTURE;
constexpr std::uint32_t kBuffers = 4;
constexpr int kUsualWidth = 640, kUsualHeight = 480;
/// A driver that lists more formats or controls than that is not believed.
constexpr std::uint32_t kMaxListed = 256;

/// A format that can be decoded; a pixel format, or JPEG.
struct Decodable {
  std::uint32_t code;
  std::optional<PixelFormat> pixels;
};
/// The first that a camera has is taken: what needs no conversion for perception, then what needs one.
constexpr std::array<Decodable, 8> kDecodable{{{V4L2_PIX_FMT_YUYV, PixelFormat::kYuyv},
                                               {V4L2_PIX_FMT_UYVY, PixelFormat::kUyvy},
                                               {V4L2_PIX_FMT_NV12, PixelFormat::kNv12},
                                               {V4L2_PIX_FMT_RGB24, PixelFormat::kRgb8},
                                               {V4L2_PIX_FMT_BGR24, PixelFormat::kBgr8},
                                               {V4L2_PIX_FMT_MJPEG, std::nullopt},
                                               {V4L2_PIX_FMT_JPEG, std::nullopt},
                                               {V4L2_PIX_FMT_GREY, PixelFormat::kMono8}}};

std::string lettersOf(std::uint32_t code) {
  std::string letters;
  for (int i = 0; i < 4; ++i) letters += static_cast<char>((code >> (8 * i)) & 0x7fU);
  while (letters.ends_with(' ')) letters.pop_back();
  return letters;
}

const Decodable* decodable(std::uint32_t code) {
  const auto found = std::ranges::find(kDecodable, code, &Decodable::code);
  return found == kDecodable.end() ? nullptr : &*found;
}

/// "Exposure, Auto" becomes "exposure_auto".
std::string controlName(const std::string& title) {
  std::string name;
  for (const char letter : title) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalnum(byte) != 0) {
      name += static_cast<char>(std::tolower(byte));
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (name.ends_with('_')) name.pop_back();
  return name;
}

/// A text of the driver, which need not be terminated.
template <std::size_t kSize>
std::string textIn(const unsigned char (&field)[kSize]) {
  const auto end = std::find(std::begin(field), std::end(field), 0);
  return {std::begin(field), end};
}

std::string reasonOf(int error) {
  switch (error) {
    case EACCES:
      return "no permission; add yourself to the group video: sudo adduser $USER video";
    case EBUSY:
      return "another program uses it; close that one";
    case ENOENT:
      return "there is no such device; is the camera plugged in?";
    case ENODEV:
    case ENXIO:
      return "the camera is gone";
    default:
      return std::strerror(error);
  }
}

}  // namespace

Error CameraDevice::failed(const std::string& what) const {
  return {errno == ENODEV ? "camera.gone" : "camera.failed",
          device_ + ": " + what + ": " + reasonOf(errno),
          {device_},
          {}};
}

Result<std::unique_ptr<CameraDevice>> CameraDevice::open(const CameraAddress& address, VideoCalls& calls) {
  std::unique_ptr<CameraDevice> device(new CameraDevice(address.device, calls));
  if (auto begun = device->begin(address); !begun) return tl::unexpected(begun.error());
  return device;
}

Result<void> CameraDevice::begin(const CameraAddress& address) {
  file_ = calls_.open(device_.c_str());
  if (file_ < 0) return tl::unexpected(failed("the camera cannot be opened"));
  if (auto done = identify(); !done) return done;
  if (auto done = chooseMode(address); !done) return done;
  chooseRate(address.rate);
  listControls();
  for (const auto& [name, value] : address.controls) {
    if (auto done = set(name, value); !done) return done;
  }
  if (auto done = mapBuffers(); !done) return done;
  refresh();
  std::uint32_t type = kCapture;
  if (calls_.ioctl(file_, VIDIOC_STREAMON, &type) < 0)
    return tl::unexpected(failed("the camera does not start capturing"));
  isStreaming_ = true;
  return {};
}

CameraDevice::~CameraDevice() {
  if (file_ < 0) return;
  std::uint32_t type = kCapture;
  if (isStreaming_) calls_.ioctl(file_, VIDIOC_STREAMOFF, &type);
  for (const Buffer& buffer : buffers_) calls_.unmap(buffer.memory, buffer.length);
  calls_.close(file_);
}

Result<void> CameraDevice::identify() {
  v4l2_capability about{};
  if (calls_.ioctl(file_, VIDIOC_QUERYCAP, &about) < 0)
    return failure("camera.none", device_ + " is not a camera", {}, {device_});
  title_ = textIn(about.card);
  const std::uint32_t can =
      (about.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? about.device_caps : about.capabilities;
  if ((can & V4L2_CAP_VIDEO_CAPTURE) == 0 || (can & V4L2_CAP_STREAMING) == 0) {
    return failure(
        "camera.none",
        device_ + " (" + title_ + ") takes no images; a camera may have several devices, try the others", {},
        {device_});
  }
  return {};
}

Result<void> CameraDevice::chooseMode(const CameraAddress& address) {
  std::vector<std::uint32_t> offered;
  std::string names;
  for (std::uint32_t i = 0; i < kMaxListed; ++i) {
    v4l2_fmtdesc format{};
    format.index = i;
    format.type = kCapture;
    if (calls_.ioctl(file_, VIDIOC_ENUM_FMT, &format) < 0) break;
    offered.push_back(format.pixelformat);
    names += (names.empty() ? "" : ", ") + lettersOf(format.pixelformat);
  }
  const auto fits = [&](const Decodable& one) {
    return std::ranges::find(offered, one.code) != offered.end() &&
           (address.format.empty() || lettersOf(one.code) == address.format);
  };
  const auto chosen = std::ranges::find_if(kDecodable, fits);
  if (chosen == kDecodable.end()) {
    const std::string wanted = address.format.empty() ? "a format that can be decoded" : address.format;
    return failure("camera.format", device_ + " (" + title_ + ") does not offer " + wanted + "; it has " +
                                        (names.empty() ? "none" : names));
  }
  v4l2_format format{};
  format.type = kCapture;
  format.fmt.pix.width = static_cast<std::uint32_t>(address.width > 0 ? address.width : kUsualWidth);
  format.fmt.pix.height = static_cast<std::uint32_t>(address.height > 0 ? address.height : kUsualHeight);
  format.fmt.pix.pixelformat = chosen->code;
  format.fmt.pix.field = V4L2_FIELD_ANY;
  if (calls_.ioctl(file_, VIDIOC_S_FMT, &format) < 0)
    return tl::unexpected(failed("the camera refuses the size or the format"));
  mode_.width = static_cast<int>(format.fmt.pix.width);
  mode_.height = static_cast<int>(format.fmt.pix.height);
  mode_.format = lettersOf(format.fmt.pix.pixelformat);
  step_ = static_cast<int>(format.fmt.pix.bytesperline);
  const Decodable* given = decodable(format.fmt.pix.pixelformat);
  if (given == nullptr ||
      (given->pixels && !robotlink::canHaveSize(*given->pixels, mode_.width, mode_.height)))
    return failure("camera.format", device_ + " (" + title_ + ") chose a format that cannot be decoded: " +
                                        std::to_string(mode_.width) + "x" + std::to_string(mode_.height) +
                                        " " + mode_.format);
  if (given->pixels) step_ = std::max(step_, mode_.width * robotlink::bytesPerPixel(*given->pixels));
  return {};
}

/// Cameras without a choice of rates refuse this, which is no error.
void CameraDevice::chooseRate(double rate) {
  v4l2_streamparm parameters{};
  parameters.type = kCapture;
  if (rate > 0) {
    constexpr double kParts = 1000;
    parameters.parm.capture.timeperframe = {static_cast<std::uint32_t>(kParts),
                                            static_cast<std::uint32_t>(rate * kParts)};
    calls_.ioctl(file_, VIDIOC_S_PARM, &parameters);
  }
  parameters = {};
  parameters.type = kCapture;
  if (calls_.ioctl(file_, VIDIOC_G_PARM, &parameters) < 0) return;
  const v4l2_fract period = parameters.parm.capture.timeperframe;
  if (period.numerator > 0) mode_.rate = static_cast<double>(period.denominator) / period.numerator;
}

void CameraDevice::listControls() {
  v4l2_queryctrl control{};
  control.id = V4L2_CTRL_FLAG_NEXT_CTRL;
  for (std::uint32_t i = 0; i < kMaxListed && calls_.ioctl(file_, VIDIOC_QUERYCTRL, &control) == 0; ++i) {
    const bool isNumber = control.type == V4L2_CTRL_TYPE_INTEGER || control.type == V4L2_CTRL_TYPE_BOOLEAN ||
                          control.type == V4L2_CTRL_TYPE_MENU;
    if (isNumber && (control.flags & (V4L2_CTRL_FLAG_DISABLED | V4L2_CTRL_FLAG_READ_ONLY)) == 0) {
      const std::string title = textIn(control.name);
      controls_.push_back({control.id, controlName(title), title, control.minimum, control.maximum,
                           control.step, control.default_value, control.default_value});
    }
    control.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
  }
}

void CameraDevice::refresh() {
  for (Control& control : controls_) {
    v4l2_control now{control.id, 0};
    if (calls_.ioctl(file_, VIDIOC_G_CTRL, &now) == 0) control.value = now.value;
  }
}

Result<void> CameraDevice::mapBuffers() {
  v4l2_requestbuffers request{};
  request.count = kBuffers;
  request.type = kCapture;
  request.memory = V4L2_MEMORY_MMAP;
  if (calls_.ioctl(file_, VIDIOC_REQBUFS, &request) < 0 || request.count == 0)
    return tl::unexpected(failed("the camera gives no memory for images"));
  for (std::uint32_t i = 0; i < std::min(request.count, kBuffers); ++i) {
    v4l2_buffer buffer{};
    buffer.index = i;
    buffer.type = kCapture;
    buffer.memory = V4L2_MEMORY_MMAP;
    if (calls_.ioctl(file_, VIDIOC_QUERYBUF, &buffer) < 0)
      return tl::unexpected(failed("the camera gives no memory for images"));
    void* memory = calls_.map(file_, buffer.length, buffer.m.offset);
    if (memory == nullptr) return tl::unexpected(failed("the camera's memory cannot be mapped"));
    buffers_.push_back({memory, buffer.length});
    if (calls_.ioctl(file_, VIDIOC_QBUF, &buffer) < 0)
      return tl::unexpected(failed("the camera takes no memory for images"));
  }
  return {};
}

Result<std::optional<Image>> CameraDevice::next(int milliseconds) {
  const int ready = calls_.wait(file_, milliseconds);
  if (ready == 0) return std::optional<Image>();
  v4l2_buffer newest{};
  bool any = false;
  // If several are there, only the newest one counts.
  while (true) {
    v4l2_buffer buffer{};
    buffer.type = kCapture;
    buffer.memory = V4L2_MEMORY_MMAP;
    if (calls_.ioctl(file_, VIDIOC_DQBUF, &buffer) < 0) {
      if (errno == EAGAIN && ready > 0) break;
      if (errno == EAGAIN) errno = ENODEV;
      return tl::unexpected(failed("the camera takes no images any more"));
    }
    if (buffer.index >= buffers_.size())
      return failure("camera.failed", device_ + ": the driver returned a buffer that it was not given");
    if (any && calls_.ioctl(file_, VIDIOC_QBUF, &newest) < 0)
      return tl::unexpected(failed("the camera takes no images any more"));
    newest = buffer;
    any = true;
  }
  if (!any) return std::optional<Image>();
  const Buffer& memory = buffers_[newest.index];
  const std::size_t used = std::min<std::size_t>(newest.bytesused, memory.length);
  auto image = (newest.flags & V4L2_BUF_FLAG_ERROR) != 0
                   ? Result<Image>(failure("camera.damaged", device_ + ": an image is damaged"))
                   : decode({static_cast<const std::uint8_t*>(memory.memory), used});
  if (calls_.ioctl(file_, VIDIOC_QBUF, &newest) < 0)
    return tl::unexpected(failed("the camera takes no images any more"));
  if (!image) return tl::unexpected(image.error());
  return std::optional<Image>(std::move(*image));
}

Result<Image> CameraDevice::decode(std::span<const std::uint8_t> bytes) const {
  const auto found = std::ranges::find_if(
      kDecodable, [&](const Decodable& one) { return lettersOf(one.code) == mode_.format; });
  if (!found->pixels) {
    auto image = logplayer::decodeJpeg(bytes);
    if (!image) return failure("camera.damaged", device_ + ": an image is damaged: " + image.error().text);
    return image;
  }
  const int rows = robotlink::rowsOf(*found->pixels, mode_.height);
  Image image(mode_.width, mode_.height, *found->pixels);
  const auto length = static_cast<std::size_t>(image.step());
  const auto step = static_cast<std::size_t>(step_);
  if (bytes.size() < step * static_cast<std::size_t>(rows - 1) + length)
    return failure("camera.damaged",
                   device_ + ": an image has only " + std::to_string(bytes.size()) + " bytes");
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
    std::memcpy(image.data.data() + row * length, bytes.data() + row * step, length);
  return image;
}

Result<const CameraDevice::Control*> CameraDevice::find(const std::string& control) const {
  const auto found = std::ranges::find(controls_, control, &Control::name);
  if (found != controls_.end()) return &*found;
  std::string names;
  for (const Control& each : controls_) names += (names.empty() ? "" : ", ") + each.name;
  return failure("camera.control", device_ + " (" + title_ + ") has no control " + control + "; it has " +
                                       (names.empty() ? "none" : names));
}

Result<void> CameraDevice::set(const std::string& control, std::int32_t value) {
  const auto found = find(control);
  if (!found) return tl::unexpected(found.error());
  if (value < (*found)->minimum || value > (*found)->maximum) {
    return failure("camera.control", device_ + ": " + control + " is " + std::to_string((*found)->minimum) +
                                         " to " + std::to_string((*found)->maximum) + ", not " +
                                         std::to_string(value));
  }
  v4l2_control wanted{(*found)->id, value};
  if (calls_.ioctl(file_, VIDIOC_S_CTRL, &wanted) < 0)
    return tl::unexpected(
        failed(control + " cannot be set; another control may have to be changed to manual first"));
  return {};
}

std::vector<std::pair<std::string, std::string>> camerasHere(VideoCalls& calls) {
  constexpr int kMaxDevices = 64;
  std::vector<std::pair<std::string, std::string>> cameras;
  for (int i = 0; i < kMaxDevices; ++i) {
    const std::string device = "/dev/video" + std::to_string(i);
    const int file = calls.open(device.c_str());
    if (file < 0) continue;
    v4l2_capability about{};
    const bool known = calls.ioctl(file, VIDIOC_QUERYCAP, &about) == 0;
    const std::uint32_t can =
        (about.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? about.device_caps : about.capabilities;
    if (known && (can & V4L2_CAP_VIDEO_CAPTURE) != 0) cameras.emplace_back(device, textIn(about.card));
    calls.close(file);
  }
  return cameras;
}

}  // namespace app
