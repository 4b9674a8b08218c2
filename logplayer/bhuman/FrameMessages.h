// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "logplayer/bhuman/Payloads.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer::bhuman {

// From what payloads hold to packages, on the paths below the robot; process and frame are unset.

enum class Level : std::uint8_t { kInfo, kWarning };

robotlink::StreamMessage cameraImage(const robotlink::Image& image, const std::string& frame,
                                     robotlink::Instant time);
robotlink::StreamMessage cameraPose(const CameraPlace& place, const CameraOptics& optics,
                                    robotlink::Instant time);
robotlink::StreamMessage jointStates(const JointAngles& joints, robotlink::Instant time);
/// The acceleration only: the paws of the package and its distance sensor are those of another robot.
robotlink::StreamMessage bodySensors(const SensorReadings& sensors, robotlink::Instant time);
robotlink::StreamMessage bodyReadings(const std::vector<Reading>& readings, robotlink::Instant time);
/// The odometry only.
robotlink::StreamMessage motionStatus(const robotlink::Pose2& odometry, robotlink::Instant time);
/// What is no UTF-8 is replaced by "?".
robotlink::StreamMessage text(const std::string& text, Level level, const std::string& name,
                              robotlink::Instant time);
robotlink::StreamMessage frameInfo(const std::string& process, std::uint64_t number, robotlink::Instant time);

}  // namespace logplayer::bhuman
