// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/program/RobotHost.h"

namespace app {

class PublishGate;

/// Returns listeners of a robot that publish all that they get through a gate, which must outlive them.
RobotHost::Listeners listenersOf(PublishGate& gate);

}  // namespace app
