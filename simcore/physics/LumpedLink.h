// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Whether a link of a model is a wheel of its drive.
bool isWheel(const ModelDescription& model, int link);

/// A link with the wheels that it carries in one rigid piece: their masses added, its solids its own. A link
/// without wheels is given back as it is. Wheels that turn keep their inertia about any axis but their own.
LinkDescription withWheelsLumped(const ModelDescription& model, int link);

}  // namespace simcore
