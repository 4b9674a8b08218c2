// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sdf/Element.hh>
#include <sdf/SDFImpl.hh>

namespace simcore {

/// For the sources that see libsdformat only.
struct SdfDescription {
  sdf::SDFPtr text;
};

}  // namespace simcore
