// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"
#include "simcore/meshes/MeshFiles.h"
#include "simcore/world/LeftOut.h"
#include "simcore/world/Palette.h"
#include "simcore/world/WorldDescription.h"

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

class SceneFiles;
class SdfSpec;

/// The reader's inputs and its list of problems. A bundle of references; one thread at a time.
struct SdfSources {
  const SceneFiles& files;
  const SdfSpec& spec;
  MeshFiles& meshes;
  robotlink::Errors& errors;
  LeftOuts& leftOut;
};

/// Converts a model of a file that passed checkSdfTree(), with libsdformat and with all models in it: their
/// links and joints become its own, with names like "arm::hand". Only problems that appear when frames and
/// units are resolved are reported. Null after errors. `isStatic` overrides what the model says.
std::shared_ptr<const ModelDescription> readSdfModel(const tinyxml2::XMLElement& model,
                                                     const std::string& file, const SdfSources& sources,
                                                     std::optional<bool> isStatic = {});

/// The pose of a model file's model in its file: its <pose>, resolved.
Pose3 ownPoseOf(const tinyxml2::XMLElement& model);

/// Converts a world: everything except the included models. If frames of the world or joints connect its
/// models, these are among the models, too, and `includesRead` is set.
WorldDescription readSdfWorld(const SdfSources& sources, bool& includesRead);

/// Converts the six numbers of an SDFormat <pose>: x y z roll pitch yaw.
Pose3 poseFromNumbers(const std::array<double, 6>& numbers);

/// Returns the mode of a <robotcontrol:motion>: "physics" or "kinematic", with its attribute `objects`:
/// "push", "stop" or nothing. Unset for anything else.
std::optional<MotionMode> motionModeOf(const std::string& text, const std::string& atObjects);
inline constexpr const char* kMotionRule =
    "<robotcontrol:motion> is physics or kinematic, and its attribute objects is push or stop";
inline constexpr const char* kDrivesStop =
    "a model with <robotcontrol:drive> stops at objects when it moves kinematically; it cannot push them";
inline constexpr const char* kMotionNeeds =
    "only a model with servos, <robotcontrol:drive>, vehicle, walk, or guided on the ground can move "
    "kinematically";

}  // namespace simcore
