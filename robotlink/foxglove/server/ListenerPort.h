// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of a Listener; for its sources only, since it includes Asio.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <set>
#include <thread>

#include "robotlink/foxglove/server/ListenerOptions.h"
#include "robotlink/foxglove/server/Server.h"
#include "robotlink/foxglove/transport/TransportStream.h"

namespace robotlink::websocket {

using ListenerAcceptor = asio::basic_socket_acceptor<asio::ip::tcp, TransportExecutor>;

/// A connection as the port sees it. In the port's thread, except leave().
class Connection {
 public:
  Connection() = default;
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  virtual void start() = 0;
  /// Checks the time limits.
  virtual void tick(Instant now) = 0;
  /// Says goodbye without waiting for anything, when the port's thread has ended.
  virtual void leave() = 0;
  virtual bool isHandshake() const = 0;
  /// Ends it at once; may destroy it.
  virtual void end() = 0;
  /// The machine at the other end, without its port.
  virtual const std::string& machine() const = 0;
};

class ListenerPort;
using ConnectionPtr = std::shared_ptr<Connection>;

/// A connection, of which the handshake is still to come; without encryption if `tls` is null. If
/// `isRefused`, it only tells clients to use encryption.
ConnectionPtr makeConnection(ListenerPort& port, TransportSocket socket, asio::ssl::context* tls,
                             bool isRefused = false);
/// Waits for the first byte of a connection that should be one of TLS, and passes it on to one of these.
ConnectionPtr makeFirstByte(ListenerPort& port, TransportSocket socket);

/// The listening socket, its thread, and the connections. All but the constructor, open() and the destructor
/// runs in the thread.
class ListenerPort {
 public:
  ListenerPort(std::shared_ptr<Server> servedServer, ListenerOptions chosen)
      : server(std::move(servedServer)),
        options(withClock(std::move(chosen), server)),
        admission(options.admission) {}
  ~ListenerPort() {
    context.stop();
    if (thread_.joinable()) thread_.join();
    for (const auto& connection : std::exchange(connections_, {})) connection->leave();
  }
  ListenerPort(const ListenerPort&) = delete;
  ListenerPort& operator=(const ListenerPort&) = delete;

  Result<void> open();
  ListenAddress address() const {
    error_code ignored;
    return {options.address.address, acceptor_.local_endpoint(ignored).port()};
  }
  Instant now() const { return options.clock->now(); }
  /// Tells the robot's log. A page or program that tries repeatedly must not fill that: at most
  /// kMaxReports of kReportTime are reported, the others are counted.
  void report(const std::string& sentence);
  void add(const ConnectionPtr& connection);
  void remove(const ConnectionPtr& connection) { connections_.erase(connection); }

  const std::shared_ptr<Server> server;
  const ListenerOptions options;
  Admission admission;
  /// Null: connections are not encrypted.
  std::shared_ptr<asio::ssl::context> tls;
  asio::io_context context{1};

 private:
  static ListenerOptions withClock(ListenerOptions options, const std::shared_ptr<Server>& server) {
    if (!options.clock) options.clock = {server, &server->clock()};
    return options;
  }
  void run();
  void tryReport(const std::string& sentence);
  void accept();
  void welcome(TransportSocket socket);
  bool makeRoomFor(const std::string& machine);
  void tickLater();

  static constexpr std::size_t kMaxReports = 50;
  static constexpr Duration kReportTime = std::chrono::seconds(10);

  ListenerAcceptor acceptor_{context};
  asio::steady_timer timer_{context};
  bool isTicking_ = false, isAccepting_ = false;
  /// The number of reports since `reportsSince_`.
  std::size_t reports_ = 0;
  Instant reportsSince_;
  std::set<ConnectionPtr> connections_;
  /// No PacedThread: Asio's context waits for sockets and timers, and is what stops the thread.
  std::thread thread_;
};

/// "127.0.0.1:1234"; empty if the connection is gone.
std::string farEnd(const TransportSocket& socket);
/// Only its address.
std::string farMachine(const TransportSocket& socket);

}  // namespace robotlink::websocket
