// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robotlink/calibration/LensModel.h"

// The interface of robotcontrol_calibration.so, a separate module that is loaded when the first camera is
// calibrated, because OpenCV's calib3d brings many libraries, which every start would have to load. Pixels
// are as OpenCV counts them: (0, 0) is the middle of the first one.
namespace robotlink {

/// OpenCV's part of a calibration. Any thread. Functions return nothing if OpenCV refuses the input.
class CalibrationModule {
 public:
  using Points = std::vector<Vector2>;

  virtual ~CalibrationModule() = default;
  /// The corners of a chessboard in a gray image without gaps, row by row.
  virtual std::optional<Points> findBoard(int width, int height, const std::uint8_t* gray,
                                          const Chessboard& board) const = 0;
  /// At least three views, of `board.corners().size()` points each.
  virtual std::optional<LensFit> fitLens(const std::vector<Points>& views, const Chessboard& board, int width,
                                         int height) const = 0;
  /// At least four points. The pose has OpenCV's axes: x to the right, y down, z along the optical axis.
  virtual std::optional<PlaceFit> fitPlace(const std::vector<Vector3>& points, const Points& pixels,
                                           const LensModel& lens) const = 0;
};

/// Returns the one object, which lives as long as the program.
using GetCalibration = const CalibrationModule* (*)();
inline constexpr char kGetCalibration[] = "robotcontrol_calibration";

}  // namespace robotlink
