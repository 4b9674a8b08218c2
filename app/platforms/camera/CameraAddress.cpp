// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/CameraAddress.h"

#include <fmt/format.h>

#include <string_view>

#include "robotlink/base/ParsedNumber.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;

constexpr std::string_view kScheme = "camera://";
constexpr std::string_view kShort = "/dev/video";
constexpr int kMaxSide = 8192;
constexpr double kMaxRate = 1000;

Result<void> wrong(const std::string& source, const std::string& what) {
  return failure("camera.address",
                 "\"" + source + "\": " + what +
                     "; an address is camera:///dev/video0?size=640x480&rate=30&format=YUYV");
}

bool readSize(std::string_view text, CameraAddress& to) {
  const std::size_t cross = text.find('x');
  if (cross == text.npos) return false;
  const auto width = robotlink::parsedNumber<int>(text.substr(0, cross));
  const auto height = robotlink::parsedNumber<int>(text.substr(cross + 1));
  if (!width || !height || *width < 1 || *height < 1 || *width > kMaxSide || *height > kMaxSide) return false;
  to.width = *width;
  to.height = *height;
  return true;
}

/// Reads one "name=value".
Result<void> readOption(const std::string& source, std::string_view option, CameraAddress& to) {
  const std::size_t equals = option.find('=');
  const std::string name(option.substr(0, equals));
  const std::string_view value = equals == option.npos ? "" : option.substr(equals + 1);
  if (name == "size") {
    return readSize(value, to) ? Result<void>()
                               : wrong(source, "a size is WIDTHxHEIGHT, 1 to 8192 pixels each");
  }
  if (name == "rate") {
    const auto rate = robotlink::parsedNumber<double>(value);
    if (!rate || !(*rate > 0 && *rate <= kMaxRate))
      return wrong(source, "a rate is above 0 and at most 1000 per second");
    to.rate = *rate;
    return {};
  }
  if (name == "format") {
    if (value.size() != 4) return wrong(source, "a format has four letters, such as YUYV or MJPG");
    to.format = value;
    return {};
  }
  const auto number = robotlink::parsedNumber<int>(value);
  if (name.empty() || !number)
    return wrong(source, "the value of the control \"" + name + "\" is a whole number");
  to.controls[name] = *number;
  return {};
}

}  // namespace

bool isCameraAddress(const std::string& source) {
  return source.starts_with(kScheme) || source.starts_with(kShort);
}

Result<CameraAddress> parseCameraAddress(const std::string& source) {
  std::string_view rest = source;
  if (rest.starts_with(kScheme)) rest.remove_prefix(kScheme.size());
  const std::size_t question = rest.find('?');
  CameraAddress address{.device = std::string(rest.substr(0, question))};
  if (!address.device.starts_with('/') || address.device.size() < 2)
    return tl::unexpected(wrong(source, "there is no device").error());
  rest = question == rest.npos ? "" : rest.substr(question + 1);
  while (!rest.empty()) {
    const std::size_t end = rest.find('&');
    if (auto read = readOption(source, rest.substr(0, end), address); !read)
      return tl::unexpected(read.error());
    rest = end == rest.npos ? "" : rest.substr(end + 1);
  }
  return address;
}

std::string toString(const CameraAddress& address) {
  std::string text = std::string(kScheme) + address.device;
  char separator = '?';
  const auto add = [&](const std::string& option) { text += std::exchange(separator, '&') + option; };
  if (address.width > 0) add(fmt::format("size={}x{}", address.width, address.height));
  if (address.rate > 0) add(fmt::format("rate={}", address.rate));
  if (!address.format.empty()) add("format=" + address.format);
  for (const auto& [name, value] : address.controls) add(fmt::format("{}={}", name, value));
  return text;
}

}  // namespace app
