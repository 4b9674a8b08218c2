// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace modules {

/// Sends the state of a behavior, and since when it lasts, as "behavior/state". A state begins with another
/// name than that of the one before. Used by its process's thread; the context must outlive it.
class BehaviorReport {
 public:
  /// `solution` is the name of the behavior's solution.
  BehaviorReport(robotlink::SolutionContext& context, std::string solution)
      : clock_(context.clock()),
        output_(context.output(robotlink::kBehaviorState)),
        solution_(std::move(solution)) {}

  /// Call it in each frame. `reason` says why the state was entered; only that of the frame in which it was
  /// counts.
  void send(const std::string& state, const std::string& reason = {}) {
    const robotlink::Instant now = clock_.now();
    if (!began_ || state != state_) {
      state_ = state;
      reason_ = reason;
      since_ = now;
      began_ = true;
    }
    auto report = std::make_shared<robotcontrol::BehaviorState>();
    robotlink::assign(*report->mutable_timestamp(), now);
    report->set_solution(solution_);
    report->set_state(state_);
    report->set_reason(reason_);
    robotlink::assign(*report->mutable_since(), since_);
    report->set_seconds(robotlink::seconds(now - since_));
    output_.send(std::move(report));
  }

 private:
  const robotlink::Clock& clock_;
  robotlink::Output<robotcontrol::BehaviorState> output_;
  std::string solution_;
  bool began_ = false;
  std::string state_, reason_;
  robotlink::Instant since_;
};

}  // namespace modules
