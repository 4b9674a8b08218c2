// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/foxglove/server/ServerOptions.h"

namespace robotlink::websocket {

/// Tracks who steers which robot over a link. A robot stops when its person falls silent.
///
/// The client that sends the first motion, goal or command to a base steers the robot, unless that is only to
/// stand; others are refused until its person gives up, goes, is silent, commands nothing for a while, or
/// another takes over. The same person may continue over a new connection. Users at the robot itself need not
/// ask. A motion holds for `commandTime` and has to be repeated; a goal holds as long as the
/// link of its person lives, and is set again when the same person is heard again. One thread.
class Steering {
 public:
  struct Limits {
    /// How long a motion holds that is not repeated.
    Duration commandTime = std::chrono::milliseconds(500);
    /// How long a link may be silent.
    Duration linkTime = std::chrono::seconds(1);
    /// The time without a command, and without a goal, after which others may steer without taking over.
    Duration idleTime = std::chrono::seconds(10);
    /// A goal is not set again after a longer silence.
    Duration resumeTime = std::chrono::seconds(60);
    bool operator==(const Limits&) const = default;
  };
  /// The state of the steering of a robot.
  struct Status {
    /// The name of the client that steers; empty: none.
    std::string who;
    /// 0: none, or a user at the robot's own machine.
    std::uint64_t client = 0;
    bool isSilent = false;
    std::string text;
    bool operator==(const Status&) const = default;
  };
  struct Actions {
    /// Asks a robot to stand, or to continue to its goal; `isDone` is to be called with whether it accepted.
    std::function<void(const robotcontrol::Request&, std::function<void(bool isDone)>)> request;
    /// Called after a change.
    std::function<void(const std::string& robot, const Status&)> changed;
    /// Returns when a client was last heard from; nothing if it is gone.
    std::function<std::optional<Instant>(std::uint64_t client)> heardAt;
  };

  Steering(Limits limits, Actions actions) : limits_(limits), actions_(std::move(actions)) {}

  /// Whether a request lets a robot move.
  static bool isSteering(const robotcontrol::Request& request);

  /// A client wants to steer. Returns why it may not, or nothing: then it steers, and the request is to be
  /// passed on. A motion that is only to stand is passed on, too, but who sends it does not steer for that.
  std::string admit(const ClientInfo& client, const robotcontrol::Request& request, Instant now);
  /// Gives control of a robot to a client, even if another one has it; the robot stays still until the next
  /// command.
  void takeOver(const ClientInfo& client, const std::string& robot, Instant now);
  void giveUp(const ClientInfo& client, const std::string& robot, Instant now);
  /// Call this when a local user (at the robot's own machine) sends a motion request.
  void noteLocal(const robotcontrol::Request& request, Instant now);
  /// Gives control of a robot to the local user, even if a client has it; the robot stays still until it is
  /// commanded.
  void takeOverHere(const std::string& robot, Instant now);
  /// Releases the control that the local user has of a robot.
  void giveUpHere(const std::string& robot);
  /// Call this when a client has connected, perhaps one that steered before its line was lost.
  void joined(const ClientInfo& client);
  /// Lets all robots stand that clients steer, because the link ends.
  void end();
  /// Checks the time limits; call this often.
  void tick(Instant now);
  /// Forgets a robot.
  void remove(const std::string& robot) { robots_.erase(robot); }

  const Limits& limits() const { return limits_; }
  /// The person or program that steers a robot.
  Status status(const std::string& robot) const;
  /// The clients whose links must be monitored closely.
  std::set<std::uint64_t> clients() const;

 private:
  struct Robot {
    /// 0: none, or a user at the robot's own machine.
    std::uint64_t client = 0;
    /// The name by which a person is recognized after a lost connection.
    std::string person;
    std::string who;
    Instant commandedAt;
    /// The newest motion, unless that was to stand.
    std::optional<robotcontrol::Request> motion;
    std::optional<robotcontrol::Request> goal;
    /// When the link fell silent; the robot was told to stand.
    std::optional<Instant> silentSince;
    /// The requests to the robot from here, until they are accepted.
    std::deque<robotcontrol::Request> toAsk;
    /// The id of the request that has no answer yet, so that late answers to others do not count.
    std::uint64_t asking = 0;
    Instant askAt;
    Status published;
  };

  void begin(const std::string& name, Robot& robot, const ClientInfo& client, Instant now);
  static void note(Robot& robot, const robotcontrol::Request& request, Instant now);
  void stand(const std::string& name, Robot& robot);
  void watchMotion(const std::string& name, Robot& robot, Instant now);
  void watchLink(const std::string& name, Robot& robot, Instant now);
  void forgetIdle(const std::string& name, Robot& robot, Instant now);
  /// Sends the pending requests, repeatedly until they are accepted.
  void ask(const std::string& name, Robot& robot, Instant now);
  void publish(const std::string& name, Robot& robot, const std::string& text);
  bool isFree(const Robot& robot, const ClientInfo& client, Instant now) const;
  /// Whether a client that was last heard from at an instant has probably reconnected since.
  bool isOutdated(std::uint64_t client, Instant heardAt, Instant now) const;

  const Limits limits_;
  const Actions actions_;
  std::map<std::string, Robot> robots_;
  /// When clients that steered were silent or gone last.
  std::map<std::uint64_t, Instant> silentAt_;
  std::uint64_t nextAsking_ = 1;
};

}  // namespace robotlink::websocket
