// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sdf/Element.hh>
#include <sdf/SDFImpl.hh>

#include "simcore/sdf/SdfSpec.h"

namespace simcore {

/// For the sources that see libsdformat only.
struct SdfSpec::Implementation {
  sdf::SDFPtr description;
};

}  // namespace simcore
