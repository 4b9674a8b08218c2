// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/driving/VectorField.h"

namespace modules {

/// Avoids obstacles in the space of velocities (the dynamic window approach; Fox, Burgard and Thrun 1997). Of
/// the velocities that the motors can reach until the next decision, and from which the robot can still brake
/// before its outline touches anything, it takes the one that is closest to the request, can be kept longest
/// and leaves most room on the sides. Not thread-safe.
class DynamicWindow {
 public:
  struct Options {
    Outline outline;
    /// The distance to keep around the outline, m.
    double margin = 0.1;
    /// The time for which acceleration may change the velocity until the next decision, s.
    double window = 0.3;
    /// The time to look ahead, s.
    double horizon = 3.0;
    /// Delay until a request takes effect, s.
    double latency = 0.25;
    /// The number of samples in the window.
    int speeds = 7, rotations = 15;
    // Weights of the parts of a candidate's value.
    double speedWeight = 1.0, rotationWeight = 0.6, wayWeight = 1.5, roomWeight = 0.4;
    CornerEscape::Options escape;
  };
  /// A sampled velocity with its evaluation.
  struct Candidate {
    DriveVelocity velocity;
    /// The time for which it can be kept, s.
    double freeTime = 0;
    /// Whether the robot can brake in time.
    bool admissible = false;
    /// The weighted sum; larger is better.
    double value = 0;
  };
  explicit DynamicWindow(const Options& options) : options_(options), escape_(options.escape) {}
  void setOptions(const Options& options);

  /// The velocity to drive at; call it once a frame.
  DriveVelocity decide(const AvoidanceSituation& situation);
  // Only for drawings, as of the last decide().
  const std::vector<Candidate>& candidates() const { return candidates_; }
  const DriveVelocity& chosen() const { return chosen_; }
  bool escaping() const { return escape_.active(); }

 private:
  /// Evaluates a sample.
  Candidate judged(const DriveVelocity& velocity, const AvoidanceSituation& situation,
                   const Clearance& clearance, const PolarView& view) const;
  /// Samples the window and returns the best velocity.
  DriveVelocity best(const AvoidanceSituation& situation, const Clearance& clearance, const PolarView& view);

  Options options_;
  CornerEscape escape_;
  std::vector<Candidate> candidates_;
  DriveVelocity chosen_;
};

}  // namespace modules
