// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/CircleBallFinder.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace modules {
namespace {

using colortool::Region;
using robotlink::ImageView;
using robotlink::Vector2;

/// Cb and Cr relative to Y. The offset keeps noise in dark pixels small.
Vector2 tint(const ImageView& image, int x, int y) {
  const robotlink::YCbCr color = robotlink::yuyvPixel(image, x, y);
  const double scale = 1.0 / (color.y + 8.0);
  return {(color.cb - 128) * scale, (color.cr - 128) * scale};
}

/// The mean tint around the center of a region.
Vector2 meanTint(const ImageView& image, const Region& region) {
  const int reach = std::clamp(std::min(region.width(), region.height()) / 4, 0, 4);
  const int x0 = static_cast<int>(region.centerX), y0 = static_cast<int>(region.centerY);
  Vector2 sum = Vector2::Zero();
  int count = 0;
  for (int y = std::max(0, y0 - reach); y <= std::min(image.height - 1, y0 + reach); ++y)
    for (int x = std::max(0, x0 - reach); x <= std::min(image.width - 1, x0 + reach); ++x, ++count)
      sum += tint(image, x, y);
  return count > 0 ? Vector2(sum / count) : sum;
}

std::optional<BallDisc> circleThrough(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Vector2 ab = b - a, ac = c - a;
  const double cross = 2 * (ab.x() * ac.y() - ab.y() * ac.x());
  if (std::abs(cross) < 1e-6) return std::nullopt;
  const double ab2 = ab.squaredNorm(), ac2 = ac.squaredNorm();
  const Vector2 middle((ac.y() * ab2 - ab.y() * ac2) / cross, (ab.x() * ac2 - ac.x() * ab2) / cross);
  return BallDisc{a + middle, middle.norm(), 0.5};
}

}  // namespace

void CircleBallFinder::scanEdge(const ImageView& image, const Region& region) {
  edge_.clear();
  const Vector2 start(region.centerX, region.centerY);
  const Vector2 reference = meanTint(image, region);
  constexpr double kStep = 0.5;
  for (int ray = 0; ray < options_.rays; ++ray) {
    const double angle = 2 * robotlink::kPi * ray / options_.rays;
    const Vector2 direction(std::cos(angle), std::sin(angle));
    double before = 0;
    int outside = 0;
    for (double length = 0; outside < 3; length += kStep) {
      const Vector2 at = start + direction * length;
      if (at.x() < 0 || at.y() < 0 || at.x() >= image.width || at.y() >= image.height) break;
      const double difference =
          (tint(image, static_cast<int>(at.x()), static_cast<int>(at.y())) - reference).norm();
      outside = difference > options_.colorDifference ? outside + 1 : 0;
      if (outside == 0) before = length;
    }
    // The pixel on the edge is mixed and thus counts as outside; the edge is at its center.
    if (outside == 3) edge_.push_back({start + direction * (before + kStep)});
  }
}

int CircleBallFinder::countFollowers(const BallDisc& disc) const {
  return static_cast<int>(std::ranges::count_if(edge_, [&](const EdgePoint& point) {
    return std::abs((point.at - disc.center).norm() - disc.radius) <= options_.tolerance;
  }));
}

bool CircleBallFinder::refine(BallDisc& disc) const {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const Vector2 origin = disc.center;
  int count = 0;
  for (const EdgePoint& point : edge_) {
    const Vector2 p = point.at - origin;
    if (std::abs(p.norm() - disc.radius) > options_.tolerance) continue;
    const Eigen::Vector3d row(p.x(), p.y(), 1);
    normal += row * row.transpose();
    right += row * p.squaredNorm();
    ++count;
  }
  if (count < 4) return false;
  const Eigen::Vector3d solution = normal.ldlt().solve(right);
  const Vector2 middle = 0.5 * solution.head<2>();
  const double square = solution.z() + middle.squaredNorm();
  if (!(square > 0)) return false;
  disc.center = origin + middle;
  disc.radius = std::sqrt(square);
  return true;
}

std::optional<BallDisc> CircleBallFinder::fitCircle() {
  const std::size_t count = edge_.size();
  if (count < 5) return std::nullopt;
  BallDisc best;
  int followers = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t apart = std::max<std::size_t>(1, count / 6); apart <= count / 3; apart += 2) {
      const auto disc =
          circleThrough(edge_[i].at, edge_[(i + apart) % count].at, edge_[(i + 2 * apart) % count].at);
      if (!disc) continue;
      const int votes = countFollowers(*disc);
      if (votes > followers) {
        followers = votes;
        best = *disc;
      }
    }
  }
  const double needed = std::max(6.0, options_.minimumInliers * static_cast<double>(count));
  if (followers < needed || !refine(best) || !refine(best)) return std::nullopt;
  for (EdgePoint& point : edge_)
    point.onCircle = std::abs((point.at - best.center).norm() - best.radius) <= options_.tolerance;
  // Half a circle determines its radius well, a short arc badly.
  const double arc = static_cast<double>(countFollowers(best)) / options_.rays;
  best.radiusDeviation = 0.4 + (arc < 0.6 ? (0.6 - arc) * best.radius : 0);
  return best;
}

BallObservation CircleBallFinder::find(const ImageView& image, std::span<const Region> regions,
                                       const CameraView& view) {
  BallObservation best;
  foundEdge_.clear();
  if (image.empty() || image.format != robotlink::PixelFormat::kYuyv) return best;
  double bestScore = 0;
  for (const Region& region :
       regions.first(std::min(regions.size(), static_cast<std::size_t>(options_.candidates)))) {
    if (region.area < options_.minimumArea) continue;
    scanEdge(image, region);
    const auto disc = fitCircle();
    if (!disc) continue;
    auto ball = geometry_.locate(*disc, view);
    if (!ball) continue;
    ball->confidence *= static_cast<double>(countFollowers(*disc)) / options_.rays;
    const double score = ball->confidence * disc->radius;
    if (score <= bestScore) continue;
    bestScore = score;
    best = *ball;
    foundEdge_ = edge_;
  }
  return best;
}

}  // namespace modules
