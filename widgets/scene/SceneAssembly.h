// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/process/Link.h"
#include "widgets/models/SceneState.h"
#include "widgets/models/WorldDrawings.h"
#include "widgets/scene/SceneFrame.h"

namespace widgets {

/// Makes what is to be drawn from the scene, the poses and the drawings; shapes are made once for each
/// entity. GUI thread.
class SceneAssembly {
 public:
  std::vector<SceneBody> bodies(const SceneState& scene);
  std::vector<SceneBody> drawings(const std::vector<WorldDrawing>& drawings);
  /// The texts of the drawings.
  static std::vector<SceneLabel> labels(const std::vector<SceneBody>& drawings);

 private:
  struct Shape {
    robotlink::PackagePtr keep;  ///< so that no other entity takes this one's address
    std::shared_ptr<const SceneShape> shape;
    bool used = true;
  };
  using Shapes = std::map<const foxglove::SceneEntity*, Shape>;
  static const std::shared_ptr<const SceneShape>& shape(Shapes& shapes, const foxglove::SceneEntity* entity,
                                                        const robotlink::PackagePtr& keep);
  static void forgetUnused(Shapes& shapes);

  Shapes sceneShapes_, drawingShapes_;
};

/// What a ray, in the field's frame, meets first.
struct SceneHit {
  std::string model;  ///< empty: something that can not be moved
  robotlink::Vector3 point;
};
std::optional<SceneHit> firstHit(const std::vector<SceneBody>& bodies, const Ray& ray);

}  // namespace widgets
