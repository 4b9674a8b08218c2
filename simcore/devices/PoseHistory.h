// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "simcore/world/RenderScene.h"

namespace simcore {

class StateStream;

/// The poses of all bodies in the last steps, for sensors that measure the past. It is empty until
/// reachBack() is called. One thread at a time.
class PoseHistory {
 public:
  /// The longest that it reaches back, in steps; a delay of a second and the exposure of an image.
  static constexpr std::size_t kMaxSteps = 300;

  /// Reaches back at least `steps` steps from now on.
  void reachBack(std::size_t steps);
  bool isWanted() const { return steps_ > 0; }
  /// Forgets everything.
  void clear() { records_.clear(); }
  /// Writes or reads everything; `step` is the present one, `bodies` how many poses a step has.
  void transfer(StateStream& stream, std::uint64_t step, std::size_t bodies);
  /// Appends the poses after a step; steps come in order. Poses of the same step replace the former ones.
  void add(std::uint64_t step, std::span<const Pose3> poses);
  /// The oldest step that it has; `step` if it has none.
  std::uint64_t oldest(std::uint64_t step) const;
  /// The oldest step that it will have at a later step, if it need not reach back further.
  std::uint64_t oldestAt(std::uint64_t step) const;
  /// The poses after a step, or after the next one that it has; empty if there is none.
  std::span<const Pose3> at(std::uint64_t step) const;

 private:
  struct Record {
    std::uint64_t step = 0;
    std::vector<Pose3> poses;
  };
  std::deque<Record> records_;
  std::size_t steps_ = 0;
};

/// Sets `poses` to those of a time that is counted in steps, between two steps; `posesOf` yields those after
/// a step.
void interpolatePoses(double time, const std::function<std::span<const Pose3>(std::uint64_t step)>& posesOf,
                      std::vector<Pose3>& poses);

}  // namespace simcore
