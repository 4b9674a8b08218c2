// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/session/History.h"
#include "robotlink/session/RemoteRobot.h"
#include "robotlink/session/StreamReaders.h"
#include "robotlink/session/StreamStore.h"
#include "robotlink/session/Timeline.h"

namespace robotcontrol {
class Request;
class RequestResult;
}  // namespace robotcontrol

namespace robotlink {

struct SharedDebugQueue;

/// The data behind one window: robots on platforms with one clock, the history of their messages, and the way
/// to send them requests. Views know only this; they cannot tell whether a robot is simulated, real or
/// logged.
///
/// Streams of a robot are "<robot>/<path>" (DebugMessage.path); those of the whole world are "scene"
/// (SceneUpdate), "transforms" (FrameTransforms), "simulation" (SimulationStatus). See
/// robotlink/session/STREAMS.md.
///
/// push...() may be called from any thread and never blocks on the GUI; everything else only from the thread
/// that calls tick().
///
/// Pushed messages wait in a bounded inbox. If tick() is not called, the oldest are dropped first, whole
/// queues at a time, so that the messages of a frame stay together; of tables, which are sent only when they
/// change, the newest are kept.
class Session {
 public:
  /// Limits of the inbox between two ticks.
  struct InboxLimits {
    std::size_t messages = 50'000;
    std::size_t bytes = 128U << 20U;
  };
  /// Forwards requests to the platform or program that can fulfill them. Called in the thread that calls
  /// request(); must not block. Results come back through pushResult() or pushQueue().
  using RequestSink = std::function<void(const robotcontrol::Request&)>;
  /// Called once with the result of a request, from tick().
  using ResultHandler = std::function<void(const robotcontrol::RequestResult&)>;
  /// The refused request in words ("set key of red1"), and the reason.
  using RefusalHandler = std::function<void(const std::string& what, const std::string& reason)>;
  /// Follows what goes through a session: each message as tick() moves it into the history, each request that
  /// is made, and its result. Functions may be empty.
  struct Listener {
    std::function<void(const StreamMessage&)> message = {};
    std::function<void(const robotcontrol::Request&)> request = {};
    /// The result of a request, in tick(), before its own handler gets it, and after.
    std::function<void(const robotcontrol::RequestResult&)> result = {};
    std::function<void(const robotcontrol::RequestResult&)> handled = {};
    /// Called for a refusal, see RefusalHandler.
    RefusalHandler refusal = {};
  };

  explicit Session(StreamStore::Limits limits = {});
  Session(StreamStore::Limits limits, InboxLimits inboxLimits);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // For producers, any thread.
  /// Enqueues a message; ignored if it has no value or no path.
  void push(StreamMessage message);
  /// Enqueues messages that belong together, such as those of a logged frame: they are kept or dropped as a
  /// whole.
  void push(std::vector<StreamMessage> messages);
  /// Enqueues the contents of a debug queue without copying them. Messages without a path or contents are
  /// dropped and counted; a missing time is replaced by that of a neighbor.
  void pushQueue(const std::string& robot, const std::shared_ptr<const SharedDebugQueue>& queue);
  /// Enqueues the result of a request; results of unknown or already answered requests are ignored.
  void pushResult(const robotcontrol::RequestResult& result);
  /// Drops the whole history, including what is still in the inbox, because the messages pushed from now on
  /// come from another platform or from another place in a log. The timeline goes live. Results of requests
  /// are not affected.
  ///
  /// What is pushed while `publish` runs is applied by one tick as a whole; until then the history stays as
  /// it was, so that no view sees half of it. One thread at a time.
  void restart(const std::function<void()>& publish = {});
  /// How often it was restarted.
  std::uint64_t restarts() const;

  // Only in the GUI's thread.
  /// Moves the inbox into the history, updates the timeline, then calls the result handlers. Called at 30 Hz.
  void tick();
  StreamStore& store() { return store_; }
  Timeline& timeline() { return timeline_; }
  const Timeline& timeline() const { return timeline_; }
  /// Looks back while the robots continue: pauses the timeline and moves it.
  History& history() { return history_; }
  /// Knows which views read which streams.
  StreamReaders& readers() { return readers_; }
  /// The number of messages that were dropped because tick() was late or because they were invalid, plus
  /// those that the robots' own queues and the store dropped.
  std::uint64_t dropped() const;

  /// Replaces the list of robots; if the selected one is gone, the first one is selected.
  void setRobots(std::vector<std::string> robots);
  const std::vector<std::string>& robots() const { return robots_; }
  /// The robot that toolbars, and views without a robot of their own, refer to; empty if there is none.
  const std::string& selectedRobot() const { return selectedRobot_; }
  /// Ignores unknown robots.
  void selectRobot(const std::string& robot);

  /// Sets how those robots are connected whose programs run elsewhere, by their names; the others are not in
  /// it.
  void setRemoteRobots(std::map<std::string, RemoteRobot> robots) { remoteRobots_ = std::move(robots); }
  const std::map<std::string, RemoteRobot>& remoteRobots() const { return remoteRobots_; }

  /// An empty sink disconnects: requests are then refused.
  void setRequestSink(RequestSink sink);
  /// Called from tick() for refusals of requests that had no result handler, so that none goes unnoticed.
  void setRefusalHandler(RefusalHandler handler);
  /// Passes a refusal to that handler, for requests whose result handler does something else with it, too.
  void reportRefusal(const std::string& what, const std::string& reason);
  /// Adds a listener until it is removed; returns its id. Listeners are called in the order of their ids.
  std::uint64_t addListener(Listener listener);
  /// Must not be called by a listener.
  void removeListener(std::uint64_t id);
  /// Sends a request and returns its id, which is filled in here. `onResult` is called once, from tick(), if
  /// a result arrives; beyond ten thousand pending requests the oldest are abandoned. Without a sink the
  /// result is a refusal.
  std::uint64_t request(robotcontrol::Request request, ResultHandler onResult = {});

 private:
  struct Inbox;
  struct Pending;
  void await(std::uint64_t id, ResultHandler onResult);

  StreamStore store_;
  Timeline timeline_;
  History history_{store_, timeline_};
  StreamReaders readers_{store_};
  /// The messages pushed since the last tick. Shared with producers and protected by its own mutex.
  /// Everything else belongs to the GUI's thread.
  std::unique_ptr<Inbox> inbox_;
  /// Result handlers of requests that have no result yet.
  std::unique_ptr<Pending> pending_;
  RequestSink sink_;
  RefusalHandler refused_;
  /// Keyed by id.
  std::map<std::uint64_t, Listener> listeners_;
  std::uint64_t nextListener_ = 1;
  std::vector<std::string> robots_;
  std::string selectedRobot_;
  std::map<std::string, RemoteRobot> remoteRobots_;
};

}  // namespace robotlink
