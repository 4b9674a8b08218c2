// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"

namespace robotlink {

enum class DrawingKind {
  kImage,  ///< foxglove.ImageAnnotations, in pixels
  kField,  ///< foxglove.SceneUpdate, in the field's frame
  kRobot,  ///< foxglove.SceneUpdate, in the robot's frame
};

/// Where a robot's drawings of a kind are: "red1/drawings/image/". The name of the debug key follows.
std::string drawingPrefix(const std::string& robot, DrawingKind kind);

/// The names of all drawings of a kind that a robot has ever sent, in order: those of their debug keys.
std::vector<std::string> drawingNames(const StreamStore& store, const std::string& robot, DrawingKind kind);

/// The drawings to be shown at a time, in order of their names: a frame's drawings appear together and
/// disappear together.
///
/// A drawing is current if it belongs to the latest complete frame of its process (FrameInfo) that is not
/// later than `time`. One whose key is not on in every frame (n times, every n, every n ms) stays until its
/// next one comes, or until its key is switched off. Modes are those of the key table of that time; frames of
/// messages that do not say theirs (some logs) are told by time. Pointers are valid until the store changes.
std::vector<const StreamMessage*> currentDrawings(const StreamStore& store, const std::string& robot,
                                                  DrawingKind kind, Instant time);

/// Whether a drawing is of the latest frame of its process at that time. One that stays longer shows what an
/// earlier frame saw, beside what is newer.
bool isOfLatestFrame(const StreamStore& store, const std::string& robot, const StreamMessage& drawing,
                     Instant time);

}  // namespace robotlink
