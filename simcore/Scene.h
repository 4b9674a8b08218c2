// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/world/LeftOut.h"
#include "simcore/world/SceneRobots.h"

namespace robotlink {
struct GroundMap;
}

namespace simcore {

struct ModelInstance;
struct SceneContents;
struct WorldDescription;

/// A model of a scene.
struct SceneModel {
  std::string name;
  /// The file that describes it.
  std::string file;
  bool isStatic = false;
};

/// Texts that count instead of what files have, such as those that are being edited; by the whole path, with
/// links resolved, of each file.
using SceneTexts = std::map<std::filesystem::path, std::string>;

/// Called with how much of a scene is loaded, in [0, 1]; returns whether to continue.
using LoadProgress = std::function<bool(double share)>;

/// A world as its file describes it, checked and ready for any number of simulations: an SDFormat file (1.2
/// to 1.12; see sdf/SCENES.md), a model alone, which then stands on a floor, or a map of a building's floor
/// (robotlink::GroundMap), whose lines and points become walls. Immutable.
class Scene {
 public:
  using Robot = SceneRobot;

  /// Reads a world file, or a map (see SceneFileKind.h). `model://NAME` is searched below `modelFolders`, the
  /// file's folder, and further ones (sdf/ModelSearch.h). All errors are reported, each with file and line.
  ///
  /// Robots to add stand at the homes of a map or, by their teams, of a field first, then at free places that
  /// can be reached from there, apart from each other and with room to turn; never in walls, in forbidden
  /// areas or outside. It is an error if there is no room for all of them, or where the free places of a
  /// scene cannot be known.
  ///
  /// Large maps take seconds: `progress` is called several times per second, and can end it with the error
  /// "scene.given-up". `texts` are for SDFormat files; maps are read from the disk.
  static tl::expected<std::shared_ptr<const Scene>, robotlink::Errors> load(
      const std::filesystem::path& file, const RobotsToAdd& robots = {}, const LoadProgress& progress = {},
      const std::vector<std::filesystem::path>& modelFolders = {}, const SceneTexts& texts = {});

  ~Scene();

  // The same scene with other models, for a simulation that continues (Simulation::continueIn()). Types,
  // meshes and the map are shared; the file stays as it is. Each costs about as much as drawing the scene
  // once.
  /// With one more model, the last one; its file is read now. Fails with all errors if it cannot be read, the
  /// name is taken, or the palette lacks the team's color.
  tl::expected<std::shared_ptr<const Scene>, robotlink::Errors> with(const ModelToAdd& model) const;
  /// With an instance, as the model with this index, or as the last one. Fails if its name is taken.
  robotlink::Result<std::shared_ptr<const Scene>> with(const ModelInstance& model, std::size_t index) const;
  /// Fails if there is no such model, or if it is the last one.
  robotlink::Result<std::shared_ptr<const Scene>> without(const std::string& model) const;
  /// The first name of this kind that no model has: "crate", or the prefix with a number, "red3".
  std::string freeName(const std::string& prefix, bool numbered) const;

  /// The path as given to load().
  const std::filesystem::path& file() const;
  /// In the order of the world's models; added robots come last.
  const std::vector<Robot>& robots() const;
  /// All models, in the order of the world.
  std::vector<SceneModel> models() const;
  /// The name of the field in the world (resources/fields/<name>.yaml, "2002"); empty if there is none.
  const std::string& field() const;
  /// The names of all balls.
  const std::vector<std::string>& balls() const;
  /// The parts of the files that the simulation does not have.
  const LeftOuts& leftOut() const;
  /// The world as its files describe it.
  const WorldDescription& world() const;
  /// The map from which the world was built; null if the file is not a map.
  std::shared_ptr<const robotlink::GroundMap> groundMap() const;

  /// Only for simcore's own sources and tests.
  const SceneContents& contents() const { return *contents_; }

 private:
  Scene();
  std::unique_ptr<SceneContents> contents_;
};

}  // namespace simcore
