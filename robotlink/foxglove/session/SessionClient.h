// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/session/Session.h"

namespace robotlink::websocket {

/// Puts the robots of one server into a session, where views cannot tell them from hosted ones: channels
/// become messages of the same streams, and requests become calls of services, whose results are the
/// session's. Several of these and a local platform may share one session. It connects by itself, and again
/// after each cut, with everything that was asked for; the history stays, and gaps() says what is missing.
///
/// **What is subscribed to.** Tables, states and texts always. What a debug key publishes: while this session
/// switched the key on (SetKey with mode ALWAYS), or the robot itself did. Such a request becomes a
/// subscription: it ends with this object, is asked for again after a cut (so it is accepted during one), and
/// other clients' wishes do not show in this session's key table.
///
/// **Times.** The connection that leads (no `leadingTime`) keeps the robot's times. Any other connection's
/// times are shifted so that its newest message is at the leading time when it begins, and again when they
/// are apart by more than half a second, at most by the time that passed; they never go back. A robot that
/// was started anew continues after the gap. So no other machine's clock moves the session's time.
///
/// **Names.** A robot keeps its name unless `isTaken`; then "-2", "-3" is appended. Streams without a robot
/// (scene, transforms, map, simulation) are those of the connection that leads.
///
/// **Foreign servers** (any of the Foxglove WebSocket protocol, such as foxglove_bridge) count as one robot,
/// named after the server: "/camera/image" is the stream "NAME/camera/image". Protobuf and JSON are decoded;
/// other encodings are named by streams(). Images and other heavy channels have debug keys, off at first.
///
/// One thread, that of Session::tick(), but for what the link's thread does inside. Nothing blocks.
class SessionClient {
 public:
  struct Options {
    Connector::Options connection;
    /// Whether a name of a robot is in use in the session, by others than this object. Empty: none is.
    std::function<bool(const std::string&)> isTaken = {};
    /// The newest time of the platform or connection that leads; zero if it has none yet. Empty, or nothing:
    /// this one leads.
    std::function<std::optional<Instant>()> leadingTime = {};
    /// Makes another package of one that came, such as a foxglove.RawImage of a compressed one. Called in the
    /// link's thread. Empty: packages stay as they are.
    std::function<PackagePtr(const PackagePtr&)> convert = {};
    /// Streams, by their paths in the session, that are wanted beside those that the session needs.
    std::function<bool(const std::string& path)> alsoWanted = {};
    /// Called by tick() with each message that goes into the session.
    std::function<void(const StreamMessage&)> passed = {};
  };
  /// A stretch of the session's time in which the connection was lost.
  struct Gap {
    Instant from;
    /// Nothing while it lasts.
    std::optional<Instant> to = {};
    /// Why: a sentence.
    std::string reason = {};
    bool operator==(const Gap&) const = default;
  };
  /// A channel of the server.
  struct Stream {
    /// The path in the session.
    std::string path;
    std::string topic, type, encoding;
    bool isSubscribed = false;
    /// Messages of other encodings ("cdr", "ros1") are kept as bytes, and not shown.
    bool isDecoded = false;
    std::uint64_t messages = 0, bytes = 0;
    /// As the server counts, if it does: replaced by newer messages, and lost.
    std::optional<std::uint64_t> thinned = {}, dropped = {};
  };

  /// `session` must outlive this object.
  SessionClient(Session& session, Options options);
  ~SessionClient();
  SessionClient(const SessionClient&) = delete;
  SessionClient& operator=(const SessionClient&) = delete;

  /// Does what came since the last time. Call it before Session::tick().
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
  /// For the session's request sink: sends it, STOP before all others. The result comes by
  /// Session::pushResult(), at the latest when its time is over, and says so if the connection is lost.
  void request(const robotcontrol::Request& request);

  /// In order of time, the newest thousand.
  const std::vector<Gap>& gaps() const;
  std::vector<Stream> streams() const;
  /// The newest time of its messages in the session.
  std::optional<Instant> newest() const;

  enum class Images {
    kRaw,
    kJpeg  ///< where the server offers them; `convert` makes them raw again
  };
  /// How images are sent; at first raw.
  void setImages(Images images);
  /// Bytes a second that the server may send; 0 without limit.
  void setBudget(double bytesPerSecond);
  /// For what sessions know nothing of: client channels, parameters, playback.
  Client& client();

 private:
  struct Parts;
  const std::unique_ptr<Parts> parts_;
};

}  // namespace robotlink::websocket
