// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Image.h"
#include "robotlink/debugging/DebugKey.h"
#include "robotlink/debugging/Drawings.h"

namespace google::protobuf {
class Message;
}
namespace foxglove {
class SceneEntity;
}
namespace robotcontrol {
class DebugMessage;
class DebugQueue;
class KeyMode;
}  // namespace robotcontrol

namespace robotlink {

enum class Level : std::uint8_t { kDebug, kInfo, kWarning, kError };

/// The debugging state of one process: modes and counters of the debug keys, and what the process has told
/// since its queue was last taken. Handed to the constructors of solutions; used by its process's thread
/// only.
///
/// Usage, so that nothing is computed unless somebody asked:
///
///     if (debug.on(kCircleKey)) debug.imageDrawing(kCircleKey).circle(center, radius, colors::kOrange, 1);
///
/// What a frame tells is handed over whole at its end, a FrameInfo last. The queue is bounded; what does not
/// fit is dropped, oldest whole frames first, and its messages are counted. What is told outside frames
/// belongs to the next. A drawing that is begun is sent even if nothing is drawn, so that the one before it
/// disappears.
class DebugContext {
 public:
  struct Options {
    std::size_t maxQueueBytes = 8U << 20U;
  };
  DebugContext(std::string process, const Clock& clock, Options options);
  ~DebugContext();
  DebugContext(const DebugContext&) = delete;
  DebugContext& operator=(const DebugContext&) = delete;

  /// Whether a key's code shall run now. Counts: n times is true n times and then turns off; every n is true
  /// at each n-th call; every n ms at the first call and then at least n ms apart, by the times of the
  /// frames. A key that is off costs one branch.
  bool on(const DebugKey& key) {
    const State& state = states_[static_cast<std::size_t>(key.index())];
    return state.kind != 0 && dueNow(key.index());
  }

  // What follows goes to the stream of the key: call it only where on() was true for this key in this frame.
  /// Coordinates in pixels of the image the frame works on.
  ImageDrawing imageDrawing(const DebugKey& key);
  /// Coordinates in metres in the field's frame.
  SceneDrawing fieldDrawing(const DebugKey& key);
  /// Coordinates in metres in the robot's frame (on the ground, x to the front).
  SceneDrawing robotDrawing(const DebugKey& key);
  /// One image a frame and key: the last.
  void image(const DebugKey& key, const ImageView& image);
  void plot(const DebugKey& key, double value, const char* unit = "");
  /// Several curves under one key: "ball-model/position" with the curve "x".
  void plot(const DebugKey& key, const char* curve, double value, const char* unit = "");

  /// A text from `source` ("ball-percept"); always sent.
  void text(Level level, std::string_view source, std::string text);
  /// A package under the key's stream, serialised.
  robotcontrol::DebugMessage& package(const std::string& path, const google::protobuf::Message& package);

  // The rest is for the process that owns the context.
  void setRobot(std::string robot) { robot_ = std::move(robot); }
  /// Starts counting anew. Unknown keys and kinds are ignored.
  void setMode(int key, const robotcontrol::KeyMode& mode);
  /// A key whose n times are over is OFF, but keeps its n; one that was switched off has n = 0.
  robotcontrol::KeyMode mode(int key) const;
  void beginFrame(Instant now, std::uint64_t number);
  /// Completes the frame; its messages can be taken from now on.
  void endFrame();
  robotcontrol::DebugMessage& add(const std::string& path);
  bool hasQueue() const;
  /// All complete frames' messages since the last call.
  std::shared_ptr<robotcontrol::DebugQueue> takeQueue();
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct State {
    std::uint8_t kind = 0;  // KeyMode.Kind
    std::uint32_t n = 0;
    std::uint32_t count = 0;
    Instant last;
  };
  struct Frame;
  bool dueNow(int key);
  /// The message of this frame for a key in a stream, a new one if there is none.
  robotcontrol::DebugMessage& messageFor(const char* stream, const DebugKey& key);
  foxglove::SceneEntity& entityFor(const char* stream, const DebugKey& key, const std::string& frame);

  std::string process_;
  std::string robot_;
  const Clock& clock_;
  Options options_;
  std::vector<State> states_;  // by key index
  std::unique_ptr<Frame> frame_;
  std::uint64_t dropped_ = 0;
};

}  // namespace robotlink
