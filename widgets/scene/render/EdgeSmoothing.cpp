// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/EdgeSmoothing.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace widgets {
namespace {

constexpr int kMinContrast = 20;      // of 255; smaller differences are no edge
constexpr int kShareOfBrightest = 8;  // nor are differences below this fraction of the brightest pixel around
constexpr int kReach = 14;            // pixels searched along an edge in each direction

/// The brightness of all pixels, 0 to 255.
std::vector<std::uint8_t> brightnessOf(const QImage& picture) {
  const int width = picture.width(), height = picture.height();
  std::vector<std::uint8_t> result(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const auto* from = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
    std::uint8_t* to = result.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x) {
      const std::uint32_t rgb = from[x];
      to[x] = static_cast<std::uint8_t>(
          (77 * ((rgb >> 16) & 255U) + 151 * ((rgb >> 8) & 255U) + 28 * (rgb & 255U)) >> 8);
    }
  }
  return result;
}

/// The contrast of pixels with their four neighbors, for a row that is not at the picture's border.
void findContrasts(const std::uint8_t* row, std::ptrdiff_t width, std::uint8_t* contrasts) {
  for (std::ptrdiff_t x = 1; x < width - 1; ++x) {
    const std::uint8_t center = row[x], left = row[x - 1], right = row[x + 1], above = row[x - width],
                       below = row[x + width];
    const std::uint8_t most = std::max(center, std::max(std::max(left, right), std::max(above, below)));
    const std::uint8_t least = std::min(center, std::min(std::min(left, right), std::min(above, below)));
    const auto difference = static_cast<std::uint8_t>(most - least);
    contrasts[x] =
        static_cast<std::uint8_t>((difference >= kMinContrast) & (difference > most / kShareOfBrightest));
  }
}

/// A pixel at an edge: the direction of the neighbor across it, and that neighbor's share in the pixel.
struct Mixture {
  std::ptrdiff_t across = 0;
  int share = 0;  ///< of 256
};

class EdgeFinder {
 public:
  EdgeFinder(const std::uint8_t* brightness, int width, int height)
      : at_(brightness), width_(width), height_(height) {}

  Mixture mixtureAt(int x, int y) const {
    const std::ptrdiff_t w = width_;
    const std::uint8_t* p = at_ + y * w + x;
    const int alongRow = std::abs(p[-w - 1] + p[w - 1] - 2 * p[-1]) + 2 * std::abs(p[-w] + p[w] - 2 * p[0]) +
                         std::abs(p[-w + 1] + p[w + 1] - 2 * p[1]);
    const int alongColumn = std::abs(p[-w - 1] + p[-w + 1] - 2 * p[-w]) +
                            2 * std::abs(p[-1] + p[1] - 2 * p[0]) + std::abs(p[w - 1] + p[w + 1] - 2 * p[w]);
    const bool isRow = alongRow >= alongColumn;
    const std::ptrdiff_t across = isRow ? w : 1, along = isRow ? 1 : w;
    const int before = std::abs(p[-across] - p[0]), after = std::abs(p[across] - p[0]);
    const std::ptrdiff_t side = before >= after ? -across : across;
    const int room[2] = {isRow ? x : y, isRow ? width_ - 1 - x : height_ - 1 - y};
    return {side, shareOf(p, side, along, std::max(before, after), room)};
  }

 private:
  struct End {
    int distance = 0;
    int change = 0;  ///< change of the brightness along the edge up to its end
  };

  /// Finds the end of the edge between a pixel and its neighbor across. Brightness on the edge is the sum of
  /// both pixels, that is, twice their mean.
  static End endOf(const std::uint8_t* p, std::ptrdiff_t side, std::ptrdiff_t step, int here, int gradient,
                   int room) {
    End end;
    const int reach = std::min(kReach, room);
    for (int i = 1; i <= reach; ++i) {
      p += step;
      end = {i, p[0] + p[side] - here};
      if (2 * std::abs(end.change) >= gradient) break;
    }
    return end;
  }

  static int shareOf(const std::uint8_t* p, std::ptrdiff_t side, std::ptrdiff_t along, int gradient,
                     const int (&room)[2]) {
    const int here = p[0] + p[side];
    const End one = endOf(p, side, -along, here, gradient, room[0]),
              other = endOf(p, side, along, here, gradient, room[1]);
    const End& near = one.distance <= other.distance ? one : other;
    const int length = one.distance + other.distance;
    // An edge that does not end within reach is straight.
    if (2 * std::abs(near.change) < gradient) return 0;
    // Beyond its near end the edge continues one row further; only pixels on that side are mixed.
    const bool centerIsDarker = 2 * p[0] < here;
    if (length == 0 || (near.change < 0) == centerIsDarker) return 0;
    return 128 - 256 * near.distance / length;
  }

  const std::uint8_t* at_;
  int width_, height_;
};

/// The first pixel from `x` on that belongs to an edge; most do not.
int nextEdge(const std::vector<std::uint8_t>& contrasts, int x) {
  const auto size = contrasts.size(), from = static_cast<std::size_t>(x);
  const void* found = std::memchr(contrasts.data() + from, 1, size - from);
  if (found == nullptr) return static_cast<int>(size);
  return static_cast<int>(static_cast<const std::uint8_t*>(found) - contrasts.data());
}

QRgb mixed(QRgb a, QRgb b, int share) {
  const auto channel = [&](int shift) {
    const int from = static_cast<int>((a >> shift) & 255U), to = static_cast<int>((b >> shift) & 255U);
    return static_cast<std::uint32_t>(from + (to - from) * share / 256) << shift;
  };
  return 0xFF000000U | channel(16) | channel(8) | channel(0);
}

}  // namespace

QImage smoothEdges(const QImage& picture) {
  const int width = picture.width(), height = picture.height();
  if (width < 3 || height < 3) return picture;
  const std::vector<std::uint8_t> brightness = brightnessOf(picture);
  const EdgeFinder edges(brightness.data(), width, height);
  QImage smooth = picture.copy();
  std::vector<std::uint8_t> contrasts(static_cast<std::size_t>(width), 0);
  const std::ptrdiff_t stride = picture.bytesPerLine() / 4;
  for (int y = 1; y + 1 < height; ++y) {
    findContrasts(brightness.data() + static_cast<std::ptrdiff_t>(y) * width, width, contrasts.data());
    const auto* from = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
    auto* to = reinterpret_cast<QRgb*>(smooth.scanLine(y));
    for (int x = 1; x + 1 < width; ++x) {
      x = nextEdge(contrasts, x);
      if (x + 1 >= width) break;
      const Mixture mixture = edges.mixtureAt(x, y);
      if (mixture.share <= 0) continue;
      const bool isRow = std::abs(mixture.across) == width;
      const QRgb other = isRow ? from[x + (mixture.across > 0 ? stride : -stride)] : from[x + mixture.across];
      to[x] = mixed(from[x], other, mixture.share);
    }
  }
  return smooth;
}

}  // namespace widgets
