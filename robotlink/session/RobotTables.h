// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "robotlink/session/Session.h"

namespace robotcontrol {
class KeyTable;
class SolutionTable;
}  // namespace robotcontrol

// Functions that return the tables that the selected robot's program published last. Only in the thread that
// ticks the session, whose next tick may destroy what is returned.
namespace robotlink {

/// Null if there is none.
const robotcontrol::KeyTable* keyTable(Session& session);
const robotcontrol::SolutionTable* solutionTable(Session& session);
/// Whether the program has reported all tasks of the processes that it runs. They report one after the other,
/// in their first frames, if the program is not paused.
bool areTasksKnown(Session& session);
/// Their names, for lists and completion.
std::vector<std::string> keyNames(Session& session);
std::vector<std::string> taskNames(Session& session);
/// Packages that a robot's program has, and those in whose place users hold values, at an instant.
std::set<std::string> programPackages(const StreamStore& store, const std::string& robot, Instant time);
std::set<std::string> heldPackages(const StreamStore& store, const std::string& robot, Instant time);
std::vector<std::string> solutionNames(Session& session, const std::string& task);
/// The solution that the robot's program uses for a task now; empty: it has no such task.
std::string activeSolution(const StreamStore& store, const std::string& robot, const std::string& task);

}  // namespace robotlink
