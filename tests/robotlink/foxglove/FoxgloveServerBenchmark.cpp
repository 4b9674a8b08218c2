// SPDX-License-Identifier: GPL-3.0-or-later
// Messages between a server and its clients on loopback, beside the same by Beast alone: a thread that writes
// the bytes to each socket, one after the other, and one that reads them. Both are measured in turn, in one
// run, so that what else the machine does hits both alike; "ratio" is the median of their quotients, 1 if
// ours costs nothing. It is to be at least 0.6 with one client.
//   serverToClients: our server sends, Beast receives
//   serverToClient:  our server sends, our client receives
//   clientToServer:  Beast sends, our server receives
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

#include "robotlink/foxglove/client/Connector.h"
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

/// A server with the channel "a", and what came of it.
class Offer {
 public:
  explicit Offer(const Load& load) : load_(load) {
    ServerOptions options;
    options.limits.outbox.streamBytes = ~std::size_t{0};
    ServerHandlers handlers;
    handlers.subscribersChanged = [this](const ChannelPtr&, const std::vector<ClientInfo>& clients) {
      subscribers_ = clients.size();
    };
    handlers.clientMessage = [this](const auto&...) { ++received; };
    server_ = Server::make(options, handlers);
    channel_ = server_->addChannels({{"a", "json", "S", "", "", Delivery::kComplete, load.messages}})[0];
    Listener::Options listening;
    listening.address.port = 0;
    listening.greetingDelay = Duration::zero();
    listening.messagesPerSecond = 0;
    listener_ = Listener::open(server_, listening).value();
  }
  std::uint16_t port() const { return listener_->address().port; }
  std::uint64_t channel() const { return channel_->id(); }
  void waitForSubscribers() const {
    while (subscribers_ < load_.clients) std::this_thread::yield();
  }
  void publish() {
    const auto payload = std::make_shared<const std::string>(load_.bytes, 'x');
    for (std::size_t i = 0; i < load_.messages; ++i) channel_->publish(Instant(), payload);
  }

  std::atomic<std::size_t> received{0};

 private:
  const Load load_;
  std::atomic<std::size_t> subscribers_{0};
  std::shared_ptr<Server> server_;
  ChannelPtr channel_;
  std::unique_ptr<Listener> listener_;
};

double serverSeconds(const Load& load) {
  Offer offer(load);
  Readers readers(offer.port(), load.clients);
  readers.subscribe(offer.channel());
  offer.waitForSubscribers();
  const auto start = SteadyTime::now();
  offer.publish();
  readers.read(load.messages);
  return secondsSince(start);
}

void waitFor(const std::atomic<std::size_t>& count, std::size_t wanted) {
  while (count < wanted) std::this_thread::sleep_for(std::chrono::microseconds(100));
}

double linkSeconds(const Load& load) {
  Offer offer(load);
  std::atomic<std::size_t> received{0};
  ClientHandlers handlers;
  handlers.message = [&](const auto&...) { ++received; };
  const auto client = std::make_shared<Client>(handlers);
  client->subscribe({"a"});
  Connector::Options options;
  options.url = {false, "127.0.0.1", offer.port(), "/"};
  const Connector connector(client, options);
  offer.waitForSubscribers();
  const auto start = SteadyTime::now();
  offer.publish();
  waitFor(received, load.messages);
  return secondsSince(start);
}

/// Connects and sends what a client publishes on its channel 1.
void sendAsClient(std::uint16_t port, const Load& load) {
  asio::io_context context;
  WebSocket socket(context);
  socket.next_layer().connect({asio::ip::address_v4::loopback(), port});
  socket.next_layer().set_option(tcp::no_delay(true));
  socket.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
    request.set(beast::http::field::sec_websocket_protocol, kSdkProtocol);
  }));
  socket.handshake("localhost", "/");
  socket.auto_fragment(false);
  socket.write(asio::buffer(encode(ClientMessage(ClientAdvertise{{{1, "c", "json", "S", "", ""}}})).bytes));
  socket.binary(true);
  const std::array<std::uint8_t, 5> head{1, 1};
  const std::string payload(load.bytes, 'x');
  const std::array<asio::const_buffer, 2> parts{asio::buffer(head), asio::buffer(payload)};
  for (std::size_t i = 0; i < load.messages; ++i) socket.write(parts);
  beast::flat_buffer answer;
  beast::error_code ignored;
  while (!ignored) socket.read(answer, ignored);
}

double bareReceivingSeconds(const Load& load) {
  asio::io_context context;
  tcp::acceptor acceptor(context, {asio::ip::address_v4::loopback(), 0});
  const auto start = SteadyTime::now();
  std::thread client([&] { sendAsClient(acceptor.local_endpoint().port(), load); });
  double seconds = 0;
  {
    WebSocket socket(acceptor.accept());
    socket.accept();
    beast::flat_buffer buffer;
    for (std::size_t i = 0; i <= load.messages; ++i) {  // the first one advertises
      buffer.clear();
      socket.read(buffer);
    }
    seconds = secondsSince(start);
  }
  client.join();
  return seconds;
}

double serverReceivingSeconds(const Load& load) {
  auto offer = std::make_unique<Offer>(load);
  const auto start = SteadyTime::now();
  std::thread client([&, port = offer->port()] { sendAsClient(port, load); });
  waitFor(offer->received, load.messages);
  const double seconds = secondsSince(start);
  offer.reset();
  client.join();
  return seconds;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Measures ours beside the bare one.
void compare(benchmark::State& state, double (*bareOf)(const Load&), double (*oursOf)(const Load&)) {
  const auto argument = [&](std::size_t i) { return static_cast<std::size_t>(state.range(i)); };
  const Load load{argument(0), argument(1), argument(2)};
  std::vector<double> bare, ours, ratios;
  for (auto unused : state) {
    static_cast<void>(unused);
    bare.push_back(bareOf(load));
    ours.push_back(oursOf(load));
    ratios.push_back(bare.back() / ours.back());
    state.SetIterationTime(ours.back());
  }
  const auto messages = static_cast<double>(load.messages * load.clients);
  state.counters["bare_per_s"] = messages / median(bare);
  state.counters["ours_per_s"] = messages / median(ours);
  state.counters["ours_MB_per_s"] = messages * static_cast<double>(load.bytes) / median(ours) / 1e6;
  state.counters["ratio"] = median(ratios);
}

void serverToClients(benchmark::State& state) {
  compare(state, bareSeconds, serverSeconds);
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

void serverToClient(benchmark::State& state) {
  compare(state, bareSeconds, linkSeconds);
}
BENCHMARK(serverToClient)
    ->ArgNames({"bytes", "messages", "clients"})
    ->Args({100, 100'000, 1})
    ->Args({100'000, 10'000, 1})
    ->Iterations(7)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

void clientToServer(benchmark::State& state) {
  compare(state, bareReceivingSeconds, serverReceivingSeconds);
}
BENCHMARK(clientToServer)
    ->ArgNames({"bytes", "messages", "clients"})
    ->Args({100, 100'000, 1})
    ->Args({100'000, 10'000, 1})
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
