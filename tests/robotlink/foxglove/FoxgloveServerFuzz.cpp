// SPDX-License-Identifier: GPL-3.0-or-later
// Conversations of two clients with a server: each message has a byte for client and kind, and two for its
// length.
#include <cstdio>
#include <cstdlib>

#include "robotlink/base/ByteReader.h"
#include "robotlink/foxglove/server/Server.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/Samples.h"

using namespace robotlink;
using namespace robotlink::websocket;

namespace {

void demand(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

constexpr std::size_t kMaxWaiting = 1U << 16U;

std::shared_ptr<Server> makeServer(std::vector<Reply>& replies) {
  ServerHandlers handlers;
  handlers.clientMessage = [](const auto&...) {};
  handlers.playbackControl = [](const auto&...) {};
  handlers.setParameters = [&](const auto&, const auto&, const Reply& reply) { replies.push_back(reply); };
  handlers.fetchAsset = [](const auto&, const std::string& name, const Reply& reply) { reply.succeed(name); };
  ServerOptions options;
  options.sessionId = "s";
  options.limits.outbox = {100, kMaxWaiting, kMaxWaiting};
  auto server = Server::make(options, handlers);
  server->addService({0, "s", "S", {}, {}},
                     [&](const auto&, const auto&, const Reply& reply) { replies.push_back(reply); });
  server->updateParameters(websocket::test::sampleParameters());
  server->setAssets({"package://a.stl"});
  return server;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<Reply> replies;
  const auto server = makeServer(replies);
  auto channels =
      server->addChannels({{"a", "json", "", ""}, {"b", "json", "", "", "", Delivery::kComplete, 5}});
  const ClientPtr clients[] = {server->connect({}, [] {}).value(), server->connect({}, [] {}).value()};
  ByteReader reader(std::span(data, size));
  while (reader.good() && !reader.rest().empty()) {
    const auto head = reader.take<std::uint8_t>();
    const auto bytes = reader.take(reader.take<std::uint16_t>() % 2048U);
    const ClientPtr& client = clients[head & 1U];
    server->received(client, (head & 2U) != 0 ? FrameKind::kText : FrameKind::kBinary,
                     {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    for (const auto& channel : channels) channel->publish(Instant(), std::string(1000, 'x'));
    if ((head & 4U) != 0 && !replies.empty()) replies.back().succeed("done"), replies.pop_back();
    if ((head & 8U) != 0) server->disconnected(client);
    if ((head & 16U) != 0) server->removeChannels(std::span(channels).first(1));
    if ((head & 32U) != 0)
      while (server->next(*client, Instant())) {
      }
    for (const ClientState& state : server->clients())
      demand(state.waitingBytes <= 3 * kMaxWaiting, "memory is bounded");
  }
  for (const ClientPtr& client : clients) server->disconnected(client);
  for (const auto& channel : channels) demand(!channel->isWanted(), "nothing is wanted when nobody is there");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  std::string all;
  std::uint8_t head = 0;
  for (const auto& sample : websocket::test::clientSamples()) {
    const bool isText = sample.wire.starts_with('{');
    std::string one{static_cast<char>((head++ & 29U) | (isText ? 2U : 0U)),
                    static_cast<char>(sample.wire.size() & 255U),
                    static_cast<char>(sample.wire.size() >> 8U)};
    one += sample.wire;
    seeds.push_back(one);
    one[0] = isText ? '\x02' : '\0';
    all += one;
  }
  const std::string subscribe = encode(ClientMessage(Subscribe{{{1, 1}, {2, 2}}})).bytes;
  seeds.push_back(std::string{'\x02', static_cast<char>(subscribe.size()), '\0'} + subscribe + all);
  return seeds;
}
