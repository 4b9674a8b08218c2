// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "robotlink/calibration/LensModel.h"

namespace widgets {

/// The views of a chessboard that a lens is computed from. All are of one board and one size of image: the
/// first one decides. A plain value.
class BoardViews {
 public:
  using Corners = std::vector<robotlink::Vector2>;

  const std::vector<Corners>& views() const { return views_; }
  const robotlink::Chessboard& board() const { return board_; }
  int width() const { return width_; }
  int height() const { return height_; }

  /// Whether a view shows the board at another place than all others, so that it adds something: its corners
  /// are on average at least a twentieth of the image's width away.
  bool isNew(const Corners& corners) const;
  /// Adds a view; one of another board or size of image starts over.
  void add(Corners corners, const robotlink::Chessboard& board, int width, int height);
  void remove(std::size_t index);
  void clear() { views_.clear(); }

 private:
  std::vector<Corners> views_;
  robotlink::Chessboard board_;
  int width_ = 0, height_ = 0;
};

}  // namespace widgets
