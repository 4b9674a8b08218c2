// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/core/remote/LinkLimits.h"
#include "app/core/remote/ProgramNotes.h"
#include "app/platforms/body/LineBudget.h"
#include "robotcontrol/Body.pb.h"
#include "robotlink/foxglove/session/remote/SessionClient.h"
#include "robotlink/session/Session.h"

namespace robotcontrol {
class ControlDrive;
class SetCamera;
}  // namespace robotcontrol

namespace app {

/// The connection from a robot's program to its remote body (REMOTE_BODY.md): it is made repeatedly
/// by itself. Of each sensor package the newest is kept until it is taken.
///
/// One thread, but for engageStop(), which any thread may call.
class BodyLink {
 public:
  struct Options {
    robotlink::websocket::Connector::Options connection;
    /// The robot whose body it is; empty: the first that is offered.
    std::string robot = {};
    LinkLimits limits = {};
  };
  /// The properties of the body, once they are known.
  struct Body {
    robotcontrol::BodyOffer offer;
    KnownRobot known;
    /// The setup from which it was read; not null.
    std::shared_ptr<const robotcontrol::ProgramSetup> setup;
  };
  /// The messages that arrived since the last call of take().
  struct Arrived {
    /// The newest of each package, by its name.
    std::map<std::string, robotlink::PackagePtr> sensors;
    /// Null: no frame has ended since.
    std::shared_ptr<const robotcontrol::BodyState> state;
    /// The body's texts.
    std::vector<std::string> texts;
  };

  explicit BodyLink(Options options);
  ~BodyLink();
  BodyLink(const BodyLink&) = delete;
  BodyLink& operator=(const BodyLink&) = delete;

  /// Processes what was received.
  void tick();
  const std::optional<Body>& body() const { return body_; }
  /// Whether another body than this one is offered under its name now.
  bool isOther() const { return isOther_; }
  /// The robots at the server. They are all known as soon as one of them has said what it is.
  const std::vector<std::string>& robots() const { return client_->robots(); }
  /// Whether a robot there has said what it is: a body, or one whose program runs there.
  enum class Kind { kUnknown, kBody, kWithProgram };
  Kind kindOf(const std::string& robot) const;
  /// Changes with all that comes on the way to body().
  std::uint64_t progress() const;
  /// Limits what the connection carries.
  void limit(const LinkLimits& limits);
  /// From now on only these of the body's packages are sent.
  void want(const std::set<std::string>& packages);
  Arrived take() { return std::exchange(arrived_, {}); }

  /// Sends commands if there is a connection; they replace those that wait.
  void send(const robotcontrol::BodyCommands& commands);
  /// Engages or releases STOP at the body, ahead of all that waits. The handler is called in any thread, with
  /// the reason why it was not done; empty if it was.
  void engageStop(bool engaged, std::function<void(const std::string& why)> done);
  /// Sends a request to the base or the camera of the body; the handler is called as that of engageStop().
  void control(const robotcontrol::ControlDrive& details, std::function<void(const std::string& why)> done);
  void setCamera(const robotcontrol::SetCamera& details, std::function<void(const std::string& why)> done);

  robotlink::websocket::ConnectionState state() const { return client_->state(); }
  /// "connected, 12 ms, 1.3 MB/s, at most 2.0 MB/s"
  std::string stateText() const { return client_->stateText() + inWords(limits_); }
  std::string url() const { return toString(client_->url()); }

 private:
  /// Limits the connection to what it carries without a queue, and to what was chosen.
  void followLine();
  void applyLimits();
  /// Looks at a message of the server.
  void look(const robotlink::StreamMessage& message);
  bool wants(const std::string& path) const;
  void lookForBody();
  void call(const std::string& service, const std::string& argument, bool isUrgent,
            std::function<void(const std::string& why)> done);

  const std::string wantedRobot_;
  /// The limits that the user has chosen for this connection.
  LinkLimits limits_;
  LineBudget line_;
  /// The measurement that line_ has.
  std::optional<robotlink::Duration> roundTrip_;
  std::map<std::string, robotcontrol::BodyOffer> offers_;
  std::map<std::string, robotlink::PackagePtr> setups_;
  /// The body; does not change once it is set.
  std::optional<Body> body_;
  bool isOther_ = false;
  std::set<std::string> packages_;
  Arrived arrived_;
  /// Receives the body's streams; no view reads it.
  robotlink::Session session_;
  /// The last member, since it uses the others.
  std::unique_ptr<robotlink::websocket::SessionClient> client_;
};

}  // namespace app
