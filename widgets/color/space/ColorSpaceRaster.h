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

/// A frame buffer with depth: pixels with a color, a distance and the cell of the color table that they show;
/// what is nearer hides what is farther. Places are as ColorSpaceProjection returns them. Not thread-safe.
class ColorSpaceRaster {
 public:
  /// Cell of pixels that show nothing.
  static constexpr std::uint32_t kNoCell = std::numeric_limits<std::uint32_t>::max();

  /// Sets the size in pixels and clears all pixels.
  void reset(QSize size);
  QSize size() const { return {width_, height_}; }

  /// Draws a disc of constant depth, in pixels; up to a diameter of 4 it is a square.
  void disc(const Eigen::Vector3f& center, int diameter, QRgb color, std::uint32_t cell);
  /// Draws a quadrilateral, which is visible only if its corners are counterclockwise in the picture.
  void quad(const std::array<Eigen::Vector3f, 4>& corners, QRgb color, std::uint32_t cell);

  /// The contents of a pixel.
  struct Pixel {
    /// Distance from the viewer.
    float depth = std::numeric_limits<float>::max();
    QRgb color = 0;
    std::uint32_t cell = kNoCell;
  };
  /// x and y must be inside.
  const Pixel& at(int x, int y) const { return pixels_[indexOf(x, y)]; }

 private:
  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  /// Draws a triangle with interpolated depth; clockwise ones are skipped.
  void triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c, QRgb color,
                std::uint32_t cell);

  int width_ = 0, height_ = 0;
  std::vector<Pixel> pixels_;
};

/// Two rasters in one picture.
struct ColorSpaceLayers {
  /// ARGB32_Premultiplied, transparent where nothing is.
  QImage image;
  /// The cell of each pixel of the image, or ColorSpaceRaster::kNoCell.
  std::vector<std::uint32_t> cells;
};
/// Blends `surfaces` with `opacity` (0 to 1) over what of `solid` is behind them; both have the same size.
/// Each pixel of the image is the mean of `reduction` x `reduction` pixels, of which the sides must be
/// multiples. The cell is that of `solid` where it is visible through a surface of less than half opacity.
ColorSpaceLayers compose(const ColorSpaceRaster& solid, const ColorSpaceRaster& surfaces, double opacity,
                         int reduction);

}  // namespace widgets
