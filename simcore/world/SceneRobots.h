// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// A robot in a world.
struct SceneRobot {
  std::string name;         ///< "red1"
  std::string description;  ///< the name of its file in resources/robots: "ers210"
  std::string team = {};    ///< the color of its team in the scene's palette; empty: the scene names none
  /// The process layout of its program: the name of a shipped one, or a file with its whole path. Empty: that
  /// of its description.
  std::string layout = {};
  /// The role of the robot in its team from the start ("goalie"); empty: the team decides.
  std::string role = {};

  bool operator==(const SceneRobot&) const = default;
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

/// A model to be put into a scene that runs.
struct ModelToAdd {
  /// model://NAME, the name of a model's folder, a kind of robot (SceneRobot::description), or a model's
  /// file.
  std::string model;
  /// The name in the scene; empty: the model's, or its team's, with the next free number if it is a robot or
  /// the name is taken.
  std::string name = {};
  /// In the world.
  robotlink::Pose2 place = {};
  /// The height of the model's frame, m; unset: it stands on the floor, or at 0 without one.
  std::optional<double> height = {};
  /// A color of the scene's palette; empty: none.
  std::string team = {};
};

}  // namespace simcore
