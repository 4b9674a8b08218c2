// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/core/program/ProgramOverrides.h"
#include "robotlink/base/Clock.h"
#include "robotlink/debugging/RequestPreview.h"

namespace robotcontrol {
class DebugQueue;
}
namespace robotlink {
class RobotProgram;
}

namespace app {

/// The requests to one robot's program, over all the programs that are made for the robot: those that wait
/// until they are handed to it, those that it has not answered yet, and what was accepted and shall hold for
/// the next program, too.
///
/// ask(), hand() and answered() may be called from any thread; the others while no process of the program
/// runs.
class ProgramRequests {
 public:
  explicit ProgramRequests(std::string robot, ProgramOverrides overrides = {})
      : robot_(std::move(robot)), overrides_(std::move(overrides)) {}

  /// A program was made that has not run yet, in the place of the one before, if there was one: hand() gives
  /// it what a person chose so far, and what was asked and not yet answered. Returns a sentence for each
  /// choice that this program cannot fulfill.
  std::vector<std::string> begin(robotlink::RobotProgram& program);
  /// False: too many wait already.
  bool ask(const robotcontrol::Request& request);
  /// Gives the program what it was not handed yet, in order, until it takes no more; the rest waits for the
  /// next time. `give` must not call this object.
  void hand(const std::function<bool(const robotcontrol::Request&)>& give);
  /// The program has told this.
  void answered(const robotcontrol::DebugQueue& queue);
  /// The program has run: what it would do is to be found anew.
  void ran() { preview_.reset(); }
  /// The answers that it will give in its next frames, if they were not given yet; null: there are none.
  std::shared_ptr<const robotcontrol::DebugQueue> answersToCome(robotlink::RobotProgram& program,
                                                                robotlink::Instant now);

  ProgramOverrides overrides() const;

 private:
  struct Open {
    robotcontrol::Request request;
    bool handed = false;     // to the program
    bool reported = false;   // its answer, before the program gave it
    bool previewed = false;  // by the present preview
  };
  bool replacesLast(const robotcontrol::Request& request) const;
  void addOwn(robotcontrol::Request request);

  const std::string robot_;
  std::optional<robotlink::RequestPreview> preview_;
  mutable std::mutex mutex_;  // protects what follows
  std::deque<Open> open_;     // in the order in which they were asked
  std::uint64_t ownRequests_ = 0;
  ProgramOverrides overrides_;
};

}  // namespace app
