// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"

namespace app {

class OpenPlatform;

/// Steps the shown instant to where a value changes: in open logs, which are read in a thread without being
/// played, or in the history of live robots. One step at a time; a newer one replaces it. All functions in
/// the thread of the platform's owner.
class ChangeSteps {
 public:
  struct Step {
    /// The value, with streams as in the session (robotlink/expressions/EXPRESSIONS.md); without a robot,
    /// those of the selected one.
    std::string expression;
    bool isForward = true;
    /// Set: only changes count at which the value reaches this, or falls below it.
    std::optional<double> limit = {};
  };

  /// `open` must outlive it.
  explicit ChangeSteps(OpenPlatform& open);
  /// Fails if nothing is open, or if the expression does not fit a live session.
  robotlink::Result<void> begin(const Step& step);
  /// Goes to what was found. A failure is passed to the session's handler of refusals.
  void tick();
  /// Whether it runs. Fails, once, with why it failed; if there is no such change it fails, too.
  robotlink::Result<bool> working();

 private:
  /// A step through logs.
  struct Plan {
    struct Log {
      std::filesystem::path path;
      robotlink::Duration offset{0};
      /// The names of its robots in the session, in the log's order.
      std::vector<std::string> robots;
    };
    Step step;
    std::string robot;
    robotlink::Instant from;
    std::vector<Log> logs;
  };
  using Found = robotlink::Result<robotlink::Instant>;

  robotlink::Result<void> beginLive(const Step& step);
  static Found findIn(const Plan& plan, const std::stop_token& stop);
  void fail(robotlink::Error error);

  OpenPlatform& open_;
  bool isSearching_ = false, isStepping_ = false;
  std::string expression_;
  bool isForward_ = true;
  std::optional<robotlink::Error> failure_;
  robotlink::Worker<Plan, Found> worker_;
};

}  // namespace app
