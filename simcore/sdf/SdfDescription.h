// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sdf/Element.hh>
#include <sdf/SDFImpl.hh>

namespace simcore {

/// Hides the types of libsdformat; only for the sources that include it.
struct SdfDescription {
  sdf::SDFPtr text;
};

}  // namespace simcore
