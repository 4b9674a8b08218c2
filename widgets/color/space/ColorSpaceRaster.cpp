// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceRaster.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

using Eigen::Vector3f;
using Pixel = ColorSpaceRaster::Pixel;

/// Twice the signed area of a triangle in the picture.
float area(const Vector3f& a, const Vector3f& b, float x, float y) {
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

int pixelOf(float value, int end) {
  return static_cast<int>(std::clamp(value, -1.F, static_cast<float>(end)));
}

/// A premultiplied color, or a sum of several; channels 0 to 255 for a single one.
struct Shade {
  unsigned r = 0, g = 0, b = 0, alpha = 0;

  void add(const Shade& other) {
    r += other.r;
    g += other.g;
    b += other.b;
    alpha += other.alpha;
  }
  QRgb mean(unsigned count) const {
    return qRgba(int(r / count), int(g / count), int(b / count), int(alpha / count));
  }
};

Shade shadeOf(QRgb color) {
  return {unsigned(qRed(color)), unsigned(qGreen(color)), unsigned(qBlue(color)), 255};
}

/// `opacity` from 0 to 256.
Shade over(QRgb upper, const Shade& lower, unsigned opacity) {
  const unsigned rest = 256 - opacity;
  return {(unsigned(qRed(upper)) * opacity + lower.r * rest) >> 8U,
          (unsigned(qGreen(upper)) * opacity + lower.g * rest) >> 8U,
          (unsigned(qBlue(upper)) * opacity + lower.b * rest) >> 8U,
          (255 * opacity + lower.alpha * rest) >> 8U};
}

Shade shadeOf(const Pixel& solid, const Pixel& surface, unsigned opacity) {
  const bool hasSolid = solid.cell != ColorSpaceRaster::kNoCell;
  const bool hasSurface = surface.cell != ColorSpaceRaster::kNoCell && surface.depth < solid.depth;
  const Shade lower = hasSolid ? shadeOf(solid.color) : Shade{};
  return hasSurface ? over(surface.color, lower, opacity) : lower;
}

std::uint32_t cellOf(const Pixel& solid, const Pixel& surface, unsigned opacity) {
  const bool seesThrough = opacity < 128 && solid.cell != ColorSpaceRaster::kNoCell;
  return seesThrough || solid.depth < surface.depth ? solid.cell : surface.cell;
}

}  // namespace

void ColorSpaceRaster::reset(QSize size) {
  width_ = size.width();
  height_ = size.height();
  pixels_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Pixel{});
}

void ColorSpaceRaster::disc(const Vector3f& center, int diameter, QRgb color, std::uint32_t cell) {
  const float radius = static_cast<float>(diameter) / 2;
  const int left = pixelOf(std::round(center.x() - radius), width_),
            top = pixelOf(std::round(center.y() - radius), height_);
  const int right = std::min(left + diameter, width_), bottom = std::min(top + diameter, height_);
  for (int y = std::max(0, top); y < bottom; ++y) {
    for (int x = std::max(0, left); x < right; ++x) {
      if (diameter > 4) {
        const float dx = static_cast<float>(x - left) + 0.5F - radius,
                    dy = static_cast<float>(y - top) + 0.5F - radius;
        if (dx * dx + dy * dy > radius * radius) continue;
      }
      Pixel& pixel = pixels_[indexOf(x, y)];
      if (center.z() < pixel.depth) pixel = {center.z(), color, cell};
    }
  }
}

void ColorSpaceRaster::quad(const std::array<Vector3f, 4>& corners, QRgb color, std::uint32_t cell) {
  triangle(corners[0], corners[1], corners[2], color, cell);
  triangle(corners[0], corners[2], corners[3], color, cell);
}

void ColorSpaceRaster::triangle(const Vector3f& a, const Vector3f& b, const Vector3f& c, QRgb color,
                                std::uint32_t cell) {
  // y points down, so counterclockwise triangles have a negative area.
  const float whole = -area(a, b, c.x(), c.y());
  if (!(whole > 1e-6F)) return;
  const auto [leftmost, rightmost] = std::minmax({a.x(), b.x(), c.x()});
  const auto [highest, lowest] = std::minmax({a.y(), b.y(), c.y()});
  const int left = std::max(0, pixelOf(std::ceil(leftmost - 0.5F), width_)),
            right = std::min(width_ - 1, pixelOf(std::floor(rightmost - 0.5F), width_));
  const int top = std::max(0, pixelOf(std::ceil(highest - 0.5F), height_)),
            bottom = std::min(height_ - 1, pixelOf(std::floor(lowest - 0.5F), height_));
  // Barycentric coordinates, and how they change from pixel to pixel.
  const float scale = -1 / whole;
  const float stepA = -(c.y() - b.y()) * scale, stepB = -(a.y() - c.y()) * scale;
  for (int y = top; y <= bottom; ++y) {
    const float atX = static_cast<float>(left) + 0.5F, atY = static_cast<float>(y) + 0.5F;
    float ofA = area(b, c, atX, atY) * scale, ofB = area(c, a, atX, atY) * scale;
    Pixel* pixel = &pixels_[indexOf(left, y)];
    for (int x = left; x <= right; ++x, ++pixel, ofA += stepA, ofB += stepB) {
      const float ofC = 1 - ofA - ofB;
      if (ofA < 0 || ofB < 0 || ofC < 0) continue;
      const float depth = ofA * a.z() + ofB * b.z() + ofC * c.z();
      if (depth < pixel->depth) *pixel = {depth, color, cell};
    }
  }
}

ColorSpaceLayers compose(const ColorSpaceRaster& solid, const ColorSpaceRaster& surfaces, double opacity,
                         int reduction) {
  const QSize size = solid.size() / reduction;
  const auto opaque = static_cast<unsigned>(std::lround(256 * std::clamp(opacity, 0.0, 1.0)));
  ColorSpaceLayers result{QImage(size, QImage::Format_ARGB32_Premultiplied), {}};
  result.cells.reserve(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()));
  for (int y = 0; y < size.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(result.image.scanLine(y));
    for (int x = 0; x < size.width(); ++x) {
      Shade sum;
      for (int i = 0; i < reduction * reduction; ++i) {
        const int fromX = x * reduction + i % reduction, fromY = y * reduction + i / reduction;
        sum.add(shadeOf(solid.at(fromX, fromY), surfaces.at(fromX, fromY), opaque));
      }
      row[x] = sum.mean(static_cast<unsigned>(reduction * reduction));
      const Pixel& first = solid.at(x * reduction, y * reduction);
      result.cells.push_back(cellOf(first, surfaces.at(x * reduction, y * reduction), opaque));
    }
  }
  return result;
}

}  // namespace widgets
