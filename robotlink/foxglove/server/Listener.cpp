// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/Listener.h"

#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <exception>
#include <map>

#include "robotlink/foxglove/security/Tls.h"
#include "robotlink/foxglove/server/ListenerPort.h"

namespace robotlink::websocket {
namespace {

using asio::ip::tcp;

/// How often times and budgets are looked at while there are connections.
constexpr std::chrono::milliseconds kTick{20};

tl::unexpected<Error> cannotListen(const ListenAddress& address, const error_code& error) {
  const std::string where = toString(address);
  std::string advice = error.message() + "; choose another address or port";
  if (error == asio::error::address_in_use)
    advice = "another program is listening there: end it, or choose another port (0: any free one)";
  if (error == boost::system::errc::address_not_available)
    advice =
        "this machine does not have that address: 127.0.0.1 is for programs on this machine, 0.0.0.0 for all "
        "networks";
  if (error == asio::error::access_denied)
    advice = "ports below 1024 require root privileges: choose a higher one";
  return failure("foxglove.listen", "clients cannot connect at " + where + ": " + advice, {}, {where});
}

}  // namespace

std::string farEnd(const TransportSocket& socket) {
  error_code error;
  const tcp::endpoint from = socket.remote_endpoint(error);
  return error ? std::string() : toString(ListenAddress{from.address().to_string(), from.port()});
}

std::string farMachine(const TransportSocket& socket) {
  error_code error;
  const tcp::endpoint from = socket.remote_endpoint(error);
  return error ? std::string() : from.address().to_string();
}

Result<void> ListenerPort::open() {
  if (options.certificate) {
    auto context = makeServerTls(*options.certificate);
    if (!context) return tl::unexpected(context.error());
    tls = *std::move(context);
  }
  error_code error;
  const auto address = asio::ip::make_address(options.address.address, error);
  if (error)
    return failure(
        "foxglove.listen",
        "'" + options.address.address + "' is not an IP address: use one of this machine, such as 127.0.0.1",
        {}, {options.address.address});
  const tcp::endpoint endpoint(address, options.address.port);
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) return cannotListen(options.address, error);
  accept();
  thread_ = std::thread([this] { run(); });
  return {};
}

void ListenerPort::run() {
  while (!context.stopped()) {
    try {
      context.run();
    } catch (const std::exception& problem) {
      // Memory may have run out, for example. Other clients continue.
      tryReport(std::string("A message of a client could not be handled: ") + problem.what());
      tickLater();
    }
  }
}

/// Reports a sentence without throwing; an exception would end the thread and the process.
void ListenerPort::tryReport(const std::string& sentence) {
  try {
    report(sentence);
  } catch (const std::exception&) {
    // There is no one left to report this to.
  }
}

void ListenerPort::report(const std::string& sentence) {
  if (now() - reportsSince_ >= kReportTime) {
    if (reports_ > kMaxReports)
      server->report(std::to_string(reports_ - kMaxReports) + " more messages about clients were left out");
    reportsSince_ = now();
    reports_ = 0;
  }
  if (++reports_ <= kMaxReports) server->report(sentence);
}

void ListenerPort::accept() {
  isAccepting_ = true;
  acceptor_.async_accept([this](error_code error, TransportSocket socket) {
    isAccepting_ = false;
    if (!error) {
      accept();  // first: others come in, whatever throws
      welcome(std::move(socket));
    }
    tickLater();  // the tick tries again: the program may have too many files open
  });
}

void ListenerPort::welcome(TransportSocket socket) {
  const std::string machine = farMachine(socket);
  if (machine.empty() || !makeRoomFor(machine)) return;
  error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &options.unsentBytes,
               sizeof options.unsentBytes);
  add(tls ? makeFirstByte(*this, std::move(socket)) : makeConnection(*this, std::move(socket), nullptr));
}

/// Makes room by ending a handshake of the machine that has most, so that no machine keeps others out.
/// Returns false if `machine` has as many as any other.
bool ListenerPort::makeRoomFor(const std::string& machine) {
  std::map<std::string, std::vector<ConnectionPtr>> byMachine;
  std::size_t count = 0;
  for (const ConnectionPtr& connection : connections_) {
    if (!connection->isHandshake()) continue;
    byMachine[connection->machine()].push_back(connection);
    ++count;
  }
  if (count < options.handshakes) return true;
  const auto most = std::ranges::max_element(byMachine, {}, [](const auto& m) { return m.second.size(); });
  if (most == byMachine.end() || byMachine[machine].size() + 1 >= most->second.size()) return false;
  most->second.front()->end();
  return true;
}

void ListenerPort::add(const ConnectionPtr& connection) {
  connections_.insert(connection);
  connection->start();
}

void ListenerPort::tickLater() {
  if (isTicking_ || (connections_.empty() && isAccepting_)) return;
  isTicking_ = true;
  timer_.expires_after(kTick);
  timer_.async_wait([this](error_code) {
    isTicking_ = false;
    if (!isAccepting_) accept();
    tickLater();  // before the connections, so that it continues even if one of them throws
    const auto connections = connections_;  // some end meanwhile
    for (const auto& connection : connections) connection->tick(now());
  });
}

Listener::Listener(std::unique_ptr<ListenerPort> port) : port_(std::move(port)), address_(port_->address()) {}

Listener::~Listener() = default;

Result<std::unique_ptr<Listener>> Listener::open(std::shared_ptr<Server> server, Options options) {
  auto port = std::make_unique<ListenerPort>(std::move(server), std::move(options));
  if (auto opened = port->open(); !opened) return tl::unexpected(opened.error());
  return std::unique_ptr<Listener>(new Listener(std::move(port)));
}

}  // namespace robotlink::websocket
