// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Whether a link of a model is a wheel of its drive.
bool isWheel(const ModelDescription& model, int link);

/// Combines a link with the wheels that it carries into one rigid piece: the wheels' masses are added, the
/// solids are those of the link. A link without wheels is returned unchanged. Rotating wheels keep only their
/// inertia about other axes than their own.
LinkDescription withWheelsLumped(const ModelDescription& model, int link);

}  // namespace simcore
