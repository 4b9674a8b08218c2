// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Whether a link of a model is a wheel of its drive.
bool isWheel(const ModelDescription& model, int link);

/// Says for each link of a model of which link's rigid body it is a part: of the first one to which fixed
/// joints connect it, or its own. A solver holds such links together by forces, and they sag; as one body
/// they cannot. Links whose damping or weight differs stay apart, and so do those that another joint
/// connects, too. Wheels are their own.
std::vector<int> rigidParts(const ModelDescription& model);

/// Combines all links whose body is that of `link` (see rigidParts()), and the wheels that they carry, into
/// one rigid piece in the frame of `link`: the masses are added, the solids are those of `link` alone. A link
/// without others is returned unchanged. Rotating wheels keep only their inertia about other axes than their
/// own.
LinkDescription lumpedLink(const ModelDescription& model, const std::vector<int>& parts, int link);

}  // namespace simcore
