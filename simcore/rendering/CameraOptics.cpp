// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/CameraOptics.h"

#include <algorithm>
#include <cmath>

namespace simcore {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;

constexpr double kInstantsApart = 0.001;
// The largest tangent that a lens shows, and the most times that its pinhole image is as wide and as high.
constexpr double kWidestTangent = 4;
constexpr int kMaxTimes = 4;

/// The share of each row of an instant that is `from` to `to` before that of the image.
std::vector<float> weightsOfRows(const ShutterModel& shutter, int rows, double from, double to) {
  std::vector<float> weights(static_cast<std::size_t>(rows));
  for (int y = 0; y < rows; ++y) {
    const double end = rows > 1 ? shutter.readout * (rows - 1 - y) / (rows - 1) : 0;
    const double begin = end + shutter.exposure;
    double share = 0;
    if (shutter.exposure > 0) {
      share = std::max(0.0, std::min(to, begin) - std::max(from, end)) / shutter.exposure;
    } else {
      // The oldest row is exposed at the very end of the oldest instant.
      share = end >= from && (end < to || to >= shutter.readout) ? 1 : 0;
    }
    weights[static_cast<std::size_t>(y)] = static_cast<float>(share);
  }
  return weights;
}

bool isSame(const CameraModel& a, const CameraModel& b) {
  return a.width == b.width && a.height == b.height && a.horizontalAngle == b.horizontalAngle &&
         a.verticalAngle == b.verticalAngle && a.distortion == b.distortion;
}

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.F, 255.F));
}

/// Whether a direction is one in which the lens looks: the polynomial of a strong distortion also yields
/// places for directions beyond those that the image has, where it turns back.
bool isInFront(const LensDistortion& lens, const Eigen::Vector2d& pinhole, const Eigen::Vector2d& seen) {
  const double r2 = pinhole.squaredNorm();
  const double slope = 1 + r2 * (3 * lens.k1 + r2 * (5 * lens.k2 + r2 * 7 * lens.k3));
  return slope > 0 && pinhole.dot(seen) >= 0;
}

}  // namespace

Eigen::Vector2d CameraOptics::distorted(const LensDistortion& lens, const Eigen::Vector2d& pinhole) {
  const double x = pinhole.x(), y = pinhole.y(), r2 = pinhole.squaredNorm();
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  return {x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
          y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y};
}

Eigen::Vector2d CameraOptics::undistorted(const LensDistortion& lens, const Eigen::Vector2d& seen) {
  Eigen::Vector2d point = seen;
  for (int i = 0; i < 50; ++i) {
    // Newton's method; the derivatives are differences, since they need not be exact.
    constexpr double kSmall = 1e-6;
    const Eigen::Vector2d at = distorted(lens, point);
    Eigen::Matrix2d slope;
    slope.col(0) = (distorted(lens, point + Eigen::Vector2d(kSmall, 0)) - at) / kSmall;
    slope.col(1) = (distorted(lens, point + Eigen::Vector2d(0, kSmall)) - at) / kSmall;
    const Eigen::Vector2d missing = seen - at;
    if (missing.norm() < 1e-12 || std::abs(slope.determinant()) < 1e-9) break;
    Eigen::Vector2d way = slope.inverse() * missing;
    if (way.norm() > 0.3) way *= 0.3 / way.norm();
    point += way;
  }
  return point;
}

void CameraOptics::prepareLens(const CameraModel& camera) {
  if (prepared_ && isSame(camera, camera_)) return;
  prepared_ = true;
  camera_ = camera;
  pinhole_ = camera;
  pinhole_.vignetting = {};
  pinhole_.distortion = {};
  sources_.clear();
  if (!camera.distortion.any()) return;
  const double focalX = camera.width / 2.0 / std::tan(camera.horizontalAngle / 2),
               focalY = camera.height / 2.0 / std::tan(camera.verticalAngle / 2);
  std::vector<Eigen::Vector2d> tangents;
  Eigen::Vector2d widest(1e-3, 1e-3);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector2d seen((x + 0.5 - camera.width / 2.0) / focalX,
                                 (y + 0.5 - camera.height / 2.0) / focalY);
      tangents.push_back(undistorted(camera.distortion, seen));
      const bool isThere = (distorted(camera.distortion, tangents.back()) - seen).norm() < 1e-6 &&
                           isInFront(camera.distortion, tangents.back(), seen) &&
                           tangents.back().cwiseAbs().maxCoeff() < kWidestTangent;
      if (!isThere) tangents.back().setConstant(std::nan(""));
      if (isThere) widest = widest.cwiseMax(tangents.back().cwiseAbs());
    }
  }
  // Two more pixels, for the interpolation at the edges.
  const auto sizeOf = [](double tangent, double focal, int of) {
    return std::clamp(2 * static_cast<int>(std::ceil(tangent * focal + 2)), 4, kMaxTimes * of);
  };
  pinhole_.width = sizeOf(widest.x(), focalX, camera.width);
  pinhole_.height = sizeOf(widest.y(), focalY, camera.height);
  pinhole_.horizontalAngle = 2 * std::atan(pinhole_.width / 2.0 / focalX);
  pinhole_.verticalAngle = 2 * std::atan(pinhole_.height / 2.0 / focalY);
  for (const Eigen::Vector2d& tangent : tangents) {
    const double x = tangent.x() * focalX + pinhole_.width / 2.0 - 0.5,
                 y = tangent.y() * focalY + pinhole_.height / 2.0 - 0.5;
    const bool inside = x >= 0 && y >= 0 && x < pinhole_.width - 1 && y < pinhole_.height - 1;
    sources_.push_back(inside ? Source{static_cast<float>(x), static_cast<float>(y)} : Source{-1, -1});
  }
}

void CameraOptics::accumulate(const Image& pinhole, const std::vector<float>& weights) {
  const auto width = static_cast<std::size_t>(camera_.width),
             height = static_cast<std::size_t>(camera_.height);
  const auto step = static_cast<std::size_t>(pinhole.width) * 3;
  for (std::size_t y = 0; y < height; ++y) {
    const float weight = weights[y];
    if (weight <= 0) continue;
    float* out = &sums_[y * width * 3];
    if (sources_.empty()) {
      const std::uint8_t* in = &pinhole.data[y * step];
      for (std::size_t i = 0; i < width * 3; ++i) out[i] += weight * static_cast<float>(in[i]);
      continue;
    }
    for (std::size_t x = 0; x < width; ++x, out += 3) {
      const Source& source = sources_[y * width + x];
      if (source.x < 0) continue;
      const auto left = static_cast<std::size_t>(source.x), top = static_cast<std::size_t>(source.y);
      const float u = source.x - static_cast<float>(left), v = source.y - static_cast<float>(top);
      const std::uint8_t* const upper = &pinhole.data[top * step + left * 3];
      const std::uint8_t* const lower = upper + step;
      for (int k = 0; k < 3; ++k) {
        const float above = (1 - u) * static_cast<float>(upper[k]) + u * static_cast<float>(upper[k + 3]);
        const float below = (1 - u) * static_cast<float>(lower[k]) + u * static_cast<float>(lower[k + 3]);
        out[k] += weight * ((1 - v) * above + v * below);
      }
    }
  }
}

void CameraOptics::distortLabels(std::uint8_t background, int width, Image& labels) const {
  if (sources_.empty()) return;
  const Image pinhole = labels;
  labels.width = std::min(width, camera_.width);
  labels.height = camera_.height;
  labels.data.assign(static_cast<std::size_t>(labels.width) * static_cast<std::size_t>(labels.height),
                     background);
  for (int y = 0; y < labels.height; ++y) {
    for (int x = 0; x < labels.width; ++x) {
      const Source& source = sources_[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width) +
                                      static_cast<std::size_t>(x)];
      if (source.x < 0) continue;
      const auto column = static_cast<std::size_t>(source.x + 0.5F),
                 row = static_cast<std::size_t>(source.y + 0.5F);
      labels.row(y)[x] = pinhole.data[row * static_cast<std::size_t>(pinhole.width) + column];
    }
  }
}

void CameraOptics::finish(const CameraModel& camera, PixelFormat format, Image& image) {
  image.format = format == PixelFormat::kYuyv ? PixelFormat::kYuyv : PixelFormat::kRgb8;
  image.width = format == PixelFormat::kYuyv ? camera.width & ~1 : camera.width;
  image.height = camera.height;
  image.data.resize(static_cast<std::size_t>(image.step()) * static_cast<std::size_t>(image.height));
  const double corner = (camera.width * camera.width + camera.height * camera.height) / 4.0;
  const auto falloff = static_cast<float>(camera.vignetting.falloff),
             tint = static_cast<float>(camera.vignetting.tint);
  std::vector<float> row(static_cast<std::size_t>(camera.width) * 3);
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(&sums_[static_cast<std::size_t>(y) * row.size()], row.size(), row.begin());
    for (int x = 0; x < camera.width; ++x) {
      const double dx = x + 0.5 - camera.width / 2.0, dy = y + 0.5 - camera.height / 2.0;
      const auto r2 = static_cast<float>((dx * dx + dy * dy) / corner);
      float* const pixel = &row[static_cast<std::size_t>(x) * 3];
      for (int k = 0; k < 3; ++k) pixel[k] *= (1 - falloff * r2) * (k < 2 ? 1 - tint * r2 : 1);
    }
    std::uint8_t* out = image.row(y);
    if (image.format == PixelFormat::kRgb8) {
      std::ranges::transform(row, out, toByte);
      continue;
    }
    // Chroma is the mean of a pair; with the coefficients of robotlink::toYCbCr.
    for (int x = 0; x < image.width; x += 2, out += 4) {
      const float* const p = &row[static_cast<std::size_t>(x) * 3];
      const float r = (p[0] + p[3]) / 2, g = (p[1] + p[4]) / 2, b = (p[2] + p[5]) / 2;
      out[0] = toByte(0.299F * p[0] + 0.587F * p[1] + 0.114F * p[2]);
      out[1] = toByte(128 - 0.168736F * r - 0.331264F * g + 0.5F * b);
      out[2] = toByte(0.299F * p[3] + 0.587F * p[4] + 0.114F * p[5]);
      out[3] = toByte(128 + 0.5F * r - 0.418688F * g - 0.081312F * b);
    }
  }
}

void CameraOptics::render(CameraRenderer& renderer, const PosesAt& posesAt, const Mount& mount,
                          const CameraModel& camera, const ShutterModel& shutter, PixelFormat format,
                          const ImageNoise& noise, Image& image) {
  const auto cameraInWorld = [&] {
    return poses_[static_cast<std::size_t>(mount.body)] * mount.cameraInBody;
  };
  if (!camera.distortion.any() && !shutter.any()) {
    sources_.clear();
    prepared_ = false;
    posesAt(0, poses_);
    renderer.setPoses(poses_);
    return renderer.render(cameraInWorld(), camera, format, noise, image);
  }
  prepareLens(camera);
  sums_.assign(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height) * 3, 0.F);
  const double whole = shutter.exposure + shutter.readout;
  const int instants = std::clamp(static_cast<int>(std::ceil(whole / kInstantsApart)), 1, kMaxInstants);
  // The last one is that of the image itself, so that it can be labeled.
  for (int i = instants - 1; i >= 0; --i) {
    const double from = whole * i / instants, to = whole * (i + 1) / instants;
    posesAt((from + to) / 2, poses_);
    renderer.setPoses(poses_);
    renderer.render(cameraInWorld(), pinhole_, PixelFormat::kRgb8, {}, instant_);
    accumulate(instant_, shutter.any() ? weightsOfRows(shutter, camera.height, from, to)
                                       : std::vector<float>(static_cast<std::size_t>(camera.height), 1.F));
  }
  finish(camera, format, image);
  renderer.addNoise(noise, image);
}

}  // namespace simcore
