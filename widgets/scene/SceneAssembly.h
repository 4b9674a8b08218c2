// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/process/Link.h"
#include "widgets/scene/render/SceneFrame.h"
#include "widgets/world/SceneState.h"
#include "widgets/world/WorldDrawings.h"

class QPalette;

namespace foxglove {
class SceneUpdate;
}

namespace widgets {

/// Converts the scene, its poses and the robots' drawings into bodies for the renderer. The shape of each
/// entity is computed once and kept while the entity is shown. GUI thread.
class SceneAssembly {
 public:
  /// The entities of the scene at their poses; those in unknown frames are left out.
  std::vector<SceneBody> bodies(const SceneState& scene);
  /// The collision shapes of a message of the stream "solids", at their poses; null: none. `calm`: in calm
  /// colors of this palette instead of those of the message, one for each model; fixed ones are nearly
  /// gray.
  std::vector<SceneBody> solids(const robotlink::PackagePtr& message, const SceneState& scene,
                                const QPalette* calm = nullptr);
  /// The drawings at their poses, lowest first.
  std::vector<SceneBody> drawings(const std::vector<WorldDrawing>& drawings);
  /// The texts of the drawings.
  static std::vector<SceneLabel> labels(const std::vector<SceneBody>& drawings);

 private:
  /// A cached shape.
  struct Shape {
    /// Keeps the entity alive, so that no other one can have its address.
    robotlink::PackagePtr keep;
    std::shared_ptr<const SceneShape> shape;
    /// Whether it was used since the last forgetUnused().
    bool used = true;
  };
  /// Keyed by the entities' addresses.
  using Shapes = std::map<const foxglove::SceneEntity*, Shape>;
  static const std::shared_ptr<const SceneShape>& shape(Shapes& shapes, const foxglove::SceneEntity* entity,
                                                        const robotlink::PackagePtr& keep);
  /// Drops the shapes that were not used in this call.
  static void forgetUnused(Shapes& shapes);
  /// Converts all solids of a message.
  void readSolids(const foxglove::SceneUpdate& update, const QPalette* calm);

  Shapes sceneShapes_, drawingShapes_;
  /// A collision shape; its entity is part of solidsMessage_.
  struct Solid {
    const foxglove::SceneEntity* entity = nullptr;
    std::shared_ptr<const SceneShape> shape;
    /// Null: not known.
    std::shared_ptr<const std::string> object;
  };
  std::vector<Solid> solids_;
  /// The message of which solids_ are, and the color of its first model; invalid: those of the message.
  robotlink::PackagePtr solidsMessage_;
  QColor solidsColor_;
};

/// The first thing on a ray.
struct SceneHit {
  /// Name of the movable model; empty: something that cannot be moved.
  std::string model;
  /// In the field's frame.
  robotlink::Vector3 point;
  /// The path of the object, see SceneBody::object; empty: not known.
  std::string object = {};
  /// The model that it belongs to, also one that cannot be moved; empty: not known.
  std::string owner() const { return model.empty() ? object.substr(0, object.find('/')) : model; }
};
/// Unset if the ray, which is in the field's frame, hits nothing.
std::optional<SceneHit> firstHit(const std::vector<SceneBody>& bodies, const Ray& ray);

/// Whether a model is the surroundings of the others, as a field or a room is: it cannot be moved, and it is
/// wide in all directions, compared with what moves. A wall, however long, is not. Takes as long as
/// firstHit().
bool isSurroundings(const std::string& model, const std::vector<SceneBody>& bodies);

}  // namespace widgets
