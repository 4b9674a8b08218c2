// SPDX-License-Identifier: GPL-3.0-or-later
// The module that calls OpenCV's calib3d.
#include "robotlink/calibration/CalibrationModule.h"

#include <algorithm>
#include <exception>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace robotlink {
namespace {

using Points = CalibrationModule::Points;

std::vector<cv::Point3f> spaceOf(const std::vector<Vector3>& points) {
  std::vector<cv::Point3f> converted;
  for (const Vector3& point : points)
    converted.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()),
                           static_cast<float>(point.z()));
  return converted;
}

std::vector<cv::Point2f> pixelsOf(const Points& pixels) {
  std::vector<cv::Point2f> converted;
  for (const Vector2& pixel : pixels)
    converted.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  return converted;
}

cv::Mat matrixOf(const LensModel& lens) {
  return (cv::Mat_<double>(3, 3) << lens.focalX, 0, lens.centerX, 0, lens.focalY, lens.centerY, 0, 0, 1);
}

class OpenCvCalibration final : public CalibrationModule {
 public:
  std::optional<Points> findBoard(int width, int height, const std::uint8_t* gray,
                                  const Chessboard& board) const override try {
    // OpenCV only reads it.
    const cv::Mat image(height, width, CV_8UC1, const_cast<std::uint8_t*>(gray));
    std::vector<cv::Point2f> found;
    const cv::Size corners(board.columns, board.rows);
    // Most images have no board: those are left at once.
    if (!cv::findChessboardCorners(
            image, corners, found,
            cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK))
      return std::nullopt;
    // To fractions of a pixel, within a third of the smallest distance of two corners in a row.
    double closest = width;
    for (std::size_t i = 1; i < found.size(); ++i)
      if (i % static_cast<std::size_t>(board.columns) != 0)
        closest = std::min(closest, cv::norm(found[i] - found[i - 1]));
    const int window = std::clamp(static_cast<int>(closest / 3), 1, 11);
    cv::cornerSubPix(image, found, cv::Size(window, window), cv::Size(-1, -1),
                     cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 1e-3));
    Points points;
    for (const cv::Point2f& point : found) points.emplace_back(point.x, point.y);
    return points;
  } catch (const std::exception&) {
    return std::nullopt;
  }

  std::optional<LensFit> fitLens(const std::vector<Points>& views, const Chessboard& board, int width,
                                 int height) const override try {
    const std::vector<std::vector<cv::Point3f>> boards(views.size(), spaceOf(board.corners()));
    std::vector<std::vector<cv::Point2f>> pixels;
    for (const Points& view : views) pixels.push_back(pixelsOf(view));
    cv::Mat matrix, distortion, rotations, translations, ignored, extrinsic, errors;
    LensFit fit;
    fit.error = cv::calibrateCamera(boards, pixels, cv::Size(width, height), matrix, distortion, rotations,
                                    translations, ignored, extrinsic, errors);
    fit.lens = {width,
                height,
                matrix.at<double>(0, 0),
                matrix.at<double>(1, 1),
                matrix.at<double>(0, 2),
                matrix.at<double>(1, 2)};
    for (int i = 0; i < 5; ++i) fit.lens.distortion[static_cast<std::size_t>(i)] = distortion.at<double>(i);
    for (int i = 0; i < errors.rows; ++i) fit.viewErrors.push_back(errors.at<double>(i));
    return fit;
  } catch (const std::exception&) {
    return std::nullopt;
  }

  std::optional<PlaceFit> fitPlace(const std::vector<Vector3>& points, const Points& pixels,
                                   const LensModel& lens) const override try {
    const auto space = spaceOf(points);
    const auto seen = pixelsOf(pixels);
    const cv::Mat matrix = matrixOf(lens);
    const cv::Mat distortion(1, 5, CV_64F, const_cast<double*>(lens.distortion.data()));
    cv::Mat turn, translation, rotation;
    if (!cv::solvePnP(space, seen, matrix, distortion, turn, translation, false, cv::SOLVEPNP_SQPNP))
      return std::nullopt;
    cv::solvePnPRefineLM(space, seen, matrix, distortion, turn, translation);
    cv::Rodrigues(turn, rotation);
    Pose3 worldInCamera = Pose3::Identity();
    for (int row = 0; row < 3; ++row) {
      worldInCamera.translation()[row] = translation.at<double>(row);
      for (int column = 0; column < 3; ++column)
        worldInCamera.linear()(row, column) = rotation.at<double>(row, column);
    }
    std::vector<cv::Point2f> again;
    cv::projectPoints(space, turn, translation, matrix, distortion, again);
    PlaceFit fit{worldInCamera.inverse()};
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      fit.errors.push_back(cv::norm(again[i] - seen[i]));
      sum += fit.errors.back() * fit.errors.back();
    }
    fit.error = std::sqrt(sum / static_cast<double>(seen.size()));
    return fit;
  } catch (const std::exception&) {
    return std::nullopt;
  }
};

}  // namespace
}  // namespace robotlink

extern "C" __attribute__((visibility("default"))) const robotlink::CalibrationModule*
robotcontrol_calibration() {
  static const robotlink::OpenCvCalibration kCalibration;
  return &kCalibration;
}
