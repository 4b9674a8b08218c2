// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/foxglove/Relay.h"

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <deque>
#include <set>
#include <string>
#include <thread>

namespace robotlink::websocket::test {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using Time = std::chrono::steady_clock::time_point;
using std::chrono::steady_clock;

constexpr std::size_t kPacket = 1400;
/// Small, so that little waits but in the queue.
constexpr int kSystemBuffer = 4 << 10;

tcp::endpoint loopback(std::uint16_t port) {
  return {asio::ip::address_v4::loopback(), port};
}

void shrink(tcp::socket& socket) {
  error_code ignored;
  socket.set_option(asio::socket_base::receive_buffer_size(kSystemBuffer), ignored);
  socket.set_option(asio::socket_base::send_buffer_size(kSystemBuffer), ignored);
  socket.set_option(tcp::no_delay(true), ignored);
}

}  // namespace

struct Relay::Implementation {
  struct Connection;
  /// One way of a connection: packets wait for the throttle, and then for their delay.
  struct Way {
    struct Packet {
      std::string bytes;
      Time sent, due;
    };
    tcp::socket* from = nullptr;
    tcp::socket* to = nullptr;
    std::deque<Packet> packets;
    std::string writing;
    Time free;
    std::array<char, kPacket> buffer{};
    bool isReading = false, hasEnded = false;
  };
  struct Connection : std::enable_shared_from_this<Connection> {
    Connection(asio::io_context& context, tcp::socket accepted)
        : client(std::move(accepted)), server(context), timer(context) {
      there.from = back.to = &client;
      there.to = back.from = &server;
    }
    tcp::socket client, server;
    asio::steady_timer timer;
    Way there, back;
    /// Bytes of it were lost.
    bool isDead = false;
  };
  using ConnectionPtr = std::shared_ptr<Connection>;

  Implementation(tcp::endpoint server, Line chosen) : target(std::move(server)), line(chosen) {
    acceptor.open(tcp::v4());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.set_option(asio::socket_base::receive_buffer_size(kSystemBuffer));
    acceptor.bind(loopback(0));
    acceptor.listen();
    accept();
    thread = std::thread([this] { context.run(); });
  }
  ~Implementation() {
    context.stop();
    thread.join();
  }

  void accept() {
    acceptor.async_accept([this](error_code error, tcp::socket socket) {
      if (error) return;
      if (state != State::kCut) start(std::make_shared<Connection>(context, std::move(socket)));
      accept();
    });
  }
  void start(const ConnectionPtr& connection) {
    connections.insert(connection);
    error_code error;
    connection->server.open(tcp::v4(), error);
    shrink(connection->client);
    shrink(connection->server);
    connection->isDead = state == State::kSilent;
    connection->server.connect(target, error);
    tick(connection);
  }
  void tick(const ConnectionPtr& connection) {
    if (!connections.contains(connection)) return;
    for (Way* way : {&connection->there, &connection->back}) {
      read(connection, *way);
      write(connection, *way);
    }
    if (connection->there.hasEnded && connection->back.hasEnded) return end(connection);
    connection->timer.expires_after(std::chrono::milliseconds(1));
    connection->timer.async_wait([this, connection](error_code) { tick(connection); });
  }
  std::size_t waiting(const Way& way) const {
    std::size_t bytes = 0;
    for (const auto& packet : way.packets)
      if (packet.sent > steady_clock::now()) bytes += packet.bytes.size();
    return bytes;
  }
  void read(const ConnectionPtr& connection, Way& way) {
    if (way.isReading || way.hasEnded || state == State::kStalled || waiting(way) >= line.queueBytes) return;
    way.isReading = true;
    way.from->async_read_some(asio::buffer(way.buffer), [this, connection, &way](error_code error,
                                                                                 std::size_t size) {
      way.isReading = false;
      if (error) {
        way.hasEnded = true;
        return;
      }
      if (state == State::kSilent) connection->isDead = true;
      if (connection->isDead) return;
      carried += size;
      const Duration time =
          line.bytesPerSecond > 0 ? fromSeconds(static_cast<double>(size) / line.bytesPerSecond) : Duration();
      way.free = std::max(way.free, steady_clock::now()) + time;
      way.packets.push_back({std::string(way.buffer.data(), size), way.free, way.free + line.delay});
      read(connection, way);
    });
  }
  void write(const ConnectionPtr& connection, Way& way) {
    if (!way.writing.empty() || way.packets.empty() || state == State::kStalled || connection->isDead) return;
    if (way.packets.front().due > steady_clock::now()) return;
    way.writing = std::move(way.packets.front().bytes);
    way.packets.pop_front();
    asio::async_write(*way.to, asio::buffer(way.writing),
                      [this, connection, &way](error_code error, std::size_t) {
                        way.writing.clear();
                        if (error)
                          end(connection);
                        else
                          write(connection, way);
                      });
  }
  void end(const ConnectionPtr& connection) {
    error_code ignored;
    connection->client.close(ignored);
    connection->server.close(ignored);
    connections.erase(connection);
  }

  const tcp::endpoint target;
  const Line line;
  State state = State::kOpen;
  asio::io_context context{1};
  tcp::acceptor acceptor{context};
  std::set<ConnectionPtr> connections;
  std::atomic<std::size_t> carried{0};
  std::thread thread;
};

Relay::Relay(std::uint16_t target, Line line, const std::string& address)
    : implementation_(std::make_unique<Implementation>(
          tcp::endpoint(asio::ip::make_address_v4(address), target), line)) {}

Relay::~Relay() = default;

std::uint16_t Relay::port() const {
  return implementation_->acceptor.local_endpoint().port();
}

std::size_t Relay::carriedBytes() const {
  return implementation_->carried;
}

void Relay::set(State state) {
  asio::post(implementation_->context, [self = implementation_.get(), state] {
    self->state = state;
    if (state != State::kCut) return;
    while (!self->connections.empty()) self->end(*self->connections.begin());
  });
}

}  // namespace robotlink::websocket::test
