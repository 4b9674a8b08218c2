// SPDX-License-Identifier: GPL-3.0-or-later
// Messages from a server to its clients on loopback, beside the same from Beast alone: a thread that writes
// the bytes to each socket, one after the other, without a server. Both are measured in turn, in one run, so
// that what else the machine does hits both alike; "ratio" is the median of their quotients, 1 if the server
// costs nothing.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>
#include <thread>

#include "robotlink/foxglove/server/Listener.h"

namespace robotlink::websocket::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using SteadyTime = std::chrono::steady_clock;
using WebSocket = websocket::stream<tcp::socket>;

struct Load {
  std::size_t bytes = 0, messages = 0, clients = 0;
};

/// Sockets of the clients' side, read one after the other.
class Readers {
 public:
  Readers(std::uint16_t port, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      WebSocket& socket = sockets_.emplace_back(context_);
      socket.next_layer().connect({asio::ip::address_v4::loopback(), port});
      socket.next_layer().set_option(tcp::no_delay(true));
      socket.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
        request.set(beast::http::field::sec_websocket_protocol, kSdkProtocol);
      }));
      socket.read_message_max(64U << 20U);
      socket.handshake("localhost", "/");
    }
  }
  /// Reads binary messages, so many of each.
  void read(std::size_t messages) {
    for (std::size_t i = 0; i < messages; ++i) {
      for (WebSocket& socket : sockets_) {
        do {
          buffer_.clear();
          socket.read(buffer_);
        } while (socket.got_text());
      }
    }
  }
  void subscribe(std::uint64_t channel) {
    const std::string text = encode(ClientMessage(Subscribe{{{1, channel}}})).bytes;
    for (WebSocket& socket : sockets_) socket.write(asio::buffer(text));
  }

 private:
  asio::io_context context_;
  std::deque<WebSocket> sockets_;
  beast::flat_buffer buffer_;
};

double secondsSince(SteadyTime::time_point start) {
  return std::chrono::duration<double>(SteadyTime::now() - start).count();
}

double bareSeconds(const Load& load) {
  asio::io_context context;
  tcp::acceptor acceptor(context, {asio::ip::address_v4::loopback(), 0});
  std::atomic<bool> isReady{false};
  std::thread server([&] {
    std::deque<WebSocket> sockets;
    for (std::size_t i = 0; i < load.clients; ++i) {
      WebSocket& socket = sockets.emplace_back(acceptor.accept());
      socket.next_layer().set_option(tcp::no_delay(true));
      socket.auto_fragment(false);
      socket.binary(true);
      socket.accept();
    }
    isReady.wait(false);
    const std::array<std::uint8_t, kMessageHeadSize> head{1};
    const std::string payload(load.bytes, 'x');
    const std::array<asio::const_buffer, 2> parts{asio::buffer(head), asio::buffer(payload)};
    for (std::size_t i = 0; i < load.messages; ++i)
      for (WebSocket& socket : sockets) socket.write(parts);
  });
  Readers readers(acceptor.local_endpoint().port(), load.clients);
  const auto start = SteadyTime::now();
  isReady = true;
  isReady.notify_all();
  readers.read(load.messages);
  const double seconds = secondsSince(start);
  server.join();
  return seconds;
}

double serverSeconds(const Load& load) {
  ServerOptions options;
  options.limits.outbox.streamBytes = ~std::size_t{0};
  std::atomic<std::size_t> subscribers{0};
  ServerHandlers handlers;
  handlers.subscribersChanged = [&](const ChannelPtr&, const std::vector<ClientInfo>& clients) {
    subscribers = clients.size();
  };
  const auto server = Server::make(options, handlers);
  const auto channel =
      server->addChannels({{"a", "json", "S", "", "", Delivery::kComplete, load.messages}})[0];
  Listener::Options listening;
  listening.address.port = 0;
  listening.greetingDelay = Duration::zero();
  const auto listener = Listener::open(server, listening).value();
  Readers readers(listener->address().port, load.clients);
  readers.subscribe(channel->id());
  while (subscribers < load.clients) std::this_thread::yield();
  const auto payload = std::make_shared<const std::string>(load.bytes, 'x');
  const auto start = SteadyTime::now();
  for (std::size_t i = 0; i < load.messages; ++i) channel->publish(Instant(), payload);
  readers.read(load.messages);
  return secondsSince(start);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void serverToClients(benchmark::State& state) {
  const auto argument = [&](std::size_t i) { return static_cast<std::size_t>(state.range(i)); };
  const Load load{argument(0), argument(1), argument(2)};
  std::vector<double> bare, served, ratios;
  for (auto unused : state) {
    static_cast<void>(unused);
    bare.push_back(bareSeconds(load));
    served.push_back(serverSeconds(load));
    ratios.push_back(bare.back() / served.back());
    state.SetIterationTime(served.back());
  }
  const auto messages = static_cast<double>(load.messages * load.clients);
  state.counters["bare_per_s"] = messages / median(bare);
  state.counters["server_per_s"] = messages / median(served);
  state.counters["server_MB_per_s"] = messages * static_cast<double>(load.bytes) / median(served) / 1e6;
  state.counters["ratio"] = median(ratios);
}
BENCHMARK(serverToClients)
    ->ArgNames({"bytes", "messages", "clients"})
    ->Args({100, 100'000, 1})
    ->Args({100'000, 10'000, 1})
    ->Args({100, 10'000, 10})
    ->Args({100'000, 1000, 10})
    ->Iterations(7)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

void publishingWithoutSubscribers(benchmark::State& state) {
  const auto server = Server::make({}, {});
  const auto channel = server->addChannels({{"a", "json", "S", ""}})[0];
  const auto payload = std::make_shared<const std::string>(100, 'x');
  for (auto unused : state) {
    static_cast<void>(unused);
    channel->publish(Instant(), payload);
  }
}
BENCHMARK(publishingWithoutSubscribers);

}  // namespace
}  // namespace robotlink::websocket::test
