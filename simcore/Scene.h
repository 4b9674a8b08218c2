// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {
struct GroundMap;
}

namespace simcore {

/// Robots that are put into a world besides those of its file.
struct RobotsToAdd {
  /// A folder of resources/scenes/models, or beside the scene's file; empty: more of the kind that the scene
  /// has, Pioneers where it has no robots.
  std::string model = "p3at";
  int count = 0;
  std::string namePrefix = {};  ///< "p3at" calls them p3at1, p3at2, ...; empty: the model's name
  std::uint64_t seed = 1;       ///< decides about the free places
  /// Teams that robots with a part in their team's color are added to, each to the one with the fewest: the
  /// name of a team is that of a palette's color, and "red" calls them red1, red2, ... Others ignore it;
  /// empty: they belong to none.
  std::vector<std::string> teams = {};
};

/// A world as its file describes it, checked and ready for any number of simulations: an SDFormat 1.9 file,
/// or a map of a building's floor (robotlink::GroundMap), whose lines and points become walls. Immutable.
class Scene {
 public:
  struct Robot {
    std::string name;         ///< "red1"
    std::string description;  ///< which resources/robots/<description>.yaml it is: "ers210"
    std::string team = {};    ///< the color of its team in the scene's palette; empty: the scene names none
  };

  /// Reads a world file. `model://NAME` is looked for below the folder of the file and below
  /// resources/scenes/models. Every error carries file and line. A file called *.map is a map.
  ///
  /// Robots to add stand at the homes of a map or, by their teams, of a field first, then at free places that
  /// can be reached from there, apart from each other and with room to turn; never in walls, in forbidden
  /// areas or outside. It is an error if there is no room for all of them, or where the free places of a
  /// scene cannot be known.
  static tl::expected<std::shared_ptr<const Scene>, robotlink::Errors> load(const std::filesystem::path& file,
                                                                            const RobotsToAdd& robots = {});

  ~Scene();
  const std::filesystem::path& file() const;
  const std::vector<Robot>& robots() const;  ///< in the order of the world's models; added ones last
  /// Which resources/fields/<name>.yaml the world shows ("2002"); empty if it shows none.
  const std::string& field() const;
  /// The names of all balls.
  const std::vector<std::string>& balls() const;
  /// The map that the world was made from; null if there is none.
  std::shared_ptr<const robotlink::GroundMap> groundMap() const;

  struct Implementation;
  const Implementation& implementation() const { return *implementation_; }

 private:
  Scene();
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simcore
