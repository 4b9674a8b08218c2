// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/ConnectionGraph.h"
#include "robotlink/foxglove/session/remote/RemoteInbox.h"
#include "robotlink/foxglove/session/remote/RemoteRobotList.h"
#include "robotlink/foxglove/session/remote/SessionClientOptions.h"
#include "robotlink/foxglove/session/remote/TimeShift.h"
#include "robotlink/session/LatchedMessages.h"
#include "robotlink/session/Session.h"

namespace robotlink::websocket {

/// The implementation of a SessionClient: the state of the server, the subscriptions, and the conversion of
/// messages and requests. Everything belongs to the session's thread, except the client and what its handlers
/// use: the inbox.
class RemoteSession {
 public:
  RemoteSession(Session& sharedSession, SessionClientOptions chosen);

  ClientHandlers handlers();
  /// Connects now, and again after each cut. Without it, messages of a server can be put into the client.
  void connect();
  void tick();

  // From the server.
  void onConnected(const ServerInfo& info);
  void onChannels(const std::vector<RemoteChannelPtr>& added);
  void onServices(const std::vector<std::string>& added, const std::vector<std::string>& removed);
  void onParameters(const std::vector<Parameter>& parameters);
  void onStatus(const Status& status);
  void onGraph(const ConnectionGraphUpdate& update);
  /// Puts a text about this connection among those of the first robot.
  void publishText(StatusLevel level, const std::string& text);
  /// Names the channels whose messages are not decoded, once each.
  void nameUndecoded();
  void onMessage(const RemoteInbox::Arrival& arrival);
  void enter(StreamMessage message);
  void pushKeys(RemoteRobotList::Robot& robot);
  /// The one who steers, and whether it is this session.
  PackagePtr shownSteering(const std::string& path, const PackagePtr& value);
  void onNumber(std::uint64_t value);
  Instant timeOf(const std::string& path, Instant remote, bool latched);
  /// Enters again, with this time, what is latched with a later one.
  void setBack(Instant time);

  bool leads() const { return !options.leadingTime || !options.leadingTime(); }
  bool wants(const RemoteChannel& channel);
  bool isOtherCoding(const RemoteChannel& channel) const;
  /// Returns the suffix of the paths of the images that are wanted: kJpegChannel, kPngChannel; empty: raw.
  std::string_view wantedCoding() const;
  /// The server offers JPEG, since the line does not carry raw images; returns what follows, as a sentence.
  std::string takeJpegOffer(const std::string& text);
  void updateSubscriptions();
  void updateRates();
  void updateChannelKeys();
  /// Publishes the nodes of a foreign server, as far as there are any.
  void pushProcesses();
  void lookAtRestart();
  void lookAtGaps(const ConnectionState& state);
  void endGap(Instant time);
  RemoteRobotList::Place placeOf(const RemoteChannel& channel);

  void setKey(RemoteRobotList::Robot& robot, const robotcontrol::Request& request);
  /// Tells the robot which mode this client has chosen for a key, or that it has withdrawn its choice.
  void sendChoice(const RemoteRobotList::Robot& robot, const std::string& key);
  void forward(const std::string& robot, const robotcontrol::Request& request);
  void answer(std::uint64_t id, bool isAccepted, const std::string& reason);

  /// The time of a stream's newest message, at the server and in the session.
  struct Times {
    Instant remote, mapped;
  };

  Session& session;
  const SessionClientOptions options;
  RemoteInbox inbox;
  RemoteRobotList robots;
  TimeShift shift;
  std::map<std::string, Times> newestOf;
  std::map<std::uint64_t, RemoteChannelPtr> channels;
  /// Topics of encoded images that are offered in addition to the raw ones.
  std::set<std::string> encoded;
  std::set<std::string> services, topics;
  /// Topics that were named since their messages are not decoded.
  std::set<std::string> undecoded;
  /// Robots, by their names at the server, whose tables of keys are shown differently now.
  std::set<std::string> changedKeys;
  /// The messages to be pushed again when the session was restarted.
  LatchedMessages latched;
  std::vector<SessionGap> gaps;
  RemoteImages images = RemoteImages::kAutomatic;
  /// The rate of each stream, in images a second; 0: all.
  double imageRate = 0;
  /// Whether the server has found that the line does not carry raw images.
  bool isNarrow = false;
  /// The number by which the server knows this client; 0: not yet known.
  std::uint64_t number = 0;
  /// The steering of each robot, as the server says, by the path in the session.
  std::map<std::string, std::shared_ptr<const robotcontrol::SteeringStatus>> steering;
  /// A foreign server's.
  ConnectionGraph graph;
  std::string serverSession;
  bool isOurs = false, hasChanged = false, hasGap = false, hasLed = true, hasOtherGraph = false;
  std::uint64_t restarts = 0;
  /// When the connection was lost and made, by the client's clock.
  Instant lostAt, connectedAt;
  /// When it was looked for channels that are not decoded.
  Instant lookedAtChannels;
  const std::shared_ptr<Client> client;
  /// Calls the handlers, so it goes first. Null until connect().
  std::unique_ptr<Connector> connector;
};

}  // namespace robotlink::websocket
