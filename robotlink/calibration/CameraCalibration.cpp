// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/calibration/CameraCalibration.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/OptionalModule.h"
#include "robotlink/calibration/CalibrationModule.h"

namespace robotlink {
namespace {

Result<const CalibrationModule*> calibrationModule() {
  struct Loaded {
    const CalibrationModule* module = nullptr;
    std::string problem;
  };
  static const Loaded kLoaded = [] {
    OptionalModule module("robotcontrol_calibration.so");
    const auto get = module.function<GetCalibration>(kGetCalibration);
    return Loaded{get != nullptr ? get() : nullptr, module.problem()};
  }();
  if (kLoaded.module == nullptr)
    return failure("calibration.module",
                   "cameras cannot be calibrated, because an OpenCV module is missing: " + kLoaded.problem +
                       "; install libopencv-calib3d406, or reinstall the program");
  return kLoaded.module;
}

tl::unexpected<Error> wrongPoints(const std::string& why) {
  return failure("calibration.points", why);
}

tl::unexpected<Error> noFit() {
  return failure("calibration.fit",
                 "these points cannot be the image of any camera: check which point is which, and the size "
                 "of the board");
}

/// From pixels whose first one has its corner at (0, 0) to those whose first one has its middle there.
std::vector<Vector2> counted(std::span<const Vector2> pixels, double shift) {
  std::vector<Vector2> moved;
  for (const Vector2& pixel : pixels) moved.emplace_back(pixel.array() + shift);
  return moved;
}

bool isFinite(const LensModel& lens) {
  return std::isfinite(lens.focalX) && std::isfinite(lens.focalY) && lens.focalX > 0 && lens.focalY > 0;
}

/// From OpenCV's axes of a camera (x to the right, y down, z ahead) to ours (x ahead, y to the left, z up).
Eigen::Matrix3d oursInOpenCv() {
  Eigen::Matrix3d axes;
  axes << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return axes;
}

}  // namespace

Result<std::optional<std::vector<Vector2>>> findChessboard(const ImageView& image, const Chessboard& board) {
  if (image.empty() || !board.isUsable())
    return wrongPoints(
        "a board needs 3 to 50 inner corners each way, different numbers of rows and columns, and squares "
        "larger than 0");
  const auto module = calibrationModule();
  if (!module) return tl::unexpected(module.error());
  Image gray(image.width, image.height, PixelFormat::kMono8);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) gray.row(y)[x] = pixelYCbCr(image, x, y).y;
  const auto found = (*module)->findBoard(gray.width, gray.height, gray.data.data(), board);
  if (!found) return std::nullopt;
  return counted(*found, 0.5);
}

Result<LensFit> fitLens(std::span<const std::vector<Vector2>> views, const Chessboard& board, int width,
                        int height) {
  if (views.size() < kMinBoardViews)
    return wrongPoints("a lens is computed from at least " + std::to_string(kMinBoardViews) +
                       " views of the board, preferably ten");
  const std::size_t corners = board.corners().size();
  if (std::ranges::any_of(views, [&](const auto& view) { return view.size() != corners; }) ||
      !board.isUsable())
    return wrongPoints("some of the views show a different board");
  const auto module = calibrationModule();
  if (!module) return tl::unexpected(module.error());
  std::vector<std::vector<Vector2>> moved;
  for (const auto& view : views) moved.push_back(counted(view, -0.5));
  auto fit = (*module)->fitLens(moved, board, width, height);
  if (!fit || !isFinite(fit->lens) || !std::isfinite(fit->error)) return noFit();
  fit->lens.centerX += 0.5;
  fit->lens.centerY += 0.5;
  return *std::move(fit);
}

Result<PlaceFit> fitPlace(std::span<const Vector3> points, std::span<const Vector2> pixels,
                          const LensModel& lens) {
  if (points.size() != pixels.size() || points.size() < kMinPlacePoints)
    return wrongPoints("a place is computed from at least " + std::to_string(kMinPlacePoints) + " points");
  const auto module = calibrationModule();
  if (!module) return tl::unexpected(module.error());
  LensModel moved = lens;
  moved.centerX -= 0.5;
  moved.centerY -= 0.5;
  auto fit = (*module)->fitPlace({points.begin(), points.end()}, counted(pixels, -0.5), moved);
  if (!fit || !fit->cameraInWorld.matrix().allFinite() || !std::isfinite(fit->error)) return noFit();
  fit->cameraInWorld.rotate(oursInOpenCv());
  return *std::move(fit);
}

Result<PlaceFit> fitPlaceAboveBoard(const std::vector<Vector2>& corners, const Chessboard& board,
                                    const LensModel& lens) {
  const auto points = board.corners();
  auto fit = fitPlace(points, corners, lens);
  // The corners are found in either order, so that the board's z may point into the ground.
  if (fit && fit->height() < 0)
    fit->cameraInWorld = Eigen::AngleAxisd(kPi, Vector3::UnitX()) * fit->cameraInWorld;
  return fit;
}

}  // namespace robotlink
