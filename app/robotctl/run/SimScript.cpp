// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SimScript.h"

#include <stdlib.h>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "app/core/Workbench.h"
#include "app/core/platform/ExitStatus.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Printable.h"
#include "robotlink/commands/ScriptRun.h"
#include "robotlink/session/RobotTables.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kScriptTick{2};
/// The time that programs may take to report their tasks after they were opened.
constexpr std::chrono::seconds kMaxTablesTime{10};

/// The folder of a user who keeps nothing; removed at the end.
class EmptyUserFolder {
 public:
  EmptyUserFolder() {
    std::error_code unknown;
    std::string name = (std::filesystem::temp_directory_path(unknown) / "robotctl-sim-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~EmptyUserFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  EmptyUserFolder(const EmptyUserFolder&) = delete;
  EmptyUserFolder& operator=(const EmptyUserFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A workbench without a window, with a simulation.
class ScriptedSimulation {
 public:
  explicit ScriptedSimulation(const std::filesystem::path& userFolder) : workbench_(userFolder) {
    // The script reports what is refused later.
    workbench_.onErrors([this](const robotlink::Errors& errors) {
      if (!isOpen_) printErrors(errors);
    });
  }

  /// Waits until the scene is open; returns an ExitStatus.
  int open(const RunOptions& options) {
    workbench_.open(SimulationFeed::opening(options));
    while (workbench_.loading() || awaitsTables()) {
      if (!tick()) return kFailed;
    }
    isOpen_ = workbench_.loaded() != nullptr;
    return isOpen_ ? kDone : kFailed;
  }

  int run(const std::filesystem::path& script) {
    robotlink::ScriptRun run({workbench_.commands(), workbench_.session(), [this] { return isBusy(); }});
    run.setOutput([](const std::string& text) { std::cout << robotlink::printableLines(text) << std::endl; });
    run.runFile(script);
    while (!run.isIdle()) {
      if (!tick()) return kFailed;
      run.tick(clock_.now());
    }
    return run.failed() ? printErrors({*run.failed()}) : kDone;
  }

 private:
  bool tick() {
    workbench_.tick();
    std::this_thread::sleep_for(kScriptTick);
    return !Interrupt::noted();
  }
  bool awaitsTables() {
    const LoadedPlatform* loaded = workbench_.loaded();
    if (loaded == nullptr || loaded->robots.empty()) return false;
    if (!opened_) opened_ = clock_.now();
    return !robotlink::areTasksKnown(workbench_.session()) && clock_.now() - *opened_ < kMaxTablesTime;
  }
  robotlink::Result<bool> isBusy() {
    const robotlink::Errors errors = workbench_.takeOpeningErrors();
    if (!errors.empty()) return robotlink::failure("script.opening", robotlink::describe(errors));
    const auto working = workbench_.working();
    return working && !*working ? robotlink::Result<bool>(workbench_.loading()) : working;
  }

  const robotlink::SteadyClock clock_;
  bool isOpen_ = false;
  Workbench workbench_;
  std::optional<robotlink::Instant> opened_;
};

}  // namespace

int runSimScript(const RunOptions& options, const std::filesystem::path& script) {
  const Interrupt interrupt;
  const EmptyUserFolder folder;
  if (folder.path().empty())
    return printErrors(
        {{"sim.script", "a script needs a temporary folder, which cannot be created", {}, {}}});
  ScriptedSimulation simulation(folder.path());
  const int opened = simulation.open(options);
  return opened == kDone ? simulation.run(script) : opened;
}

}  // namespace app
