// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Makes everything of a description in ODE; `description` must outlive it.
std::unique_ptr<OdeWorld> buildOdeWorld(const WorldDescription& description, bool kinematicDrives = false);

}  // namespace simcore
