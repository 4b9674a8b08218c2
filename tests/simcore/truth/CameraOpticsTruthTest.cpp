// SPDX-License-Identifier: GPL-3.0-or-later
// Where cameras show what is known: projection, lens, and what moves while rows are exposed.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simcore/rendering/CameraOptics.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;

constexpr int kColumns = 320, kRows = 240;

CameraModel camera() {
  CameraModel model;
  model.width = kColumns;
  model.height = kRows;
  model.horizontalAngle = 1.1;
  model.verticalAngle = 2 * std::atan(std::tan(0.55) * kRows / kColumns);
  return model;
}

double focal() {
  return kColumns / 2.0 / std::tan(0.55);
}

/// One white body, number 1, before a black background, seen without shades.
std::shared_ptr<const RenderScene> whiteOnBlack(Mesh mesh) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world", "body"};
  scene->meshes = {std::move(mesh)};
  scene->instances = {{0, 1, Pose3::Identity(), {200, 200, 200}, "body", true}};
  scene->ambient = 1;
  return scene;
}

Image imageOf(const std::shared_ptr<const RenderScene>& scene, const CameraModel& model,
              const Eigen::Vector3d& place, const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero(),
              const ShutterModel& shutter = {}) {
  CameraRenderer renderer(scene, {});
  CameraOptics optics;
  const auto posesAt = [&](double age, std::vector<Pose3>& poses) {
    poses.assign(2, Pose3::Identity());
    poses[1].translation() = place - velocity * age;
  };
  Image image;
  optics.render(renderer, posesAt, {}, model, shutter, PixelFormat::kRgb8, {}, image);
  return image;
}

double brightness(const Image& image, int x, int y) {
  return image.data[static_cast<std::size_t>((y * image.width + x) * 3)];
}

/// The center of all light, pixels.
Eigen::Vector2d centroid(const Image& image) {
  double sum = 0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      sum += brightness(image, x, y);
      moment += brightness(image, x, y) * Eigen::Vector2d(x + 0.5, y + 0.5);
    }
  }
  return moment / sum;
}

TEST(CameraTruth, knownPointsAppearWhereThePinholeAndTheLensPutThem) {
  const auto ball = whiteOnBlack(sphereMesh(0.02F, 16));
  const LensDistortion lens{-0.25, 0.06, -0.01, 0.004, -0.003};
  for (const double depth : {1.0, 2.5}) {
    for (const double side : {-0.4, -0.1, 0.2, 0.45}) {
      for (const double height : {-0.3, 0.0, 0.3}) {
        const Eigen::Vector3d place = depth * Eigen::Vector3d(1, side, height);
        const Eigen::Vector2d middle(kColumns / 2.0, kRows / 2.0);
        // To the right and down.
        const double x = -side, y = -height, r2 = x * x + y * y;
        compare({"camera, place of a small ball", "f X / Z", 0, 0.3, "pixel"},
                (centroid(imageOf(ball, camera(), place)) - middle - focal() * Eigen::Vector2d(x, y)).norm());
        CameraModel bent = camera();
        bent.distortion = lens;
        const double radial = 1 + lens.k1 * r2 + lens.k2 * r2 * r2 + lens.k3 * r2 * r2 * r2;
        const Eigen::Vector2d seen(x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
                                   y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y);
        compare(
            {"camera with distortion, place of a small ball", "Brown and Conrady, k1 to p2", 0, 0.5, "pixel"},
            (centroid(imageOf(ball, bent, place)) - middle - focal() * seen).norm());
      }
    }
  }
}

TEST(CameraTruth, lightFallsOffTowardsTheCorners) {
  CameraModel model = camera();
  model.vignetting = {0.6, 0};
  const Image image = imageOf(whiteOnBlack(boxMesh({0.1F, 10, 10})), model, {2, 0, 0});
  double largest = 0;
  for (int y = 0; y < kRows; y += 5) {
    for (int x = 0; x < kColumns; x += 5) {
      const double r2 = (std::pow(x + 0.5 - kColumns / 2.0, 2) + std::pow(y + 0.5 - kRows / 2.0, 2)) /
                        (kColumns * kColumns / 4.0 + kRows * kRows / 4.0);
      largest = largerOf(largest, std::abs(brightness(image, x, y) - 200 * (1 - 0.6 * r2)));
    }
  }
  compare({"vignetting of a white wall", "1 - falloff r^2", 0, 0.51, "gray value"}, largest);
}

/// An upright bar of 0.2 m width, 2 m ahead.
std::shared_ptr<const RenderScene> bar() {
  return whiteOnBlack(boxMesh({0.002F, 0.2F, 6}));
}

/// The middle and the extent of what is bright in a row, weighted by brightness.
struct Stripe {
  double middle = 0, first = -1, last = -1, light = 0;
};
Stripe stripeOf(const Image& image, int y) {
  Stripe stripe;
  for (int x = 0; x < image.width; ++x) {
    const double value = brightness(image, x, y);
    stripe.middle += value * (x + 0.5);
    stripe.light += value;
    if (value <= 0) continue;
    if (stripe.first < 0) stripe.first = x;
    stripe.last = x + 1;
  }
  stripe.middle /= stripe.light;
  return stripe;
}

TEST(CameraTruth, aRollingShutterSkewsWhatMoves) {
  const double speed = 4, readout = 0.05;
  const Image image = imageOf(bar(), camera(), {2, 0, 0}, {0, -speed, 0}, {0, readout});
  // Least squares over all rows: pixels of skew per row.
  double sum = 0, square = 0, mean = 0;
  for (int y = 0; y < kRows; ++y) mean += stripeOf(image, y).middle / kRows;
  for (int y = 0; y < kRows; ++y) {
    const double row = y - (kRows - 1) / 2.0;
    sum += row * (stripeOf(image, y).middle - mean);
    square += row * row;
  }
  const double expected = speed * focal() / 1.999 * readout / (kRows - 1);
  compare({"rolling shutter, skew of a moved upright bar", "v f / d * readout / rows", expected,
           0.02 * expected, "pixel/row"},
          sum / square);
}

TEST(CameraTruth, exposureBlursAlongTheWay) {
  const double speed = 8;
  for (const double exposure : {0.01, 0.03}) {
    const Stripe sharp = stripeOf(imageOf(bar(), camera(), {2, 0, 0}, {0, -speed, 0}), kRows / 2);
    const Stripe blurred =
        stripeOf(imageOf(bar(), camera(), {2, 0, 0}, {0, -speed, 0}, {exposure, 0}), kRows / 2);
    const double way = speed * exposure * focal() / 1.999;
    compare({"exposure, length of the blur", "v f / d * exposure", 0, 0.1, "of its length"},
            ((blurred.last - blurred.first) - (sharp.last - sharp.first) - way) / way);
    compare({"exposure, middle of the blur", "half of its length", 0, 0.05, "of its length"},
            (sharp.middle - blurred.middle - way / 2) / way);
    compare({"exposure, light of the blurred bar", "that of the sharp one", 0, 0.02, "of it"},
            (blurred.light - sharp.light) / sharp.light);
  }
}

}  // namespace
}  // namespace simcore::truth
