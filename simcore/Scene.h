// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/SceneRobots.h"

namespace robotlink {
struct GroundMap;
}

namespace simcore {

struct SceneContents;

/// A world as its file describes it, checked and ready for any number of simulations. The file is an SDFormat
/// 1.9 file, or the map of a building's floor (robotlink::GroundMap), whose lines and points become walls.
/// Immutable; any thread.
class Scene {
 public:
  using Robot = SceneRobot;

  /// Reads a world file; a file named *.map is a map. `model://NAME` is searched below the file's folder and
  /// below resources/scenes/models. All errors are reported, each with file and line.
  ///
  /// Robots to add are placed first at the homes of a map or, by team, of a field; then at free places that
  /// can be reached from there, with distance to each other and room to turn, never in walls, in forbidden
  /// areas or outside. It is an error if there is not enough room, or if the scene does not allow to tell
  /// which places are free.
  static tl::expected<std::shared_ptr<const Scene>, robotlink::Errors> load(const std::filesystem::path& file,
                                                                            const RobotsToAdd& robots = {});

  ~Scene();
  /// The path as given to load().
  const std::filesystem::path& file() const;
  /// In the order of the world's models; added robots come last.
  const std::vector<Robot>& robots() const;
  /// The name of the field in the world (resources/fields/<name>.yaml, "2002"); empty if there is none.
  const std::string& field() const;
  /// The names of all balls.
  const std::vector<std::string>& balls() const;
  /// The map from which the world was built; null if the file is not a map.
  std::shared_ptr<const robotlink::GroundMap> groundMap() const;

  /// Only for simcore's own sources and tests.
  const SceneContents& contents() const { return *contents_; }

 private:
  Scene();
  std::unique_ptr<SceneContents> contents_;
};

}  // namespace simcore
