// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Builds a description in ODE. `description` must outlive the result. With `kinematicDrives`, models with a
/// drive follow their odometry.
std::unique_ptr<OdeWorld> buildOdeWorld(const WorldDescription& description, bool kinematicDrives = false);

}  // namespace simcore
