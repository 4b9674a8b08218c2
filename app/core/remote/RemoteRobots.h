// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/core/remote/LinkLimits.h"
#include "app/core/remote/ProgramNotes.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/base/Error.h"
#include "robotlink/foxglove/client/ConnectionState.h"
#include "robotlink/foxglove/session/remote/SessionClientOptions.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {
class Recorder;
}
namespace robotcontrol {
class Request;
}
namespace robotlink {
class Session;
}
namespace robotlink::websocket {
class SessionClient;
}

namespace app {

class DeployJobs;
class RecordingJobs;

/// The remote robots of a session, in addition to those of the platform that is open: one
/// connection for each server (robotlink/foxglove/FOXGLOVE.md). Connections are lost and found again by
/// themselves. Requests to these robots go to them; requests to no robot go to the connection that
/// leads, unless a platform is open: the first one to a session of this program, or else the first one. What
/// is received is recorded as that of other robots.
///
/// One thread, that of Session::tick(). Session, recorder and limits must outlive it.
class RemoteRobots {
 public:
  /// A connection, as users see it.
  struct Connection {
    /// The URL without a token.
    std::string url;
    robotlink::websocket::ConnectionState state;
    /// "connected, 12 ms, 1.3 MB/s, at most 2.0 MB/s".
    std::string text;
    LinkLimits limits;
    /// The names of its robots in the session.
    std::vector<std::string> robots;
    /// Whether it records into its own storage, as recordings() shows.
    bool hasRecordings = false;
    /// Whether files can be deployed to it.
    bool hasResources = false;
  };

  RemoteRobots(robotlink::Session& session, logplayer::Recorder& recorder, const LinkLimitsMemory& limits);
  ~RemoteRobots();
  RemoteRobots(const RemoteRobots&) = delete;
  RemoteRobots& operator=(const RemoteRobots&) = delete;

  /// Begins to connect; returns the URL as connections() has it. Without a token the one that is remembered
  /// for this URL is shown. A server that is connected already is reconnected. Fails if the URL makes no
  /// sense; everything else is reported by connections(), such as a certificate that nobody has trusted yet.
  robotlink::Result<std::string> connect(const std::string& url, const std::string& token = {});
  /// Ends a connection; its robots leave the session. Fails if there is none.
  robotlink::Result<void> disconnect(const std::string& url);
  /// Returns the user's limits for connections to a URL.
  LinkLimits limits(const std::string& url) const { return limits_.limits(url); }
  /// The streams of a connection, with what was left out of each; empty if there is no such connection.
  std::vector<robotlink::websocket::RemoteStream> streams(const std::string& url) const;
  std::vector<Connection> connections() const;
  /// Remembers the token of a connection as soon as the robot has accepted it.
  robotlink::Result<void> rememberToken(const std::string& url);
  /// Whether a token is remembered for a URL.
  static bool hasToken(const std::string& url);
  static robotlink::Result<void> forgetToken(const std::string& url);
  /// A person has compared the fingerprint of the certificate that the robot at a URL shows: it is
  /// remembered, in the place of one that was known, and the robot is reconnected. Fails if it is not what
  /// the robot showed last.
  robotlink::Result<void> trust(const std::string& url, const std::string& fingerprint);
  bool empty() const { return lines_.empty(); }

  /// The robots of the platform that is open; nothing if none is open, so that a connection leads.
  void setPlatform(std::optional<std::set<std::string>> robots);
  /// The names of all remote robots, in the order of the connections.
  std::vector<std::string> robots() const;
  /// Returns what is known of a robot; empty if it has said nothing about itself.
  KnownRobot known(const std::string& robot) const;
  /// Increases with each change of robots() or of what is known of them.
  std::uint64_t version() const { return version_; }

  /// Returns the jobs for the recordings at the robots of a connection; null if there is no such connection.
  /// Valid until that ends or is connected again.
  RecordingJobs* recordings(const std::string& url);
  /// Returns the jobs that deploy to the robots of a connection; null if there is none. Valid as long.
  DeployJobs* deployment(const std::string& url);
  /// Takes control of a robot, even if another client has it, or gives control up. Fails if it is not one of
  /// these; what the robot objects to is among the notes.
  robotlink::Result<void> steer(const std::string& robot, bool giveUp);

  /// Removes and returns what users have to know: what robots object to, and what could not be saved.
  robotlink::Errors takeNotes() { return notes_->drain(); }
  /// Processes what was received since the last call; call this before Session::tick().
  void tick();
  /// Sends a request to the connection to which it belongs; returns false if it belongs to none.
  bool take(const robotcontrol::Request& request);

 private:
  using SessionClient = robotlink::websocket::SessionClient;
  struct Line;
  struct Described {
    robotlink::PackagePtr setup;
    KnownRobot known;
  };

  Line* find(const std::string& url);
  bool isTaken(const std::string& robot, const Line* by) const;
  std::optional<robotlink::Instant> leadingTime(const Line& of) const;
  void findLeader();
  void noteGaps(Line& line);
  void keepTokens();
  void applyLimits();
  void describeRobots();
  void showRobots();
  void record(const robotlink::StreamMessage& message);
  /// While a recording runs, subscribes to the packages that it wants of these robots. Whichever debug keys
  /// the user has switched on meanwhile stay.
  void subscribeRecorded();

  robotlink::Session& session_;
  logplayer::Recorder& recorder_;
  const LinkLimitsMemory& limits_;
  std::uint64_t listener_;
  /// From the threads of the links; shared with them.
  std::shared_ptr<robotlink::BoundedQueue<robotlink::Error>> notes_;
  std::optional<std::set<std::string>> platform_;
  /// In the order in which they were begun.
  std::vector<std::unique_ptr<Line>> lines_;
  /// The one whose times and world the session has, if no platform is open; null: none yet.
  const Line* leader_ = nullptr;
  std::map<std::string, Described> described_;
  /// The streams that are subscribed to for a recording.
  std::set<std::string> recorded_;
  std::uint64_t version_ = 0;
  /// The number of times that the connections were shown.
  unsigned ticks_ = 0;
};

}  // namespace app
