// SPDX-License-Identifier: GPL-3.0-or-later
// Conversations of two clients with a server: each message has a byte for client and kind, and two for its
// length.
#include "robotlink/foxglove/server/Server.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/FuzzedConversation.h"
#include "tests/robotlink/foxglove/Samples.h"

namespace foxglove_server_fuzz {

using namespace robotlink;
using namespace robotlink::websocket;
using namespace robotlink::websocket::test;

namespace {

constexpr std::size_t kMaxWaiting = 1U << 16U;

std::shared_ptr<Server> makeServer(std::vector<Reply>& replies) {
  ServerHandlers handlers;
  handlers.clientMessage = [](const auto&...) {};
  handlers.playbackControl = [](const auto&...) {};
  handlers.setParameters = [&](const auto&, const auto&, const Reply& reply) { replies.push_back(reply); };
  ServerOptions options;
  options.sessionId = "s";
  options.limits.outbox = {100, kMaxWaiting, kMaxWaiting};
  auto server = Server::make(options, handlers);
  server->addService({0, "s", "S", {}, {}},
                     [&](const auto&, const auto&, const Reply& reply) { replies.push_back(reply); });
  server->updateParameters(sampleParameters());
  return server;
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  std::vector<Reply> replies;
  const auto server = makeServer(replies);
  auto channels =
      server->addChannels({{"a", "json", "", ""}, {"b", "json", "", "", "", Delivery::kComplete, 5}});
  const ClientPtr clients[] = {server->connect({}, [] {}).value(), server->connect({}, [] {}).value()};
  ByteReader reader(std::span(data, size));
  while (const auto message = nextMessage(reader, 2048)) {
    const ClientPtr& client = clients[message->head & 1U];
    server->received(client, message->kind, message->bytes);
    for (const auto& channel : channels) channel->publish(Instant(), std::string(1000, 'x'));
    if (message->has(4) && !replies.empty()) replies.back().succeed("done"), replies.pop_back();
    if (message->has(8)) server->disconnected(client);
    if (message->has(16)) server->removeChannels(std::span(channels).first(1));
    if (message->has(32))
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
  unsigned head = 0;
  for (const auto& sample : clientSamples()) {
    seeds.push_back(framed(sample.wire, head++ & 29U));
    all += framed(sample.wire, 0);
  }
  seeds.push_back(framed(Subscribe{{{1, 1}, {2, 2}}}, 0) + all);
  return seeds;
}

const FuzzRegistration kTarget({"foxglove_server", &fuzzSeeds, &runInput});

}  // namespace foxglove_server_fuzz
