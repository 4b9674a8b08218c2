// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace simcore {

/// A robot in a world.
struct SceneRobot {
  std::string name;         ///< "red1"
  std::string description;  ///< the name of its file in resources/robots: "ers210"
  std::string team = {};    ///< the color of its team in the scene's palette; empty: the scene names none
};

/// Robots to put into a world in addition to those of its file.
struct RobotsToAdd {
  /// The model: a folder of resources/scenes/models or next to the scene's file. Empty: the same as the
  /// scene's first robot, or Pioneers if it has none.
  std::string model = "p3at";
  // How many to add.
  int count = 0;
  /// With "p3at" they are called p3at1, p3at2, ...; empty: the model's name is the prefix.
  std::string namePrefix = {};
  /// For the random choice of free places.
  std::uint64_t seed = 1;
  /// Teams for robots that have a part in their team's color; each robot joins the team with the fewest
  /// members. A team's name is the name of its color in the palette and the prefix of its robots' names:
  /// "red" gives red1, red2, ... Other robots ignore this. Empty: no teams.
  std::vector<std::string> teams = {};
};

}  // namespace simcore
