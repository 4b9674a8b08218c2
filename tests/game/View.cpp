// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/game/View.h"

#include <array>
#include <cmath>

#include "robotlink/base/Random.h"

namespace game {
namespace {

using robotlink::Vector2;
using robotlink::Vector3;

constexpr double kCameraHeight = 0.45, kPitch = 0.21;
constexpr double kGoalX = 3, kFieldX = 3.4, kFieldY = 2.7;

/// A line of the field across the robot's way, and one beside it.
bool isLine(const Vector2& ground) {
  return (ground.x() > 0.9 && ground.x() < 0.96) || (ground.y() > -0.46 && ground.y() < -0.4);
}

/// Whether a ray from the camera meets the ball.
bool meetsBall(const View& image, const Vector3& ray) {
  if (!image.ballInRobot) return false;
  const Vector3 center(image.ballInRobot->x(), image.ballInRobot->y(), View::kBallRadius);
  const Vector3 toBall = center - image.cameraInRobot.translation();
  const double along = toBall.dot(ray.normalized());
  return along > 0 && toBall.squaredNorm() - along * along < View::kBallRadius * View::kBallRadius;
}

/// What a ray from the camera meets first.
std::uint8_t seen(const View& image, const Vector3& ray) {
  if (meetsBall(image, ray)) return View::kOrange;
  const Vector3 camera = image.cameraInRobot.translation();
  if (ray.z() < 0) {
    const Vector3 ground = camera - camera.z() / ray.z() * ray;
    if (ground.x() < kGoalX) return isLine(ground.head<2>()) ? View::kWhite : View::kGreen;
  }
  const Vector3 goal = camera + (kGoalX - camera.x()) / ray.x() * ray;
  const double side = std::abs(goal.y());
  if (goal.z() < 0.8 && side > 0.65 && side < 0.85) return View::kBlue;
  if (ray.z() >= 0) return 0;
  const Vector3 ground = camera - camera.z() / ray.z() * ray;
  return ground.x() < kFieldX && std::abs(ground.y()) < kFieldY ? View::kGreen : std::uint8_t{0};
}

Vector3 rayOf(const View& image, int x, int y) {
  const double focal = 0.5 * View::kWidth / std::tan(0.5 * View::kHorizontalAngle);
  return image.cameraInRobot.linear() *
         Vector3(1, (0.5 * View::kWidth - x - 0.5) / focal, (0.5 * View::kHeight - y - 0.5) / focal);
}

bool isAlone(const robotlink::Image& labels, int x, int y, int distance) {
  for (int i = y - distance; i <= y + distance; ++i) {
    for (int j = x - distance; j <= x + distance; ++j) {
      if (i < 0 || j < 0 || i >= labels.height || j >= labels.width || labels.row(i)[j] != labels.row(y)[x])
        return false;
    }
  }
  return true;
}

View made(int number) {
  using robotlink::Pose3;
  View image;
  const double pan = 0.15 * std::sin(0.6 * number);
  image.cameraInRobot = Pose3(Eigen::Translation3d(0.05, 0, kCameraHeight)) *
                        Pose3(Eigen::AngleAxisd(pan, Vector3::UnitZ())) *
                        Pose3(Eigen::AngleAxisd(kPitch, Vector3::UnitY()));
  if (number + 1 < View::kCount) image.ballInRobot = Vector2(1.4 - 0.03 * number, 0.1);
  robotlink::Image sharp(View::kWidth, View::kHeight, robotlink::PixelFormat::kMono8);
  robotlink::Random random(static_cast<std::uint64_t>(number) + 1);
  const auto noisy = [&random](std::uint8_t value, double most) {
    return static_cast<std::uint8_t>(std::lround(value + random.uniform(-most, most)));
  };
  image.quads.reserve(std::size_t{4} * View::kWidth * View::kHeight);
  for (int y = 0; y < sharp.height; ++y) {
    for (int x = 0; x < sharp.width; ++x) {
      sharp.row(y)[x] = seen(image, rayOf(image, x, y));
      const robotlink::YCbCr color = colorOf(sharp.row(y)[x]);
      const std::uint8_t luma = noisy(color.y, 4);
      image.quads.insert(image.quads.end(),
                         {noisy(color.y, 4), noisy(color.cb, 2), luma, noisy(color.cr, 2)});
    }
  }
  image.labels = sharp;
  for (int y = 0; y < sharp.height; ++y) {
    for (int x = 0; x < sharp.width; ++x) {
      const bool border = x == 0 || y == 0 || x + 1 == sharp.width || y + 1 == sharp.height;
      if (!border && !isAlone(sharp, x, y, 1)) image.labels.row(y)[x] = View::kEdge;
    }
  }
  return image;
}

}  // namespace

const View& View::at(int number) {
  static std::array<std::optional<View>, kCount> images;
  auto& image = images.at(static_cast<std::size_t>(number));
  if (!image) image = made(number);
  return *image;
}

std::vector<PixelPlace> placesInside(const robotlink::Image& labels, std::uint8_t label, int distance,
                                     std::size_t count) {
  std::vector<PixelPlace> all, chosen;
  for (int y = 0; y < labels.height; y += 2) {
    for (int x = 0; x < labels.width; x += 2) {
      if (labels.row(y)[x] == label && isAlone(labels, x, y, distance)) all.push_back({x, y});
    }
  }
  for (std::size_t i = 0; i < count && !all.empty(); ++i)
    chosen.push_back(all[std::min(all.size() - 1, i * all.size() / count + all.size() / (2 * count))]);
  return chosen;
}

}  // namespace game
