// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/FrameDrawings.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"

namespace robotlink {
namespace {

using robotcontrol::FrameInfo;
using robotcontrol::KeyMode;
using robotcontrol::KeyTable;

/// The robot whose program publishes "red1" or, in the shadow of a solution, "red1/shadow/kalman".
std::string ownerOf(const std::string& robot) {
  return robot.substr(0, robot.find(std::string("/") + streams::kShadow));
}

// The key table of that time; before the first table, the first one.
const KeyTable* keyTableAt(const StreamStore& store, const std::string& robot, Instant time) {
  const std::string path = ownerOf(robot) + "/" + streams::kKeys;
  if (const auto* table = store.latestAs<KeyTable>(path, time)) return table;
  const auto* stream = store.find(path);
  if (!stream || stream->messages.empty()) return nullptr;
  return dynamic_cast<const KeyTable*>(stream->messages.front().value.get());
}

const KeyMode* modeOf(const KeyTable* table, const std::string& key) {
  if (!table) return nullptr;
  const auto found = std::find_if(table->keys().begin(), table->keys().end(),
                                  [&](const KeyTable::Key& entry) { return entry.name() == key; });
  return found == table->keys().end() ? nullptr : &found->mode();
}

// How long the last drawing of a key is shown, according to the key's mode.
enum class Stay { kUntilNextFrame, kUntilNextDrawing, kNotAtAll };

Stay stayOf(const KeyMode* mode) {
  if (!mode || mode->kind() == KeyMode::ALWAYS) return Stay::kUntilNextFrame;
  // Off with a number means that its n times have been used up (see DebugContext::mode).
  if (mode->kind() == KeyMode::OFF && mode->n() == 0) return Stay::kNotAtAll;
  return Stay::kUntilNextDrawing;
}

bool isFrameOf(const StreamMessage& drawing, const StreamMessage* frame) {
  if (!frame) return false;
  const auto* info = dynamic_cast<const FrameInfo*>(frame->value.get());
  if (info && drawing.frame != 0) return info->number() == drawing.frame;
  return frame->time == drawing.time;
}

}  // namespace

bool isOfLatestFrame(const StreamStore& store, const std::string& robot, const StreamMessage& drawing,
                     Instant time) {
  const std::string prefix = ownerOf(robot) + "/" + streams::kFrames;
  if (!drawing.process.empty()) return isFrameOf(drawing, store.latest(prefix + drawing.process, time));
  const auto frames = store.streams(prefix);
  return frames.empty() || std::any_of(frames.begin(), frames.end(), [&](const StreamStore::Stream* stream) {
           return isFrameOf(drawing, store.latest(stream->path, time));
         });
}

std::string drawingPrefix(const std::string& robot, DrawingKind kind) {
  const char* stream = kind == DrawingKind::kImage   ? streams::kImageDrawings
                       : kind == DrawingKind::kField ? streams::kFieldDrawings
                                                     : streams::kRobotDrawings;
  return robot + "/" + stream;
}

std::vector<std::string> withShadows(const StreamStore& store, const std::string& robot) {
  std::vector<std::string> all{robot};
  const std::string prefix = robot + '/' + streams::kShadow;
  for (const auto* stream : store.streams(prefix)) {
    const auto drawings = stream->path.find("/drawings/", prefix.size());
    if (drawings == std::string::npos) continue;
    std::string shadow = stream->path.substr(0, drawings);
    if (shadow != all.back()) all.push_back(std::move(shadow));
  }
  return all;
}

std::vector<const StreamMessage*> currentDrawings(const StreamStore& store, const std::string& robot,
                                                  DrawingKind kind, Instant time) {
  const std::string prefix = drawingPrefix(robot, kind);
  const KeyTable* table = keyTableAt(store, robot, time);
  std::vector<const StreamMessage*> current;
  for (const auto* stream : store.streams(prefix)) {
    const StreamMessage* drawing = store.latest(stream->path, time);
    if (!drawing) continue;
    const Stay stay = stayOf(modeOf(table, stream->path.substr(prefix.size())));
    const bool shown = stay == Stay::kUntilNextDrawing ||
                       (stay == Stay::kUntilNextFrame && isOfLatestFrame(store, robot, *drawing, time));
    if (shown) current.push_back(drawing);
  }
  return current;
}

}  // namespace robotlink
