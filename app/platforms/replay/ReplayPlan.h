// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/process/Layout.h"

namespace app {

/// The user's selection of what to run on a log, the input of planReplay(). A plain value.
struct ReplaySelection {
  /// The whole layout, with the solutions that are requested.
  robotlink::Layout layout;
  /// Packages that the log contains.
  std::set<std::string> logged;
  /// Packages that the debug process offers.
  std::vector<std::string> debugOffers;
  /// Solutions that cannot be constructed for this robot, by task and solution, with the reason.
  std::map<std::pair<std::string, std::string>, std::string> broken;
  /// Whether the layout is the log's and so may belong to another program: tasks and solutions that are not
  /// known here are then unavailable instead of errors.
  bool fromLog = false;
  /// The sources that the user chose, by package.
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  /// Whether everything that can be recomputed is, unless `packages` says otherwise.
  bool recomputeAll = false;
};

/// The part of a layout that runs on a log, and the source of each package. Logged packages replace the tasks
/// that yield them, unless the user chooses to recompute them; what is not logged is recomputed if possible,
/// but where only other solutions than the requested one yield it, no task requires it, and other packages of
/// its task are logged.
/// A task whose packages all are as logged leaves the layout, and so does a task that lacks an input; a
/// process leaves with its last task. A plain value.
struct ReplayPlan {
  /// A package of the log or of the layout, and its source.
  struct Package {
    std::string name;
    /// The process of the whole layout that yields it; empty: the platform.
    std::string process;
    bool logged = false;
    /// Whether a solution that yields it could run.
    bool canRecompute = false;
    /// The reason why it cannot be recomputed: "nobody offers joints/states"; empty if it can.
    std::string whyNot;
    /// AS_LOGGED or RECOMPUTED.
    robotcontrol::ControlReplay::PackageSource source = robotcontrol::ControlReplay::RECOMPUTED;
    /// Whether the user chose the source.
    bool chosen = false;
  };
  /// The rest of the layout, with all absent tasks and the reasons.
  robotlink::Layout layout;
  /// Sorted by name.
  std::vector<Package> packages;
  /// Tasks that cannot run, with the reason: "motion: nobody offers joints/states".
  std::vector<std::string> unavailable;
  /// A sentence for each task that is done by another solution than requested: "task ball-model is done by
  /// filtered, because oracle is unavailable: nobody offers oracle/world".
  std::vector<std::string> notes;
  /// The reasons for these, by task.
  std::map<std::string, std::string> replaced;

  /// Whether a task of the layout is left.
  bool runs(const std::string& task) const;
  /// Returns null if there is no such package.
  const Package* find(const std::string& package) const;
  /// Whether a package comes from the log.
  bool isAsLogged(const std::string& package) const;
};

/// Makes the plan. Fails if a package cannot come from the source that the user chose, or if what is left of
/// the layout cannot run.
tl::expected<ReplayPlan, robotlink::Errors> planReplay(ReplaySelection selection,
                                                       const robotlink::TaskCatalog& catalog);

}  // namespace app
