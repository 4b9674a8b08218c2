// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace simcore {

/// A robot that stands in a world.
struct SceneRobot {
  std::string name;         ///< "red1"
  std::string description;  ///< which resources/robots/<description>.yaml it is: "ers210"
  std::string team = {};    ///< the color of its team in the scene's palette; empty: the scene names none
};

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

}  // namespace simcore
