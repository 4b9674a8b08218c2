// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/RobotPorts.h"

#include <array>
#include <boost/asio/ip/tcp.hpp>

namespace robotlink::arcos {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

/// So long a line is silent within a packet until the packet is given up.
constexpr std::chrono::milliseconds kPartialFor{100};
/// Read at once of one client, so that one that floods does not keep the others waiting.
constexpr std::size_t kReadAtOnce = 16U << 10U;
constexpr int kReadsBeforeAccept = 16;

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

/// One robot's port with its client, if there is one.
class Port {
 public:
  Port(asio::io_context& context, std::chrono::milliseconds silence)
      : acceptor_(context), client_(context), silence_(silence) {}

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
    return statistics;
  }

  void setListener(RobotPorts::Listener* listener, std::size_t robot) {
    listener_ = listener;
    robot_ = robot;
  }

  void send(std::span<const Packet> packets) {
    if (!client_.is_open()) return;
    for (const Packet& packet : packets) {
      if (pending_.size() >= RobotPorts::kMaximumPending) {
        ++statistics_.droppedPackets;
      } else {
        append(packet, pending_);
        ++statistics_.sentPackets;
      }
    }
    if (!writing_) write();
  }

  void giveUpPartialPacket(Clock::time_point now) {
    if (parser_.isPartial() && now - heardAt_ > kPartialFor) {
      parser_.dropPartial();
      handOut();
    }
  }

 private:
  void awaitClients() {
    acceptor_.async_wait(tcp::acceptor::wait_read, [this](const boost::system::error_code& error) {
      if (error) return;
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
    // The client before may be gone already, without that its end was read yet.
    for (int i = 0; i < kReadsBeforeAccept && client_.is_open() && read(); ++i) {
    }
    if (client_.is_open() && Clock::now() - heardAt_ < silence_) {
      ++statistics_.refused;
      socket.close(error);
      return;
    }
    drop();
    socket.set_option(tcp::no_delay(true), error);
    socket.set_option(asio::socket_base::keep_alive(true), error);
    socket.non_blocking(true, error);
    client_ = std::move(socket);
    heardAt_ = Clock::now();
    statistics_.receivedBytes = 0;
    ++statistics_.clients;
    statistics_.client = describe(from);
    listener_->clientCame(robot_, statistics_.client);
    awaitBytes();
  }

  void awaitBytes() {
    client_.async_wait(tcp::socket::wait_read,
                       [this, connection = connection_](const boost::system::error_code& error) {
                         if (error || connection != connection_) return;
                         read();
                         if (connection == connection_) awaitBytes();
                       });
  }

  /// Whether there may be more to read.
  bool read() {
    std::array<std::uint8_t, kReadAtOnce> bytes;
    boost::system::error_code error;
    const std::size_t count = client_.read_some(asio::buffer(bytes), error);
    if (error == asio::error::would_block || error == asio::error::interrupted) return false;
    if (error) {
      drop();
      return false;
    }
    heardAt_ = Clock::now();
    statistics_.receivedBytes += count;
    parser_.push({bytes.data(), count});
    handOut();
    return true;
  }

  void handOut() {
    while (const auto found = parser_.next()) {
      if (const auto* packet = std::get_if<Packet>(&*found)) listener_->packetCame(robot_, *packet);
    }
  }

  void write() {
    boost::system::error_code error;
    std::size_t written = 0;
    while (written < pending_.size() && !error) {
      written +=
          client_.write_some(asio::buffer(pending_.data() + written, pending_.size() - written), error);
    }
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(written));
    // Of a line that is broken reading tells.
    if (error != asio::error::would_block) return pending_.clear();
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
    writing_ = false;
    pending_.clear();
    parser_.clear();
    statistics_.client.clear();
    listener_->clientGone(robot_);
  }

  tcp::acceptor acceptor_;
  tcp::socket client_;
  const std::chrono::milliseconds silence_;
  std::uint64_t connection_ = 0;  ///< so that what was begun for one client does not touch the next
  RobotPorts::Listener* listener_ = nullptr;
  std::size_t robot_ = 0;
  PacketParser parser_;
  Clock::time_point heardAt_;
  Bytes pending_;
  bool writing_ = false;
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
                       "' is no address of this machine; write one like 127.0.0.1, or 0.0.0.0 for all",
                   {}, {options.address});
  }
  if (options.firstPort != 0 && options.firstPort + options.robots > 65536) {
    return failure("arcos.ports", "there are not so many ports from " + std::to_string(options.firstPort) +
                                      " on; begin with a lower one");
  }
  std::unique_ptr<RobotPorts> ports(new RobotPorts);
  Implementation& made = *ports->implementation_;
  made.loopbackOnly = address.is_loopback();
  for (std::size_t robot = 0; robot < options.robots; ++robot) {
    const auto number = static_cast<std::uint16_t>(options.firstPort == 0 ? 0 : options.firstPort + robot);
    made.ports.push_back(std::make_unique<Port>(made.context, options.silence));
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
  asio::io_context& context = implementation_->context;
  context.restart();
  context.poll();
  const auto now = Clock::now();
  for (const auto& port : ports) port->giveUpPartialPacket(now);
  if (until > now) context.run_until(until);
}

void RobotPorts::send(std::size_t robot, std::span<const Packet> packets) {
  implementation_->ports.at(robot)->send(packets);
}

}  // namespace robotlink::arcos
