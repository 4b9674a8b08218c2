// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"
#include "simcore/world/Palette.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

class SdfSpec;

/// Converts the text of a model file to a description, with libsdformat. `file` is the name that errors
/// carry. The text must have passed checkSdfTree(); this reader reports only problems that appear when frames
/// and units are resolved. Returns null after adding errors.
std::shared_ptr<const ModelDescription> readSdfModel(const std::string& text, const std::string& file,
                                                     const Palette& palette, const SdfSpec& spec,
                                                     robotlink::Errors& errors);

/// Converts the text of a world file without its <include> elements: everything except the included models.
/// Errors are added as by readSdfModel().
WorldDescription readSdfWorld(const std::string& text, const std::string& file, const Palette& palette,
                              const SdfSpec& spec, robotlink::Errors& errors);

/// Converts the six numbers of an SDFormat <pose>: x y z roll pitch yaw.
Pose3 poseFromNumbers(const double (&numbers)[6]);

}  // namespace simcore
