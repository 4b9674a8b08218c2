// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/StartScript.h"

#include <QTimerEvent>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "app/core/Workbench.h"
#include "app/core/platform/ExitStatus.h"
#include "app/core/platform/PlatformFeed.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Printable.h"
#include "robotlink/session/RobotTables.h"

namespace app {
namespace {

constexpr int kScriptTickMs = 20;
/// The time that a program may take to report its tasks after it was opened, also on a busy machine; those of
/// logs that are only watched never do.
constexpr std::chrono::seconds kTablesLimit(10), kTablesLimitOfLogs(1);

/// The time that robots at the addresses of the command line may take to be connected.
constexpr std::chrono::seconds kRobotsLimit(10);

/// Whether something opens, or the selected robot's program has not reported all of its tasks yet: until then
/// commands about these would be refused.
class Opening {
 public:
  bool lasts(Workbench& workbench) {
    const auto now = std::chrono::steady_clock::now();
    if (workbench.loading() || !opened_) opened_ = now;
    if (workbench.loading()) return true;
    // Programs of remote robots are not waited for, and bodies have none here.
    const LoadedPlatform* loaded = workbench.loaded();
    if (loaded == nullptr || loaded->robots.empty() || loaded->areBodies) return false;
    return !robotlink::areTasksKnown(workbench.session()) &&
           now - *opened_ < (loaded->isLogged() ? kTablesLimitOfLogs : kTablesLimit);
  }

 private:
  std::optional<std::chrono::steady_clock::time_point> opened_;
};

}  // namespace

robotlink::ScriptRun::Workbench scriptsOf(Workbench& workbench) {
  const auto opening = [&workbench, state = std::make_shared<Opening>()]() -> robotlink::Result<bool> {
    const robotlink::Errors errors = workbench.takeOpeningErrors();
    if (!errors.empty()) return robotlink::failure("script.opening", robotlink::describe(errors));
    const auto working = workbench.working();
    return working && !*working ? state->lasts(workbench) : working;
  };
  return {workbench.commands(), workbench.session(), opening};
}

StartScript::StartScript(Workbench& workbench, Options options, QObject* parent)
    : QObject(parent), workbench_(workbench), options_(std::move(options)), run_(scriptsOf(workbench)) {
  run_.setOutput([](const std::string& text) { std::cout << robotlink::printableLines(text) << std::endl; });
  startTimer(kScriptTickMs);
}

void StartScript::timerEvent(QTimerEvent* event) {
  if (!hasStarted_ && (workbench_.loading() || awaitsRobots())) return;
  if (!std::exchange(hasStarted_, true)) unopened_ = workbench_.takeOpeningErrors();
  run_.tick(clock_.now());
  while (run_.isIdle()) {
    report();
    if (isScript_ || !beginNext()) {
      killTimer(event->timerId());
      if (isScript_) finish();
      return;
    }
    run_.tick(clock_.now());
  }
}

bool StartScript::awaitsRobots() const {
  if (clock_.now() - begun_ > kRobotsLimit) return false;
  // A connection that was refused waits for a person, not for time to pass.
  using Phase = robotlink::websocket::ConnectionState::Phase;
  return std::ranges::any_of(workbench_.remote().connections(), [](const auto& connection) {
    return connection.robots.empty() && connection.state.phase != Phase::kRefused;
  });
}

bool StartScript::beginNext() {
  const bool starts = next_ == 0 && options_.startsSimulation && workbench_.loaded() != nullptr;
  if (starts && line_.empty()) {
    line_ = "simulation.start";
  } else if (next_ < options_.commands.size()) {
    line_ = options_.commands[next_++];
  } else {
    if (options_.script.empty()) return false;
    if (!unopened_.empty()) {
      std::cerr << robotlink::printableLines(robotlink::describe(unopened_)) << std::endl;
      Q_EMIT finished(kFailed);
      return false;
    }
    isScript_ = true;
    before_ = run_.outcomes().size();
    run_.runFile(options_.script);
    return true;
  }
  run_.runLines({}, line_);
  return true;
}

void StartScript::report() {
  if (!run_.failed()) return;
  const std::string where = isScript_ ? "" : "robotcontrol: " + line_ + ": ";
  std::cerr << robotlink::printableLines(where + run_.failed()->describe()) << std::endl;
}

void StartScript::finish() {
  bool failed = run_.failed().has_value();
  if (!options_.junit.empty()) {
    const auto& all = run_.outcomes();
    const std::vector<robotlink::ScriptOutcome> ofScript(all.begin() + static_cast<std::ptrdiff_t>(before_),
                                                         all.end());
    const auto written = robotlink::writeFileAtomically(options_.junit, robotlink::junitXml(ofScript));
    if (!written) std::cerr << options_.junit << ": " << written.error().text << std::endl;
    failed |= !written;
  }
  Q_EMIT finished(failed ? kFailed : kDone);
}

}  // namespace app
