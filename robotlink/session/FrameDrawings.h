// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"

namespace robotlink {

/// The coordinate system of drawings, and with it their message type.
enum class DrawingKind {
  kImage,  ///< foxglove.ImageAnnotations, in pixels
  kField,  ///< foxglove.SceneUpdate, in the field's frame
  kRobot,  ///< foxglove.SceneUpdate, in the robot's frame
};

/// The prefix of the paths of a robot's drawings of a kind, "red1/drawings/image/"; the name of the debug key
/// follows.
/// What solutions draw in the shadow of the active ones is that of another robot: "red1/shadow/kalman".
std::string drawingPrefix(const std::string& robot, DrawingKind kind);

/// A robot and those of its shadows that have ever drawn: "red1", "red1/shadow/kalman".
std::vector<std::string> withShadows(const StreamStore& store, const std::string& robot);

/// The drawings to show at a time, sorted by name; the drawings of a frame appear and disappear together.
///
/// A drawing is current if it belongs to the latest complete frame of its process (FrameInfo) that is not
/// later than `time`. A drawing whose key is not on in every frame (n times, every n frames, every n ms)
/// stays until its next one arrives or its key is switched off. Modes are taken from the key table of that
/// time. Messages without a frame number (in some logs) are matched to frames by their time. Pointers are
/// valid until the store changes.
std::vector<const StreamMessage*> currentDrawings(const StreamStore& store, const std::string& robot,
                                                  DrawingKind kind, Instant time);

/// Whether a drawing belongs to the latest frame of its process at that time. One that stays longer shows the
/// state of an earlier frame next to newer data.
bool isOfLatestFrame(const StreamStore& store, const std::string& robot, const StreamMessage& drawing,
                     Instant time);

}  // namespace robotlink
