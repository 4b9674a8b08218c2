// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/RobotPorts.h"

#include <poll.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>

#include "robotlink/arcos/server/SendQueue.h"

namespace robotlink::arcos {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

/// An incomplete packet is given up after this much silence.
constexpr std::chrono::milliseconds kPartialFor{100};
/// Limit of accepted connections per port and call of serve(), so that reconnecting in a loop costs no more
/// than sending.
constexpr int kMaxAccepts = 4;
/// The system's buffer of sent and unread data: small, so that most waiting data can still be dropped.
constexpr int kSystemBuffer = 16 << 10;

std::string describe(const tcp::endpoint& endpoint) {
  const std::string address = endpoint.address().to_string();
  return (endpoint.address().is_v6() ? "[" + address + "]" : address) + ":" + std::to_string(endpoint.port());
}

tl::unexpected<Error> cannotListen(const tcp::endpoint& endpoint, const boost::system::error_code& error) {
  const bool inUse = error == asio::error::address_in_use;
  return failure(
      "arcos.listen",
      "no robot can listen at " + describe(endpoint) + ": " + error.message() +
          (inUse ? "; end the other program or choose another port" : "; choose another address or port"),
      {}, {describe(endpoint)});
}

/// The port of a robot with its client, if there is one.
class Port {
 public:
  Port(asio::io_context& context, const RobotPorts::Options& options)
      : acceptor_(context), client_(context), silence_(options.silence), clock_(options.clock) {}

  Result<void> listen(const tcp::endpoint& endpoint) {
    boost::system::error_code error;
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (!error) acceptor_.non_blocking(true, error);
    if (error) return cannotListen(endpoint, error);
    awaitClients();
    return {};
  }

  std::uint16_t port() const {
    boost::system::error_code ignored;
    return acceptor_.local_endpoint(ignored).port();
  }

  RobotPorts::Statistics statistics() const {
    RobotPorts::Statistics statistics = statistics_;
    statistics.received = parser_.counters();
    statistics.sentPackets = sending_.sentPackets();
    statistics.droppedPackets = sending_.droppedPackets();
    return statistics;
  }

  void setListener(RobotPorts::Listener* listener, std::size_t robot) {
    listener_ = listener;
    robot_ = robot;
  }

  /// Prepares for a call of serve(): processes what was left over from the last one, and listens again.
  void beginStep() {
    bytesLeft_ = RobotPorts::kMaxBytes;
    packetsLeft_ = RobotPorts::kMaxPackets;
    acceptsLeft_ = kMaxAccepts;
    if (!awaitingClients_) awaitClients();
    if (!client_.is_open()) return;
    handOut();
    if (ended_ && drained_) return drop();
    if (!awaitingBytes_) awaitBytes();
    if (!writing_) write();
  }

  void giveUpPartialPacket() {
    if (!drained_ || !parser_.isPartial() || clock_() - heardAt_ <= kPartialFor) return;
    parser_.dropPartial();
    handOut();
  }

  void send(std::span<const Packet> packets) {
    if (!client_.is_open()) return;
    const auto now = clock_();
    for (const Packet& packet : packets) sending_.push(packet, now);
    sending_.dropOld(now);
    if (!writing_) write();
  }

 private:
  void awaitClients() {
    awaitingClients_ = acceptsLeft_ > 0;
    if (!awaitingClients_) return;
    acceptor_.async_wait(tcp::acceptor::wait_read, [this](const boost::system::error_code& error) {
      awaitingClients_ = false;
      if (error) return;
      --acceptsLeft_;
      accept();
      awaitClients();
    });
  }

  void accept() {
    boost::system::error_code error;
    tcp::endpoint from;
    tcp::socket socket(acceptor_.get_executor());
    acceptor_.accept(socket, from, error);
    if (error) return;
    if (client_.is_open()) read();
    if (client_.is_open() && !hungUp() && clock_() - heardAt_ < silence_) {
      ++statistics_.refused;
      socket.close(error);
      return;
    }
    drop();
    socket.set_option(tcp::no_delay(true), error);
    socket.set_option(asio::socket_base::keep_alive(true), error);
    socket.set_option(asio::socket_base::send_buffer_size(kSystemBuffer), error);
    socket.non_blocking(true, error);
    client_ = std::move(socket);
    heardAt_ = clock_();
    statistics_.receivedBytes = 0;
    ++statistics_.clients;
    statistics_.client = describe(from);
    listener_->clientCame(robot_, statistics_.client);
    awaitBytes();
  }

  /// Whether the client has disconnected, even if not all of its data were read.
  bool hungUp() {
    pollfd state{client_.native_handle(), POLLRDHUP, 0};
    return ended_ || (::poll(&state, 1, 0) > 0 && (state.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0);
  }

  /// Whether this call of serve() may read more from the client.
  bool mayRead() const { return client_.is_open() && !ended_ && drained_ && bytesLeft_ > 0; }

  void awaitBytes() {
    awaitingBytes_ = mayRead();
    if (!awaitingBytes_) return;
    client_.async_wait(tcp::socket::wait_read,
                       [this, connection = connection_](const boost::system::error_code& error) {
                         if (connection != connection_) return;
                         awaitingBytes_ = false;
                         if (error) return;
                         read();
                         if (connection == connection_) awaitBytes();
                       });
  }

  void read() {
    if (!mayRead()) return;
    std::array<std::uint8_t, RobotPorts::kMaxBytes> bytes;
    boost::system::error_code error;
    const std::size_t count = client_.read_some(asio::buffer(bytes.data(), bytesLeft_), error);
    if (error == asio::error::would_block || error == asio::error::interrupted) return;
    ended_ = error.failed();
    if (!ended_) {
      heardAt_ = clock_();
      statistics_.receivedBytes += count;
      bytesLeft_ -= count;
      parser_.push({bytes.data(), count});
    }
    handOut();
    if (ended_ && drained_) drop();
  }

  void handOut() {
    drained_ = false;
    while (packetsLeft_ > 0) {
      const auto found = parser_.next();
      if (!found) {
        drained_ = true;
        return;
      }
      if (const auto* packet = std::get_if<Packet>(&*found)) {
        --packetsLeft_;
        listener_->packetCame(robot_, *packet);
      }
    }
  }

  void write() {
    sending_.dropOld(clock_());
    boost::system::error_code error;
    while (!sending_.bytes().empty() && !error) {
      sending_.written(
          client_.write_some(asio::buffer(sending_.bytes().data(), sending_.bytes().size()), error));
    }
    // Reading reports a broken connection.
    if (error != asio::error::would_block) return sending_.clear();
    writing_ = true;
    client_.async_wait(tcp::socket::wait_write,
                       [this, connection = connection_](const boost::system::error_code& failed) {
                         if (connection != connection_) return;
                         writing_ = false;
                         if (!failed) write();
                       });
  }

  void drop() {
    if (!client_.is_open()) return;
    boost::system::error_code ignored;
    client_.close(ignored);
    ++connection_;
    writing_ = awaitingBytes_ = ended_ = false;
    drained_ = true;
    sending_.clear();
    parser_.clear();
    statistics_.client.clear();
    listener_->clientGone(robot_);
  }

  tcp::acceptor acceptor_;
  tcp::socket client_;
  const std::chrono::milliseconds silence_;
  const std::function<Clock::time_point()> clock_;
  // Incremented with each client, so that pending operations of one do not affect the next.
  std::uint64_t connection_ = 0;
  RobotPorts::Listener* listener_ = nullptr;
  std::size_t robot_ = 0;
  PacketParser parser_;
  Clock::time_point heardAt_;
  SendQueue sending_;
  bool writing_ = false, awaitingBytes_ = false, awaitingClients_ = false;
  // Whether the parser has no further packets.
  bool drained_ = true;
  // Whether the client sends nothing any longer; its remaining packets are still executed.
  bool ended_ = false;
  std::size_t bytesLeft_ = RobotPorts::kMaxBytes, packetsLeft_ = RobotPorts::kMaxPackets;
  int acceptsLeft_ = kMaxAccepts;
  RobotPorts::Statistics statistics_;
};

}  // namespace

struct RobotPorts::Implementation {
  asio::io_context context{1};
  std::vector<std::unique_ptr<Port>> ports;
  bool loopbackOnly = true;
};

RobotPorts::RobotPorts() : implementation_(std::make_unique<Implementation>()) {}
RobotPorts::~RobotPorts() = default;

Result<std::unique_ptr<RobotPorts>> RobotPorts::open(const Options& options) {
  boost::system::error_code error;
  const auto address =
      asio::ip::make_address(options.address == "localhost" ? "127.0.0.1" : options.address, error);
  if (error) {
    return failure("arcos.address",
                   "'" + options.address +
                       "' is not an address of this machine; write one like 127.0.0.1, or 0.0.0.0 for all",
                   {}, {options.address});
  }
  if (options.firstPort != 0 && options.firstPort + options.robots > 65536) {
    return failure("arcos.ports", "there are not enough ports from " + std::to_string(options.firstPort) +
                                      " on; start with a lower one");
  }
  std::unique_ptr<RobotPorts> ports(new RobotPorts);
  Implementation& made = *ports->implementation_;
  made.loopbackOnly = address.is_loopback();
  for (std::size_t robot = 0; robot < options.robots; ++robot) {
    const auto number = static_cast<std::uint16_t>(options.firstPort == 0 ? 0 : options.firstPort + robot);
    made.ports.push_back(std::make_unique<Port>(made.context, options));
    if (auto listening = made.ports.back()->listen({address, number}); !listening) {
      return tl::unexpected(listening.error());
    }
  }
  return ports;
}

std::size_t RobotPorts::robots() const {
  return implementation_->ports.size();
}
std::uint16_t RobotPorts::port(std::size_t robot) const {
  return implementation_->ports.at(robot)->port();
}
bool RobotPorts::loopbackOnly() const {
  return implementation_->loopbackOnly;
}
RobotPorts::Statistics RobotPorts::statistics(std::size_t robot) const {
  return implementation_->ports.at(robot)->statistics();
}

void RobotPorts::serve(Listener& listener, Clock::time_point until) {
  auto& ports = implementation_->ports;
  for (std::size_t robot = 0; robot < ports.size(); ++robot) ports[robot]->setListener(&listener, robot);
  for (const auto& port : ports) port->beginStep();
  asio::io_context& context = implementation_->context;
  context.restart();
  context.poll();
  for (const auto& port : ports) port->giveUpPartialPacket();
  if (until > Clock::now()) context.run_until(until);
}

void RobotPorts::send(std::size_t robot, std::span<const Packet> packets) {
  implementation_->ports.at(robot)->send(packets);
}

}  // namespace robotlink::arcos
