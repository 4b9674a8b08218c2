// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/remote/RobotAnnouncer.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/base/Clock.h"
#include "robotlink/foxglove/server/Admission.h"
#include "robotlink/foxglove/server/ListenAddress.h"
#include "robotlink/session/Session.h"

namespace robotlink::websocket {
class Listener;
class SessionServer;
}  // namespace robotlink::websocket

namespace app {

/// A session that others may watch and steer with clients of the Foxglove WebSocket protocol, as long as the
/// user wants that. One thread, that of Session::tick(); the session must outlive it.
class SessionOffer {
 public:
  /// A connected client.
  struct Client {
    /// "192.168.1.7:51324", and what it calls itself; the latter may be empty.
    std::string address, name;
    /// The rate at which data was sent to it, over the last second.
    double bytesPerSecond = 0;
    /// The amount of data that waits to be sent to it.
    std::size_t waitingBytes = 0;
    /// Whether it may only watch.
    bool isReadOnly = false;
    bool operator==(const Client&) const = default;
  };

  explicit SessionOffer(robotlink::Session& session);
  ~SessionOffer();
  SessionOffer(const SessionOffer&) = delete;
  SessionOffer& operator=(const SessionOffer&) = delete;

  /// Offers the session at "[ADDRESS:]PORT" instead of where it was offered before; empty: the default
  /// address. At an address that other machines reach, its robots are announced on these networks, as long as
  /// it is offered. If that fails, the error says what to do, and nothing changes.
  robotlink::Result<void> begin(const std::string& address);
  /// Ends all connections.
  void end();
  /// The local user takes control of a robot, even if a client has it, or gives control up. Fails if nothing
  /// is offered.
  robotlink::Result<void> steer(const std::string& robot, bool giveUp);
  bool isOffered() const { return listener_ != nullptr; }
  /// The URLs for clients, "ws://127.0.0.1:8765": one for each network of this machine; none if nothing is
  /// offered.
  const std::vector<std::string>& urls() const { return urls_; }
  /// The first of them; empty if nothing is offered.
  std::string url() const { return urls_.empty() ? std::string() : urls_.front(); }
  /// The tokens that others have to show, to do everything or to watch; empty if they need none.
  const std::string& controlToken() const { return admission_.token; }
  const std::string& watchToken() const { return admission_.watchToken; }
  /// Notes on the offer for the local user, as sentences: how it is protected, the fingerprint.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Whether this is where the session is offered, by an address of this machine.
  bool isOfferedAt(const std::string& address, std::uint16_t port) const;
  /// See SessionServer::onSteerElsewhere(); from the next begin() on.
  void onSteerElsewhere(std::function<void(const std::string& robot, bool giveUp)> handler) {
    steerElsewhere_ = std::move(handler);
  }
  /// Announces on other nodes from the next begin() on.
  void announceOn(RobotAnnouncer::Nodes nodes) { nodes_ = std::move(nodes); }

  /// Serves clients; call this after Session::tick().
  void tick();
  /// The rates of the last second.
  const std::vector<Client>& clients() const { return clients_; }
  /// Sentences about who was refused, newest last.
  const std::deque<std::string>& reports() const { return reports_; }

 private:
  void measure(robotlink::Duration passed);
  /// Announces the robots that the session has now.
  void announce();

  robotlink::Session& session_;
  robotlink::SteadyClock clock_;
  /// From the link's thread; shared with it.
  std::shared_ptr<robotlink::BoundedQueue<std::string>> reported_;
  std::unique_ptr<robotlink::websocket::SessionServer> server_;
  std::unique_ptr<robotlink::websocket::Listener> listener_;
  robotlink::websocket::Admission::Options admission_;
  std::vector<std::string> urls_, notes_;
  std::vector<Client> clients_;
  std::deque<std::string> reports_;
  /// The bytes sent to each client until clients_ was measured, by its id.
  std::map<std::uint64_t, std::uint64_t> sent_;
  robotlink::Instant measured_;
  std::function<void(const std::string& robot, bool giveUp)> steerElsewhere_;
  RobotAnnouncer::Nodes nodes_ = robotlink::dds::announcementNodes;
  /// Null if nothing is offered.
  std::unique_ptr<RobotAnnouncer> announcer_;
  robotlink::Instant announced_;
  /// The addresses of this machine when the offer began.
  std::vector<std::string> localAddresses_;
};

}  // namespace app
