// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/own/OwnProgramOptions.h"
#include "app/core/program/HostedProgram.h"
#include "robotcontrol/ProgramWire.pb.h"

namespace app {

/// Returns the parts of a program in a process of its own, as they go over the wire; without the ports of
/// its platform.
robotcontrol::WireSetup wireSetup(const HostedProgram::Parts& parts, const OwnProgramOptions& options);
/// The layout of such a setup. Positions in files are lost on the way.
robotlink::Layout layoutIn(const robotcontrol::WireLayout& wire);

}  // namespace app
