// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "robotlink/foxglove/server/Server.h"
#include "robotlink/foxglove/session/KeyRequests.h"
#include "robotlink/session/Session.h"

namespace robotlink::websocket {

/// Offers a session to clients of the Foxglove WebSocket protocol: robots and worlds, simulated, real or
/// logged, as the session has them.
///
/// - Each stream (robotlink/session/STREAMS.md) is a channel of the same path, encoded as protobuf. So is
///   what a debug key would publish: the key is switched on while somebody subscribes (KeyRequests). What
///   nobody subscribes to is not serialized.
/// - Each request is a service (RequestServices.h); its answer is the result.
/// - Debug keys and solutions are parameters: "red1/keys/ball-percept/disc" is "off", "always", "5 times",
///   "every 3" or "every 200 ms"; "red1/solutions/ball-percept" is the name of a solution.
/// - The processes and their packages are the connection graph.
/// - A log that is open can be played.
///
/// One thread, that of Session::tick(); what clients ask for is done by tick().
class SessionServer {
 public:
  /// Sentences for the robot's log: clients that were refused, and why. Called by the link's thread.
  using Report = std::function<void(const std::string&)>;

  /// `session` must outlive this object.
  explicit SessionServer(Session& session, ServerOptions options = {}, Report report = {});
  ~SessionServer();
  SessionServer(const SessionServer&) = delete;
  SessionServer& operator=(const SessionServer&) = delete;

  /// For a Listener.
  const std::shared_ptr<Server>& server() const { return server_; }

  /// Does what clients asked for since the last time, and announces what is new. Call it after
  /// Session::tick().
  void tick();

 private:
  struct Posted;
  /// A robot of the session, or with an empty name the world, as clients know it.
  struct Robot {
    std::vector<std::uint32_t> services;
    /// The names of its parameters, by group ("keys", "solutions").
    std::map<std::string, std::set<std::string>> parameters;
    /// Types of packages, of the newest table of processes.
    std::map<std::string, std::string> packageTypes;
    robotcontrol::KeyTable keys;
    /// Its processes, with ids such as "red1/cognition", by package.
    ConnectionGraph graph;
  };

  ServerHandlers handlers(Report report);
  // From the session.
  void pass(const StreamMessage& message);
  void notice(const StreamMessage& message);
  void updateRobots();
  void offerServices(const std::string& robot, Robot& to);
  /// Announces the channels of keys that have published nothing yet.
  void offerKeyChannels(const std::string& robot, const Robot& from);
  /// Replaces a group of parameters; `values` by their names in it.
  void offerParameters(const std::string& robot, Robot& to, const std::string& group,
                       const std::map<std::string, std::string>& values);
  /// Says whether there is a log, and where it stands.
  void offerPlayback();
  /// `requestId`: that of the client's request that this answers; empty: of none.
  void publishPlayback(bool didSeek, const std::string& requestId);
  /// Says which keys are on only for subscribers.
  void offerOnDemand(const std::string& robot);
  void noticeProcesses(const std::string& robot, const robotcontrol::ProcessTable& table, Robot& to);
  // From clients.
  Result<robotcontrol::Request> requestFor(const Parameter& parameter) const;
  void set(const std::vector<Parameter>& parameters, const Reply& reply);
  void play(const PlaybackControl& control);
  void call(const std::string& robot, const std::string& service, const ServiceCallRequest& call,
            const Reply& reply);

  Session& session_;
  std::uint64_t listener_ = 0;
  /// What the link's thread asks for.
  std::shared_ptr<Posted> posted_;
  std::shared_ptr<Server> server_;
  KeyRequests keys_;
  std::unordered_map<std::string, ChannelPtr> channels_;
  std::map<std::string, Robot> robots_;
  Instant newest_;
  /// The status of the log that was published last, and the history's generation() then.
  PackagePtr replay_;
  std::uint64_t generation_ = 0;
  /// Clients' requests to play that the log has not answered yet.
  std::size_t plays_ = 0;
};

}  // namespace robotlink::websocket
