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

/// Where models were in the last seconds, from the history of the transforms or, for robots whose true poses
/// nobody knows, from what they believed. Going on in time adds places; a jump of the instant that is shown
/// looks them up anew. Field's frame, metres. GUI thread.
class Trails {
 public:
  /// Names of models by the names of their frames, which are children of the field.
  using Frames = std::map<std::string, std::string>;
  /// Paths of robotcontrol.RobotPose by the names of robots.
  using Estimates = std::map<std::string, std::string>;
  struct Sources {
    Frames frames;
    Estimates estimates;
  };
  using Places = std::map<std::string, std::deque<robotlink::Vector2>>;
  /// How far back: ten seconds, unless it is said.
  void setReach(robotlink::Duration reach);
  void update(const robotlink::StreamStore& store, const Sources& sources, robotlink::Instant shown);
  void clear() { places_.clear(); }
  const Places& places() const { return places_; }

 private:
  void add(const robotlink::StreamStore& store, const Sources& sources, robotlink::Instant at);
  void addPlace(const std::string& model, const robotlink::Vector2& place);

  robotlink::Duration reach_ = std::chrono::seconds(10);
  Places places_;
  robotlink::Instant last_;
};

}  // namespace widgets
