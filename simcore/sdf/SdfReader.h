// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"
#include "simcore/world/Palette.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

class SdfSpec;

/// Turns the text of a model file into a description, by libsdformat. `file` is the name that errors carry.
/// What the text says must have passed checkSdfTree(): this reader finds what needs frames and units to be
/// resolved.
std::shared_ptr<const ModelDescription> readSdfModel(const std::string& text, const std::string& file,
                                                     const Palette& palette, const SdfSpec& spec,
                                                     robotlink::Errors& errors);

/// The same for a world file without its <include> elements: everything but the included models.
WorldDescription readSdfWorld(const std::string& text, const std::string& file, const Palette& palette,
                              const SdfSpec& spec, robotlink::Errors& errors);

/// Reads six numbers x y z roll pitch yaw as SDFormat's <pose> has them.
Pose3 poseFromNumbers(const double (&numbers)[6]);

}  // namespace simcore
