// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotcontrol/Debugging.pb.h"

namespace robotlink {

class Process;

/// The begin of the state of a process whose task does not return; that task follows.
inline constexpr char kDoesNotReturn[] = "does not return from ";

/// Describes a process's state and its senders and receivers, but not its tasks, which it does not know. Any
/// thread.
void describe(const Process& process, robotcontrol::ProcessTable::Process& to);

}  // namespace robotlink
