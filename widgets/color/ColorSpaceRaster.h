// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QRgb>
#include <QSize>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace widgets {

/// Pixels with a depth and with the cell of the colour table that they show: what is nearer hides what is
/// farther. Places are as ColorSpaceProjection has them. One thread.
class ColorSpaceRaster {
 public:
  static constexpr std::uint32_t kNoCell = std::numeric_limits<std::uint32_t>::max();

  /// Empties it.
  void reset(QSize size);
  QSize size() const { return {width_, height_}; }

  /// A disc, in pixels; up to four it is a square.
  void disc(const Eigen::Vector3f& center, int diameter, QRgb color, std::uint32_t cell);
  /// A face with two sides, of which only that is seen whose corners are counter-clockwise.
  void quad(const std::array<Eigen::Vector3f, 4>& corners, QRgb color, std::uint32_t cell);

  struct Pixel {
    float depth = std::numeric_limits<float>::max();
    QRgb color = 0;
    std::uint32_t cell = kNoCell;
  };
  const Pixel& at(int x, int y) const { return pixels_[indexOf(x, y)]; }

 private:
  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  void triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c, QRgb color,
                std::uint32_t cell);

  int width_ = 0, height_ = 0;
  std::vector<Pixel> pixels_;
};

/// What two rasters of one size show together.
struct ColorSpaceLayers {
  QImage image;                      ///< ARGB32_Premultiplied, transparent where nothing is
  std::vector<std::uint32_t> cells;  ///< a pixel of the image each, or ColorSpaceRaster::kNoCell
};
/// `surfaces` lie with `opacity` over what of `solid` is behind them. Each pixel of the image is the mean of
/// `reduction` x `reduction` ones; the sides are multiples of it. The cell is the solid's where it is seen
/// through a surface that is less than half opaque.
ColorSpaceLayers compose(const ColorSpaceRaster& solid, const ColorSpaceRaster& surfaces, double opacity,
                         int reduction);

}  // namespace widgets
