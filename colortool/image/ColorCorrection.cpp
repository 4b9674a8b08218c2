// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorCorrection.h"

#include <algorithm>
#include <cmath>

namespace colortool {
namespace {

std::uint8_t toValue(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

double curve(const std::array<double, 2>& coefficients, double squaredRadius) {
  return (coefficients[0] + coefficients[1] * squaredRadius) * squaredRadius;
}

ChannelLine limited(double gain, double offset) {
  return {std::clamp(gain, -ColorCorrection::kMaxGain, ColorCorrection::kMaxGain),
          std::clamp(offset, -ColorCorrection::kMaxOffset, ColorCorrection::kMaxOffset)};
}

ChannelLine chromaLine(const ChannelLine& channel, const std::array<double, 2>& tint, double squaredRadius) {
  return limited(channel.gain, channel.offset - channel.gain * curve(tint, squaredRadius));
}

}  // namespace

double squaredImageRadius(double x, double y, int width, int height) {
  const double fromCenterX = x - (width - 1) / 2.0, fromCenterY = y - (height - 1) / 2.0;
  return 4 * (fromCenterX * fromCenterX + fromCenterY * fromCenterY) /
         (double{1} * width * width + double{1} * height * height);
}

bool ColorCorrection::isFinite() const {
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::ranges::all_of(vignetting.luma, finite) && std::ranges::all_of(vignetting.blue, finite) &&
         std::ranges::all_of(vignetting.red, finite) &&
         std::ranges::all_of(
             channels, [&](const ChannelLine& line) { return finite(line.gain) && finite(line.offset); });
}

ChannelLine ColorCorrection::lumaAt(double squaredRadius) const {
  const double shade = std::clamp(1 + curve(vignetting.luma, squaredRadius), kMinShade, kMaxShade);
  return limited(channels[0].gain / shade, channels[0].offset);
}

ChannelLine ColorCorrection::blueAt(double squaredRadius) const {
  return chromaLine(channels[1], vignetting.blue, squaredRadius);
}

ChannelLine ColorCorrection::redAt(double squaredRadius) const {
  return chromaLine(channels[2], vignetting.red, squaredRadius);
}

robotlink::YCbCr ColorCorrection::apply(robotlink::YCbCr color, int x, int y, int width, int height) const {
  const double squaredRadius = squaredImageRadius(x, y, width, height);
  return {toValue(lumaAt(squaredRadius).of(color.y)), toValue(blueAt(squaredRadius).of(color.cb)),
          toValue(redAt(squaredRadius).of(color.cr))};
}

}  // namespace colortool
