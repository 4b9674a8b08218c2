// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/Stereogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "robotlink/base/Random.h"

namespace widgets {
namespace {

/// The depth of the picture, as a share of the distance to its far plane.
constexpr double kDepth = 1.0 / 3;

/// The distance of the two points that show one point at a depth (0 far to 1 near), for eyes this far apart;
/// in pixels.
int separation(double depth, double eyes) {
  return static_cast<int>(std::lround((1 - kDepth * depth) * eyes / (2 - kDepth * depth)));
}

/// Links each pixel of a row to one at its right that must look alike, or to itself.
void linkRow(const std::vector<double>& depths, double eyes, std::vector<int>& same) {
  const int width = static_cast<int>(depths.size());
  std::iota(same.begin(), same.end(), 0);
  for (int x = 0; x < width; ++x) {
    const double depth = depths[static_cast<std::size_t>(x)];
    const int apart = separation(depth, eyes);
    int left = x - apart / 2, right = left + apart;
    if (left < 0 || right >= width) continue;
    // Hidden from one eye by something nearer.
    bool isVisible = true;
    double behind = 0;
    for (int t = 1; isVisible && behind < 1; ++t) {
      behind = depth + 2 * (2 - kDepth * depth) * t / (kDepth * eyes);
      const auto depthAt = [&](int at) {
        return at >= 0 && at < width ? depths[static_cast<std::size_t>(at)] : 0.0;
      };
      isVisible = depthAt(x - t) < behind && depthAt(x + t) < behind;
    }
    if (!isVisible) continue;
    for (int next = same[static_cast<std::size_t>(left)]; next != left && next != right;
         next = same[static_cast<std::size_t>(left)]) {
      if (next < right) {
        left = next;
      } else {
        left = right;
        right = next;
      }
    }
    same[static_cast<std::size_t>(left)] = right;
  }
}

}  // namespace

QImage stereogram(const QImage& near) {
  constexpr int kMinEyes = 32, kMaxEyes = 240;
  if (near.isNull()) return {};
  const QImage gray = near.convertToFormat(QImage::Format_RGB32);
  const int width = gray.width();
  const double eyes = std::clamp(width / 3, kMinEyes, kMaxEyes);
  QImage result(gray.size(), QImage::Format_RGB32);
  std::vector<double> depths(static_cast<std::size_t>(width));
  std::vector<int> same(depths.size());
  for (int y = 0; y < gray.height(); ++y) {
    const auto* from = reinterpret_cast<const QRgb*>(gray.constScanLine(y));
    for (int x = 0; x < width; ++x) depths[static_cast<std::size_t>(x)] = qGray(from[x]) / 255.0;
    linkRow(depths, eyes, same);
    auto* to = reinterpret_cast<QRgb*>(result.scanLine(y));
    for (int x = width - 1; x >= 0; --x) {
      const int like = same[static_cast<std::size_t>(x)];
      const auto place =
          static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width) + static_cast<std::uint64_t>(x);
      const int random = robotlink::mixBits(place + 1) % 2 == 0 ? 0 : 255;
      to[x] = like == x ? qRgb(random, random, random) : to[like];
    }
  }
  return result;
}

QImage inGray(const QImage& image) {
  QImage result = image.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < result.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(result.scanLine(y));
    for (int x = 0; x < result.width(); ++x) {
      const int gray = qGray(row[x]);
      row[x] = qRgb(gray, gray, gray);
    }
  }
  return result;
}

}  // namespace widgets
