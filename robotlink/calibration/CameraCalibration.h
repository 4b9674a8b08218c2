// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"
#include "robotlink/calibration/LensModel.h"

// Calibrates cameras, with OpenCV's calib3d. All functions may be called from any thread, and take from
// milliseconds to seconds. Errors have the ids "calibration.module" (OpenCV is not there),
// "calibration.points" (too few, or not those of a board) and "calibration.fit" (nothing fits them).
namespace robotlink {

/// The fewest views that a lens is computed from, and the fewest points that a place is.
inline constexpr std::size_t kMinBoardViews = 3, kMinPlacePoints = 4;

/// The corners of a chessboard in an image, row by row as in Chessboard::corners(); nothing if the whole
/// board is not seen.
Result<std::optional<std::vector<Vector2>>> findChessboard(const ImageView& image, const Chessboard& board);

/// Computes the lens from views of a board in different directions (Z. Zhang, A Flexible New Technique for
/// Camera Calibration, 2000).
Result<LensFit> fitLens(std::span<const std::vector<Vector2>> views, const Chessboard& board, int width,
                        int height);

/// Computes where a camera is from known points, m, and the pixels in which it sees them: the SQPnP method
/// (G. Terzakis, M. Lourakis, 2020), refined by Levenberg-Marquardt.
Result<PlaceFit> fitPlace(std::span<const Vector3> points, std::span<const Vector2> pixels,
                          const LensModel& lens);
/// The same from a board that lies on the ground, wherever: its height, tilt and roll are those above the
/// ground. The board's frame is turned so that its z points up.
Result<PlaceFit> fitPlaceAboveBoard(const std::vector<Vector2>& corners, const Chessboard& board,
                                    const LensModel& lens);

}  // namespace robotlink
