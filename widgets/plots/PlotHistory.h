// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace widgets {

/// The ranges of a plot's axes.
struct PlotRanges {
  using Range = std::pair<double, double>;
  /// Times in s.
  Range times, values, rightValues;
  bool operator==(const PlotRanges&) const = default;
};

/// The ranges that a plot showed before, for undo and redo.
class PlotHistory {
 public:
  static constexpr std::size_t kMaxSteps = 200;

  /// Adds a step, before which the plot showed this.
  void add(const PlotRanges& before) {
    if (undo_.size() == kMaxSteps) undo_.erase(undo_.begin());
    undo_.push_back(before);
    redo_.clear();
  }
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  /// The ranges to show instead of `now`; empty if there is no such step.
  std::optional<PlotRanges> undo(const PlotRanges& now) { return step(undo_, redo_, now); }
  std::optional<PlotRanges> redo(const PlotRanges& now) { return step(redo_, undo_, now); }

 private:
  using Steps = std::vector<PlotRanges>;
  static std::optional<PlotRanges> step(Steps& from, Steps& to, const PlotRanges& now) {
    if (from.empty()) return std::nullopt;
    to.push_back(now);
    const PlotRanges taken = from.back();
    from.pop_back();
    return taken;
  }

  Steps undo_, redo_;
};

}  // namespace widgets
