// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace simcore {
class Scene;
struct SceneRobot;
}  // namespace simcore

namespace app {

// Find resources that a scene names and that do not exist. Each returns errors with file positions; empty if
// all exist.

/// The description of a robot's kind.
robotlink::Errors missingKind(const simcore::Scene& scene, const simcore::SceneRobot& robot);
/// Its layout, if the scene names one.
robotlink::Errors missingLayout(const simcore::Scene& scene, const simcore::SceneRobot& robot);
/// The field.
robotlink::Errors missingField(const simcore::Scene& scene);
/// The rules of the game.
robotlink::Errors missingGame(const simcore::Scene& scene);

/// Says how many parts of its files a scene leaves out (Scene::leftOut()), and how to see them; empty: none.
std::string leftOutText(const simcore::Scene& scene);

/// All of what is missing.
robotlink::Errors missingResources(const simcore::Scene& scene);

}  // namespace app
