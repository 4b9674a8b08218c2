// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/platforms/simulated/SimulatedRun.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// The whole robot program on the simulated robot of resources/scenes/field2002.sdf, in lockstep, with access
/// to the outputs of its solutions and to the ground truth. Poses are those at the timestamp of a package,
/// not at its arrival.
class PlayedGame {
 public:
  /// The ground truth at some instant.
  struct Truth {
    robotlink::Pose2 robotInField;
    robotlink::Vector2 ballInRobot = robotlink::Vector2::Zero();
    robotlink::Pose3 cameraInRobot = robotlink::Pose3::Identity();
  };
  /// Solutions that replace those of the layout `compact`, by task.
  using Solutions = std::map<std::string, std::string>;
  explicit PlayedGame(Solutions solutions = {}, app::SimulatedWorld::Options world = {});

  void placeRobot(const robotlink::Pose2& pose);
  void placeBall(const robotlink::Vector2& place);
  void run(double seconds);

  /// Calls back with every following package of this name and the ground truth at its timestamp. T: its type.
  template <typename T>
  void watch(const std::string& package, std::function<void(const T&, const Truth&)> callback) {
    show(package, [callback](const std::string& bytes, const Truth& truth) {
      T parsed;
      if (parsed.ParseFromString(bytes)) callback(parsed, truth);
    });
  }
  void select(const std::string& task, const std::string& solution);
  /// Turns a debug key on.
  void publish(const std::string& key);
  /// The paths of all debug messages so far: "drawings/image/ball-percept/disc".
  const std::set<std::string>& paths() const { return paths_; }

  double time() const;
  Truth truth() const;
  std::uint64_t ballContacts() const;
  /// Texts of the programs: "ball-percept: ...".
  const std::vector<std::string>& texts() const { return texts_; }
  app::SimulatedRun& simulation() { return *run_; }

 private:
  using Listener = std::function<void(const std::string& bytes, const Truth& truth)>;
  void show(const std::string& package, Listener listener);
  void receive(const robotlink::SharedDebugQueue& queue);

  std::unique_ptr<app::SimulatedRun> run_;
  std::map<std::string, Listener> listeners_;
  std::map<robotlink::Instant, Truth> truths_;
  std::vector<std::string> texts_;
  std::set<std::string> paths_;
};

}  // namespace modules
