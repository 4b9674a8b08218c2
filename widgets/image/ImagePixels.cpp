// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImagePixels.h"

#include <QColor>
#include <array>
#include <cmath>

namespace widgets {
namespace {

using robotlink::PixelFormat;
using robotlink::Rgb;

constexpr int kFraction = 16;  // fraction bits of fixed-point numbers

/// Contributions of the chroma to the three channels (BT.601, full range) in 1/65536, and a table that clamps
/// the sums.
struct ChromaTables {
  std::array<int, 256> redOfCr{}, greenOfCb{}, greenOfCr{}, blueOfCb{};
  std::array<std::uint8_t, 1024> clamped{};  // index is the value + 384

  constexpr ChromaTables() {
    constexpr double kOne = 1 << kFraction;
    for (int i = 0; i < 256; ++i) {
      const auto at = static_cast<std::size_t>(i);
      redOfCr[at] = static_cast<int>(1.402 * kOne) * (i - 128);
      greenOfCb[at] = static_cast<int>(-0.344136 * kOne) * (i - 128);
      greenOfCr[at] = static_cast<int>(-0.714136 * kOne) * (i - 128);
      blueOfCb[at] = static_cast<int>(1.772 * kOne) * (i - 128);
    }
    for (int i = 0; i < 1024; ++i) {
      const int value = i - 384;
      clamped[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value < 0     ? 0
                                                                       : value > 255 ? 255
                                                                                     : value);
    }
  }
  std::uint8_t clamp(int fixed) const {
    const int index = ((fixed + (1 << (kFraction - 1))) >> kFraction) + 384;
    return clamped[static_cast<std::size_t>(index)];
  }
};
constexpr ChromaTables kChroma;

QRgb packedColor(int luma, int red, int green, int blue) {
  const int y = luma << kFraction;
  return qRgb(kChroma.clamp(y + red), kChroma.clamp(y + green), kChroma.clamp(y + blue));
}

void convertYuyv(const std::uint8_t* from, QRgb* to, int width) {
  for (int x = 0; x + 1 < width; x += 2, from += 4, to += 2) {
    const std::size_t cb = from[1], cr = from[3];
    const int red = kChroma.redOfCr[cr], blue = kChroma.blueOfCb[cb];
    const int green = kChroma.greenOfCb[cb] + kChroma.greenOfCr[cr];
    to[0] = packedColor(from[0], red, green, blue);
    to[1] = packedColor(from[2], red, green, blue);
  }
}

void convertRgb(const std::uint8_t* from, QRgb* to, int width) {
  for (int x = 0; x < width; ++x, from += 3) to[x] = qRgb(from[0], from[1], from[2]);
}

std::array<QRgb, 256> monoPalette(std::span<const Rgb> classColors) {
  std::array<QRgb, 256> palette{};
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const int gray = static_cast<int>(i);
    palette[i] = classColors.empty() ? qRgb(gray, gray, gray) : qRgb(0, 0, 0);
    if (i < classColors.size()) palette[i] = qRgb(classColors[i].r, classColors[i].g, classColors[i].b);
  }
  return palette;
}

}  // namespace

QImage toQImage(const robotlink::ImageView& image, std::span<const Rgb> classColors, QImage into) {
  if (image.empty()) return {};
  if (into.size() != QSize(image.width, image.height) || into.format() != QImage::Format_RGB32) {
    into = QImage(image.width, image.height, QImage::Format_RGB32);
  }
  const auto palette = monoPalette(classColors);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* from = image.row(y);
    auto* to = reinterpret_cast<QRgb*>(into.scanLine(y));
    switch (image.format) {
      case PixelFormat::kYuyv:
        convertYuyv(from, to, image.width);
        break;
      case PixelFormat::kRgb8:
        convertRgb(from, to, image.width);
        break;
      case PixelFormat::kUyvy:
      case PixelFormat::kNv12:
      case PixelFormat::kBgr8:
        for (int x = 0; x < image.width; ++x) {
          const Rgb color = robotlink::pixelRgb(image, x, y);
          to[x] = qRgb(color.r, color.g, color.b);
        }
        break;
      case PixelFormat::kMono8:
        for (int x = 0; x < image.width; ++x) to[x] = palette[from[x]];
        break;
    }
  }
  return into;
}

std::optional<PixelValue> pixelAt(const robotlink::ImageView& image, int x, int y) {
  if (image.empty() || x < 0 || y < 0 || x >= image.width || y >= image.height) return std::nullopt;
  PixelValue pixel{x, y, {}, {}, {}, {}};
  pixel.rgb = robotlink::pixelRgb(image, x, y);
  switch (image.format) {
    case PixelFormat::kYuyv:
    case PixelFormat::kUyvy:
    case PixelFormat::kNv12:
      pixel.ycbcr = robotlink::pixelYCbCr(image, x, y);
      break;
    case PixelFormat::kRgb8:
    case PixelFormat::kBgr8:
      break;
    case PixelFormat::kMono8:
      pixel.value = image.row(y)[x];
      break;
  }
  return pixel;
}

QString describe(const PixelValue& pixel, const std::string& className) {
  QString text = QStringLiteral("x %1  y %2").arg(pixel.x, 3).arg(pixel.y, 3);
  if (pixel.ycbcr) {
    text += QStringLiteral("   Y %1  Cb %2  Cr %3")
                .arg(pixel.ycbcr->y, 3)
                .arg(pixel.ycbcr->cb, 3)
                .arg(pixel.ycbcr->cr, 3);
  }
  if (pixel.depth) {
    text += std::isnan(*pixel.depth) ? QStringLiteral("   –")
                                     : QStringLiteral("   %1 m").arg(*pixel.depth, 0, 'f', 3);
  } else if (pixel.value) {
    text += QStringLiteral("   value %1").arg(*pixel.value, 3);
  } else {
    text += QStringLiteral("   R %1  G %2  B %3").arg(pixel.rgb.r, 3).arg(pixel.rgb.g, 3).arg(pixel.rgb.b, 3);
  }
  if (!className.empty()) text += QStringLiteral("   %1").arg(QString::fromStdString(className));
  return text;
}

}  // namespace widgets
