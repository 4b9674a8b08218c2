// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/config/FieldDescription.h"

namespace app {

/// Returns the SDFormat 1.9 model of a field: ground, walls, corner triangles, goals and beacons as static
/// solids, lines as visuals only, so that no robot trips over them, and the palette, so that all models of a
/// world can name its colors. `name` is that of the description's file ("2002"), by which a scene refers to
/// its field.
///
/// A pure function. resources/scenes/models/field2002/model.sdf is its result for resources/fields/2002.yaml,
/// and a test compares the two; run that test with ROBOTCONTROL_REGENERATE=1 to write the file again.
std::string fieldModelSdf(const robotlink::FieldDescription& field, const std::string& name);

}  // namespace app
