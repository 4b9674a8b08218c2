// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simcore/world/WorldDescription.h"

namespace simcore {

/// A world for a model that was opened alone: it is at `pose`, raised if parts of it would be below the
/// floor; the floor is called "floor", and a directional light shines.
WorldDescription worldOfModel(std::shared_ptr<const ModelDescription> type, const Pose3& pose);

}  // namespace simcore
