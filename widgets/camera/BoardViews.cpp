// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/BoardViews.h"

#include <algorithm>

namespace widgets {

bool BoardViews::isNew(const Corners& corners) const {
  constexpr double kShareOfWidth = 0.05;
  return std::ranges::all_of(views_, [&](const Corners& view) {
    if (view.size() != corners.size() || corners.empty()) return true;
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) sum += (view[i] - corners[i]).norm();
    return sum / static_cast<double>(corners.size()) >= kShareOfWidth * width_;
  });
}

void BoardViews::add(Corners corners, const robotlink::Chessboard& board, int width, int height) {
  if (board != board_ || width != width_ || height != height_) views_.clear();
  board_ = board;
  width_ = width;
  height_ = height;
  views_.push_back(std::move(corners));
}

void BoardViews::remove(std::size_t index) {
  if (index < views_.size()) views_.erase(views_.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace widgets
