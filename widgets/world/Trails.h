// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
class StreamStore;
}

namespace widgets {

/// The positions of models during the last seconds: true ones from the history of the transforms, estimated
/// ones of robots and ball from that of the robots' models. When the shown instant advances positions are
/// appended; after a jump, or when the history was replaced, all are read again. Field's frame, meters. GUI
/// thread.
class Trails {
 public:
  /// Names of models by their frames, which are children of the field's frame.
  using Frames = std::map<std::string, std::string>;
  /// Paths of the streams of robotcontrol.RobotPose, by robot.
  using Estimates = std::map<std::string, std::string>;
  /// The sources of a robot's estimate of the ball: paths of robotcontrol.RobotPose and BallModel.
  struct BallSource {
    std::string pose, ball;
    bool operator==(const BallSource&) const = default;
  };
  /// The sources of positions. The keys of `estimates` and `balls`, and the values of `frames`, are
  /// those of places(); each should be in one of them only.
  struct Sources {
    Frames frames;
    Estimates estimates;
    std::map<std::string, BallSource> balls = {};
    bool operator==(const Sources&) const = default;
  };
  /// Positions by model, oldest first, at least 100 ms apart and at most 300.
  using Places = std::map<std::string, std::deque<robotlink::Vector2>>;
  /// Sets the length of the trails in time, 10 s by default; another value clears them.
  void setReach(robotlink::Duration reach);
  /// Appends the positions up to `shown`, or reads all if it is not shortly after the last call, or if the
  /// sources are others.
  void update(const robotlink::StreamStore& store, const Sources& sources, robotlink::Instant shown);
  void clear() { places_.clear(); }
  const Places& places() const { return places_; }

 private:
  /// Appends the positions at one instant.
  void add(const robotlink::StreamStore& store, const Sources& sources, robotlink::Instant at);
  void addPlace(const std::string& model, const robotlink::Vector2& place);

  void addBall(const robotlink::StreamStore& store, const std::string& model, const BallSource& source,
               robotlink::Instant at);

  robotlink::Duration reach_ = std::chrono::seconds(10);
  Places places_;
  /// The sources from which they were read.
  Sources sources_;
  std::uint64_t generation_ = 0;
  /// Instant of the newest positions.
  robotlink::Instant last_;
};

}  // namespace widgets
