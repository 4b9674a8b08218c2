// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/commands/ScriptCondition.h"
#include "robotlink/commands/ScriptRun.h"

namespace widgets {

class ParameterEdits;

/// Sets a parameter of the selected robot to one value after the other and measures a figure at each of them.
/// The parameter gets its former value at the end. GUI thread; its arguments must outlive it.
class ParameterSweep final : public QObject {
  Q_OBJECT
 public:
  struct Plan {
    /// The task and the path, as in robot.parameter.
    std::string task, path;
    std::vector<std::string> values = {};
    /// An expression over streams.
    std::string figure = {};
    /// For how much of the session's time it is measured at each value.
    double seconds = 1;
    /// The CSV file that is written at the end; empty: none.
    std::filesystem::path file = {};
  };
  /// The measurements at a value: the figure of each message that gave one.
  struct Row {
    std::string value;
    std::size_t count = 0;
    double mean = 0, minimum = 0, maximum = 0;
    /// The sum of the squared differences from the mean.
    double squares = 0;
    double deviation() const;
    void add(double figure);
  };

  ParameterSweep(robotlink::CommandTable& commands, robotlink::Session& session, ParameterEdits& edits,
                 QObject* parent);

  /// "1,2,5", "on,off", or from:to:step: "0.1:0.5:0.1". Fails, and says how, for other texts.
  static robotlink::Result<std::vector<std::string>> valuesIn(const std::string& text);
  /// value, count, mean, deviation, minimum, maximum; one line each.
  static std::string csv(const std::vector<Row>& rows);

  /// Fails if a sweep runs, or the plan cannot be.
  robotlink::Result<void> begin(Plan plan);
  /// Ends early; the parameter gets its former value.
  void stop();
  /// `now` is real time from any zero.
  void tick(robotlink::Instant now);
  bool isRunning() const { return state_ != State::kIdle; }
  /// Whether it runs; fails once, with why it ended.
  robotlink::Result<bool> working();
  /// The reason why the last sweep failed; unset if it did not.
  const std::optional<robotlink::Error>& failed() const { return failed_; }
  /// The values that were measured, and the one that is being measured now.
  const std::vector<Row>& rows() const { return rows_; }
  const Plan& plan() const { return plan_; }

 Q_SIGNALS:
  /// Emitted when another value is measured, or the sweep has ended.
  void progressed();

 private:
  enum class State { kIdle, kAsking, kSetting, kMeasuring, kRestoring };
  /// Runs a command, or waits, until tick() finds it done.
  void run(State state, const std::string& line);
  void setNext();
  void measure();
  void end(std::optional<robotlink::Error> error);

  robotlink::Session& session_;
  ParameterEdits& edits_;
  robotlink::CommandTable& commands_;
  /// The script that runs for the present state; null: none.
  std::unique_ptr<robotlink::ScriptRun> run_;
  std::unique_ptr<robotlink::ScriptCondition> figure_;
  State state_ = State::kIdle;
  Plan plan_;
  std::vector<Row> rows_;
  std::string former_;
  /// The session's time at which the present measurement began.
  robotlink::Instant from_;
  std::optional<robotlink::Error> failed_, unreported_;
};

/// Attaches "parameters.sweep" and "parameters.stop-sweep". They fail when `sweep` no longer exists. Does
/// nothing if they are attached already.
void attachSweepCommands(robotlink::CommandTable& commands, ParameterSweep& sweep);

}  // namespace widgets
