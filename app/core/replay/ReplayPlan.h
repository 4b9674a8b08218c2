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

/// What shall run on a log.
struct ReplaySelection {
  robotlink::Layout layout;              ///< whole, with the solutions that are wished for
  std::set<std::string> logged;          ///< packages that the log holds
  std::vector<std::string> debugOffers;  ///< packages that the debug process offers
  /// Solutions that cannot be made on this robot, and why, by task and solution.
  std::map<std::pair<std::string, std::string>, std::string> broken;
  /// The layout may be of another program: tasks and solutions that are not known here are unavailable, no
  /// errors.
  bool fromLog = false;
  /// What a person chose, by package.
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  bool recomputeAll = false;  ///< whatever can be recomputed is, unless `packages` says otherwise
};

/// What runs on a log, and what comes from it. Whatever is logged takes the place of the tasks that yield it,
/// unless it is chosen to be recomputed; what is not logged is recomputed if it can be. Tasks all of whose
/// packages are as logged leave the layout, and so do tasks that need what nobody offers any more. A process
/// goes with its last task. A plain value.
struct ReplayPlan {
  struct Package {
    std::string name;
    std::string process;  ///< of the whole layout that yields it; empty: the platform
    bool logged = false;
    bool canRecompute = false;
    std::string whyNot;  ///< "nobody offers joints/states"; empty if it can be recomputed
    robotcontrol::ControlReplay::PackageSource source = robotcontrol::ControlReplay::RECOMPUTED;
    bool chosen = false;  ///< by a person
  };
  robotlink::Layout layout;              ///< what is left, with all absent tasks and why
  std::vector<Package> packages;         ///< by name
  std::vector<std::string> unavailable;  ///< "motion: nobody offers joints/states"
  /// Where another solution than the layout's had to be taken: "task ball-model is done by filtered, because
  /// oracle is unavailable: nobody offers oracle/world".
  std::vector<std::string> notes;
  std::map<std::string, std::string>
      replaced;  ///< by task: why it is not done by the solution that was wished for

  bool runs(const std::string& task) const;
  bool hasProcess(const std::string& process) const;
  const Package* find(const std::string& package) const;
  bool isAsLogged(const std::string& package) const;
};

/// Fails if a package cannot be had as a person chose, or if what is left of the layout cannot be run.
tl::expected<ReplayPlan, robotlink::Errors> planReplay(ReplaySelection selection,
                                                       const robotlink::TaskCatalog& catalog);

}  // namespace app
