// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/foxglove/session/remote/SessionClientOptions.h"
#include "robotlink/session/Session.h"

namespace robotlink::websocket {

class RemoteSession;

/// Puts the robots of one server into a session, where views cannot tell them from hosted ones: channels
/// become messages of the same streams, and requests become calls of services, whose results are the
/// session's. Several of these and a local platform may share one session. It connects by itself, and again
/// after each cut, with everything that was asked for; the history stays, and gaps() says what is missing.
///
/// **Subscriptions.** Tables, states and texts always; the output of a debug key while this session
/// switched the key on (SetKey with mode ALWAYS), or the robot itself did. Such a request becomes a
/// subscription: it ends with this object, is asked for again after a cut (so it is accepted during one), and
/// other clients' wishes do not show in this session's key table.
///
/// **Times.** The connection that leads (no `leadingTime`) keeps the robot's times. Any other connection's
/// times are shifted so that its newest message is at the leading time when it begins, and again when they
/// are apart by more than half a second, at most by the time that passed; they never go back. A robot that
/// was restarted continues after the gap. So no other machine's clock moves the session's time.
///
/// **Names.** A robot keeps its name unless `isTaken`; then "-2", "-3" is appended. Streams without a robot
/// (scene, transforms, map, simulation) are those of the connection that leads.
///
/// **Foreign servers** (any of the Foxglove WebSocket protocol, such as foxglove_bridge) count as one robot,
/// named after the server: "/camera/image" is the stream "NAME/camera/image". Protobuf and JSON are decoded;
/// other encodings are named by streams(). Images and other heavy channels have debug keys, off at first.
///
/// One thread, that of Session::tick(), except for the link's thread inside. Nothing blocks.
class SessionClient {
 public:
  using Options = SessionClientOptions;
  using Gap = SessionGap;
  using Stream = RemoteStream;
  using Images = RemoteImages;

  /// `session` must outlive this object.
  SessionClient(Session& session, Options options);
  ~SessionClient();
  SessionClient(const SessionClient&) = delete;
  SessionClient& operator=(const SessionClient&) = delete;

  /// Handles what arrived since the last call. Call it before Session::tick().
  void tick();

  const ServerUrl& url() const;
  ConnectionState state() const;
  /// For users, at this moment: "connected, 12 ms, 1.3 MB/s".
  std::string stateText() const;

  /// The server's robots by their names in the session; they stay while the connection is lost.
  const std::vector<std::string>& robots() const;
  /// Increases with each change of robots().
  std::uint64_t robotsVersion() const;
  /// Whether the robot of the request is one of these; or, if this one leads, it is of no robot and the
  /// server knows it.
  bool takes(const robotcontrol::Request& request) const;
  /// For the session's request sink: sends it, STOP before all others. The result arrives by
  /// Session::pushResult(), at the latest when its time is over, and reports a lost connection.
  void request(const robotcontrol::Request& request);

  /// Takes control of a robot, even if another client has it, or gives control up. The handler is called
  /// once, from any thread; nothing if the server does not know that robot.
  void steer(const std::string& robot, bool giveUp, std::function<void(Result<void>)> done);

  /// In order of time, the newest thousand.
  const std::vector<Gap>& gaps() const;
  std::vector<Stream> streams() const;
  /// The newest time of its messages in the session.
  std::optional<Instant> newest() const;

  /// Call this when what `alsoWanted` says has changed.
  void updateSubscriptions();
  /// How images are sent; at first automatic.
  void setImages(Images images);
  /// How many images a second the server may send of each stream; 0: all. What it leaves out it counts as
  /// thinned.
  void setImageRate(double imagesPerSecond);
  /// Bytes a second that the server may send; 0 without limit.
  void setBudget(double bytesPerSecond);
  /// Whether the server offers a session of this program, with robots and maybe a world; foreign servers do
  /// not. As it was while the connection is lost; false before the first one.
  bool hasSession() const;
  /// Whether the server has a service of this name, by its name there.
  bool hasService(const std::string& name) const;
  /// For features that sessions do not have: client channels, parameters, playback.
  Client& client();

 private:
  const std::unique_ptr<RemoteSession> parts_;
};

}  // namespace robotlink::websocket
