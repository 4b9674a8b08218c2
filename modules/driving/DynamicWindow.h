// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/driving/VectorField.h"

namespace modules {

/// Avoids obstacles in the space of velocities (the dynamic window approach; Fox, Burgard and Thrun 1997): of
/// those that the motors can reach until the next decision, and from which the robot can still brake before
/// its outline touches anything, it takes the one that is nearest to the wish, has most time ahead and most
/// room beside.
class DynamicWindow {
 public:
  struct Options {
    Outline outline;
    double margin = 0.1;             ///< m, that stays free around the outline
    double window = 0.3;             ///< s, of acceleration
    double horizon = 3.0;            ///< s, looked ahead
    double latency = 0.25;           ///< s
    int speeds = 7, rotations = 15;  ///< samples of the window
    double speedWeight = 1.0, rotationWeight = 0.6, wayWeight = 1.5, roomWeight = 0.4;
    CornerEscape::Options escape;
  };
  /// A velocity that was looked at.
  struct Candidate {
    DriveVelocity velocity;
    double freeTime = 0;  ///< s
    bool admissible = false;
    double value = 0;
  };
  explicit DynamicWindow(const Options& options) : options_(options), escape_(options.escape) {}
  void setOptions(const Options& options);

  DriveVelocity decide(const AvoidanceSituation& situation);
  // For drawings.
  const std::vector<Candidate>& candidates() const { return candidates_; }
  const DriveVelocity& chosen() const { return chosen_; }
  bool escaping() const { return escape_.active(); }

 private:
  Candidate judged(const DriveVelocity& velocity, const AvoidanceSituation& situation,
                   const Clearance& clearance, const PolarView& view) const;
  DriveVelocity best(const AvoidanceSituation& situation, const Clearance& clearance, const PolarView& view);

  Options options_;
  CornerEscape escape_;
  std::vector<Candidate> candidates_;
  DriveVelocity chosen_;
};

}  // namespace modules
