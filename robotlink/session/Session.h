// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/session/StreamStore.h"
#include "robotlink/session/Timeline.h"

namespace robotcontrol {
class DebugQueue;
class Request;
class RequestResult;
}  // namespace robotcontrol

namespace robotlink {

/// What one window is about: robots on platforms with one clock, the history of what they told, and the way
/// to ask them for something. Views know only this; whether a robot is simulated, real or logged cannot be
/// told from it.
///
/// Streams: what is said under a robot is "<robot>/<path>" (DebugMessage.path); what belongs to the whole
/// world is "scene" (SceneUpdate), "transforms" (FrameTransforms), "simulation" (SimulationStatus). See
/// robotlink/session/STREAMS.md.
///
/// push...() may be called from any thread and never blocks on the GUI; all else from the thread that calls
/// tick().
///
/// What is pushed waits in an inbox that is bounded. When nobody ticks, what was pushed first is dropped
/// first, whole queues at a time, so that a frame's messages stay together; of tables, which are sent only
/// when they change, the newest stay.
class Session {
 public:
  struct InboxLimits {
    std::size_t messages = 50'000;
    std::size_t bytes = 128U << 20U;
  };
  /// Takes requests to whoever can fulfil them. Called in the thread of the one who asks; must not block.
  /// Results come back as messages.
  using RequestSink = std::function<void(const robotcontrol::Request&)>;
  using ResultHandler = std::function<void(const robotcontrol::RequestResult&)>;
  /// What was asked ("set key of red1"), and why it was refused.
  using RefusalHandler = std::function<void(const std::string& what, const std::string& reason)>;

  explicit Session(StreamStore::Limits limits = {});
  Session(StreamStore::Limits limits, InboxLimits inboxLimits);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Producers, any thread.
  void push(StreamMessage message);
  /// Messages that belong together, such as those of a logged frame: they are kept or dropped as a whole.
  void push(std::vector<StreamMessage> messages);
  /// Its messages become messages of streams without being copied; copies of packages are read into the types
  /// they have. What makes no sense (no path, no contents) is dropped and counted; what has no valid time has
  /// that of its neighbours.
  void pushQueue(const std::string& robot, const std::shared_ptr<const robotcontrol::DebugQueue>& queue);
  void pushResult(const robotcontrol::RequestResult& result);
  /// Forgets what was told, also what still waits: what is pushed from now on is a new telling, of another
  /// platform or from another place of a log. The timeline goes live. Answers to requests are not touched.
  ///
  /// What is pushed while `tell` runs is taken in by one tick as a whole, and until then the history stays as
  /// it was, so that no view ever sees half of it. One thread at a time.
  void restart(const std::function<void()>& tell = {});

  // The GUI's thread.
  /// Takes what was pushed into the history and moves the timeline; then calls the result handlers. Called at
  /// 30 Hz.
  void tick();
  StreamStore& store() { return store_; }
  Timeline& timeline() { return timeline_; }
  /// Messages that were dropped because nobody ticked or that made no sense, plus those that the robots' own
  /// queues dropped.
  std::uint64_t dropped() const;

  void setRobots(std::vector<std::string> robots);
  const std::vector<std::string>& robots() const { return robots_; }
  /// The robot that toolbars and views without one of their own talk about; empty if there is none.
  const std::string& selectedRobot() const { return selectedRobot_; }
  /// Ignores robots that are not there.
  void selectRobot(const std::string& robot);

  void setRequestSink(RequestSink sink);
  /// Called from tick() for what was refused and for whose answer nobody waits, so that no refusal is lost.
  void setRefusalHandler(RefusalHandler handler);
  /// Sends a request; its id is filled in and returned. `onResult` is called once, from tick(), if an answer
  /// comes; the oldest of very many unanswered ones are given up. Without a sink the answer is a refusal.
  std::uint64_t request(robotcontrol::Request request, ResultHandler onResult = {});

 private:
  struct Inbox;
  struct Pending;
  void await(std::uint64_t id, ResultHandler onResult);

  StreamStore store_;
  Timeline timeline_;
  std::unique_ptr<Inbox> inbox_;
  std::unique_ptr<Pending> pending_;
  RequestSink sink_;
  RefusalHandler refused_;
  std::vector<std::string> robots_;
  std::string selectedRobot_;
};

}  // namespace robotlink
