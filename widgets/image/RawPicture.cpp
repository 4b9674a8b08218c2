// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/RawPicture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

#include "foxglove/Image.pb.h"
#include "robotlink/packages/Conversions.h"

namespace widgets {
namespace {

/// The farthest is not as black as what is no depth.
constexpr double kFarShade = 40, kBrightest = 255;

/// A channel of numbers, little-endian, as an encoding has it. It owns nothing.
class Channel {
 public:
  /// Empty if the encoding is another one, or if the data do not fit.
  static std::optional<Channel> of(const foxglove::RawImage& image) {
    constexpr std::uint32_t kMaxSide = 1U << 15U;
    Channel channel;
    const std::string_view encoding = image.encoding();
    channel.isFloat_ = encoding == "32FC1";
    channel.isDepth_ = channel.isFloat_ || encoding == "16UC1";
    if (!channel.isDepth_ && encoding != "mono16") return std::nullopt;
    const std::size_t rowBytes = image.width() * channel.valueSize(), rows = image.height();
    if (rowBytes == 0 || rows == 0 || image.width() > kMaxSide || rows > kMaxSide ||
        image.step() < rowBytes || image.data().size() < image.step() * (rows - 1) + rowBytes)
      return std::nullopt;
    channel.width_ = static_cast<int>(image.width());
    channel.height_ = static_cast<int>(image.height());
    channel.step_ = image.step();
    channel.data_ = image.data().data();
    return channel;
  }
  int width() const { return width_; }
  int height() const { return height_; }
  /// In m; else these are brightnesses.
  bool isDepth() const { return isDepth_; }
  /// NaN: none.
  double at(int x, int y) const {
    const char* from =
        data_ + static_cast<std::size_t>(y) * step_ + static_cast<std::size_t>(x) * valueSize();
    if (isFloat_) {
      float value = 0;
      std::memcpy(&value, from, sizeof value);
      return std::isfinite(value) ? static_cast<double>(value) : std::nan("");
    }
    std::uint16_t value = 0;
    std::memcpy(&value, from, sizeof value);
    if (!isDepth_) return value;
    return value == 0 ? std::nan("") : value / 1000.0;
  }

 private:
  std::size_t valueSize() const { return isFloat_ ? sizeof(float) : sizeof(std::uint16_t); }

  int width_ = 0, height_ = 0;
  std::size_t step_ = 0;
  const char* data_ = nullptr;
  bool isFloat_ = false, isDepth_ = false;
};

QImage draw(const Channel& channel) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (int y = 0; y < channel.height(); ++y) {
    for (int x = 0; x < channel.width(); ++x) {
      const double value = channel.at(x, y);
      if (std::isnan(value)) continue;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  const double first = channel.isDepth() ? kBrightest : 0, last = channel.isDepth() ? kFarShade : kBrightest;
  const double scale = highest > lowest ? (last - first) / (highest - lowest) : 0;
  QImage image(channel.width(), channel.height(), QImage::Format_RGB32);
  for (int y = 0; y < channel.height(); ++y) {
    auto* to = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < channel.width(); ++x) {
      const double value = channel.at(x, y);
      const int gray =
          std::isnan(value) ? 0 : static_cast<int>(std::lround(first + (value - lowest) * scale));
      to[x] = qRgb(gray, gray, gray);
    }
  }
  return image;
}

}  // namespace

QImage rawPicture(const foxglove::RawImage& image, std::span<const robotlink::Rgb> classColors) {
  if (const auto channel = Channel::of(image)) return draw(*channel);
  return toQImage(robotlink::imageView(image), classColors);
}

std::optional<PixelValue> rawPixel(const foxglove::RawImage& image, int x, int y) {
  const auto channel = Channel::of(image);
  if (!channel) return pixelAt(robotlink::imageView(image), x, y);
  if (x < 0 || y < 0 || x >= channel->width() || y >= channel->height()) return std::nullopt;
  PixelValue pixel{x, y, {}, {}, {}, {}};
  if (channel->isDepth()) {
    pixel.depth = channel->at(x, y);
  } else {
    pixel.value = static_cast<int>(channel->at(x, y));
  }
  return pixel;
}

}  // namespace widgets
