// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
class StreamStore;
}

namespace widgets {

/// The positions of models during the last seconds, from the history of the transforms or, for robots whose
/// true poses are unknown, from their pose estimates. When the shown instant advances positions are appended;
/// after a jump all are read again. Field's frame, meters. GUI thread.
class Trails {
 public:
  /// Names of models by their frames, which are children of the field's frame.
  using Frames = std::map<std::string, std::string>;
  /// Paths of the streams of robotcontrol.RobotPose, by robot.
  using Estimates = std::map<std::string, std::string>;
  /// Where positions are read from. A robot should be in one of both only.
  struct Sources {
    Frames frames;
    Estimates estimates;
  };
  /// Positions by model, oldest first, at least 100 ms apart and at most 300.
  using Places = std::map<std::string, std::deque<robotlink::Vector2>>;
  /// How far back the trails reach, 10 s by default; another value clears them.
  void setReach(robotlink::Duration reach);
  /// Appends the positions up to `shown`, or reads all if it is not shortly after the last call.
  void update(const robotlink::StreamStore& store, const Sources& sources, robotlink::Instant shown);
  void clear() { places_.clear(); }
  const Places& places() const { return places_; }

 private:
  /// Appends the positions at one instant.
  void add(const robotlink::StreamStore& store, const Sources& sources, robotlink::Instant at);
  void addPlace(const std::string& model, const robotlink::Vector2& place);

  robotlink::Duration reach_ = std::chrono::seconds(10);
  Places places_;
  /// Instant of the newest positions.
  robotlink::Instant last_;
};

}  // namespace widgets
