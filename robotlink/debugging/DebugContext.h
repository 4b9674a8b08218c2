// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Image.h"
#include "robotlink/debugging/DebugKey.h"
#include "robotlink/debugging/drawing/Drawings.h"
#include "robotlink/process/Link.h"

namespace foxglove {
class SceneEntity;
}
namespace robotcontrol {
class KeyMode;
}

namespace robotlink {

struct SharedDebugMessage;
struct SharedDebugQueue;

/// Severity of a text, as in foxglove.Log.
enum class Level : std::uint8_t { kDebug, kInfo, kWarning, kError };

/// The debugging state of one process: modes and counters of the debug keys, and the messages that the
/// process has sent since its queue was last taken. Passed to the constructors of solutions; only for the
/// process's thread.
///
/// Usage, so that nothing is computed unless it was requested:
///
///     if (debug.on(kCircleKey)) debug.imageDrawing(kCircleKey).circle(center, radius, colors::kOrange, 1);
///
/// The messages of a frame are enqueued as a whole at its end, with a FrameInfo last. The queue is bounded:
/// when it is full, the oldest whole frames are dropped and their messages counted. Messages sent between
/// frames belong to the next frame. A drawing that was begun is sent even if it is empty, so that the
/// previous one disappears.
class DebugContext {
 public:
  /// The queue's limit.
  struct Options {
    std::size_t maxQueueBytes = 8U << 20U;
  };
  DebugContext(std::string process, const Clock& clock, Options options);
  ~DebugContext();
  DebugContext(const DebugContext&) = delete;
  DebugContext& operator=(const DebugContext&) = delete;

  /// Whether the code of a key is to run now. Each call counts: "n times" is true for n calls and then
  /// switches itself off; "every n" is true at each n-th call; "every n ms" at the first call and then at
  /// least n ms apart in frame time. A key that is off costs one branch.
  bool on(const DebugKey& key) {
    const State& state = states_[static_cast<std::size_t>(key.index())];
    return state.kind != 0 && dueNow(key.index());
  }

  // These publish to the stream of a key: call them only if on() returned true for the key in this frame.
  /// Coordinates in pixels of the image that the frame processes.
  ImageDrawing imageDrawing(const ImageDrawingKey& key);
  /// Coordinates in meters in the field frame.
  SceneDrawing fieldDrawing(const FieldDrawingKey& key);
  /// Coordinates in meters in the robot's frame (origin on the ground, x to the front).
  SceneDrawing robotDrawing(const RobotDrawingKey& key);
  /// Publishes a copy of an image; of several in a frame only the last is sent. Empty images are ignored.
  void image(const ImageKey& key, const ImageView& image);
  /// Publishes a value of a curve, at the time of the frame.
  void plot(const PlotKey& key, double value, const char* unit = "");
  /// Publishes a value of one of several curves of a key: key "ball-model/position", curve "x".
  void plot(const PlotKey& key, const char* curve, double value, const char* unit = "");

  /// Logs a text from `source` ("ball-percept"); needs no key. Bytes that are not UTF-8 are replaced.
  void text(Level level, std::string_view source, std::string text);
  /// Publishes a package under a path; it is shared, not copied. The message that is returned can be changed
  /// until the next one is added.
  SharedDebugMessage& package(const std::string& path, PackagePtr package);

  // The rest is for the process that owns the context.
  /// The name of the robot is the frame of robotDrawing() and image().
  void setRobot(std::string robot) { robot_ = std::move(robot); }
  /// Sets a key's mode and resets its counter. Unknown keys and modes are ignored.
  void setMode(int key, const robotcontrol::KeyMode& mode);
  /// A key that has used up its n times is OFF but keeps its n; one that was switched off has n = 0.
  robotcontrol::KeyMode mode(int key) const;
  /// Sets the timestamp and number of the messages that follow.
  void beginFrame(Instant now, std::uint64_t number);
  /// The time of the current frame.
  Instant frameTime() const;
  /// Moves the messages that another context has in the present frame to this one, their paths behind a
  /// prefix. Texts stay on the stream of all texts, where `author` follows their source in parentheses.
  void take(DebugContext& other, const std::string& prefix, const std::string& author);
  /// Completes the frame with its FrameInfo and enqueues its messages.
  void endFrame();
  /// Adds a message with the time of the frame and an empty content, which the caller fills in.
  template <typename T>
  T& add(const std::string& path) {
    auto content = std::make_shared<T>();
    T& result = *content;
    package(path, std::move(content));
    return result;
  }
  /// Whether a complete frame is queued.
  bool hasQueue() const;
  /// Removes and returns the messages of all complete frames since the last call.
  std::shared_ptr<SharedDebugQueue> takeQueue();
  /// How many messages were dropped in total because the queue was full.
  std::uint64_t dropped() const { return dropped_; }

 private:
  /// The mode of a key and its counter.
  struct State {
    /// A robotcontrol::KeyMode::Kind; 0 is OFF.
    std::uint8_t kind = 0;
    std::uint32_t n = 0;
    std::uint32_t count = 0;
    /// The time of the last use, for EVERY_MS.
    Instant last;
  };
  struct Frame;
  bool dueNow(int key);
  /// The content of the current frame for a key; added if there is none yet.
  template <typename T>
  T& contentFor(const DebugKey& key);
  /// The entity of a scene drawing of the current frame.
  foxglove::SceneEntity& entityFor(const DebugKey& key, const std::string& frame);

  std::string process_;
  std::string robot_;
  const Clock& clock_;
  Options options_;
  /// Indexed by the key's index.
  std::vector<State> states_;
  std::unique_ptr<Frame> frame_;
  std::uint64_t dropped_ = 0;
};

}  // namespace robotlink
