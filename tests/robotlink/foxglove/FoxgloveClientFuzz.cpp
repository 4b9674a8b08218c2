// SPDX-License-Identifier: GPL-3.0-or-later
// What a server says to a client that decodes messages for a session: each message has a byte for its kind
// and for what the client does, and two for its length. The same bytes are also what a server answers to the
// handshake, and an address.
#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Refusals.h"
#include "robotlink/foxglove/client/ServerUrl.h"
#include "robotlink/foxglove/protocol/CallPart.h"
#include "robotlink/foxglove/session/remote/RemoteInbox.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/FuzzedConversation.h"
#include "tests/robotlink/foxglove/Samples.h"

namespace foxglove_client_fuzz {

using namespace robotlink;
using namespace robotlink::websocket;
using namespace robotlink::websocket::test;

namespace {

/// A client, and how many of its calls were made and answered.
struct FuzzedClient {
  FuzzedClient() {
    handlers.channelsAdded = [this](const auto& channels) { inbox.add(channels); };
    handlers.channelsRemoved = [this](const auto& channels) { inbox.remove(channels); };
    handlers.disconnected = [this] { inbox.removeAll(); };
    handlers.message = [this](const Channel& channel, Instant time, std::string_view payload) {
      inbox.push(channel, time, payload);
    };
    client = std::make_unique<Client>(handlers, ClientLimits{20, 20, 1U << 16U, 10, 1U << 16U}, clock);
    client->subscribe({"a", "b", "t", "red1/camera/image"});
    client->subscribeParameters(true);
    client->subscribeGraph(true);
    client->advertise({0, "red1/remote/drive", "json", "", "", ""});
  }
  void call(const std::string& service, std::size_t size) {
    Client::Call call;
    call.service = service;
    call.encoding = "json";
    call.payload.assign(size, 'x');
    ++calls;
    client->call(std::move(call), [this](const auto&) { ++answers; });
  }

  const std::shared_ptr<ManualClock> clock = std::make_shared<ManualClock>();
  RemoteInbox inbox{{100, 1U << 16U}, {}};
  ClientHandlers handlers;
  std::unique_ptr<Client> client;
  int calls = 0, answers = 0;
};

/// What users read of a handshake that failed.
void checkRefusals(const std::string& text, unsigned status) {
  for (const std::string& why :
       {whyRefused(status, text, ShownToken::kOne), whyOtherProtocol(text), whyClosed(text)}) {
    demand(why == validUtf8(why) && why.size() < 1200, "a refusal can be read");
    demand(why.find_first_of("\r\n\t") == std::string::npos, "a refusal is one line");
  }
}

void checkAddress(const std::string& text) {
  const auto url = parseServerUrl(text);
  if (!url) return demand(!url.error().text.empty(), "every error has a text");
  const auto again = parseServerUrl(toString(*url));
  demand(again.has_value(), "an address that is shown can be typed");
  demand(again->host == url->host && again->port == url->port && again->isEncrypted == url->isEncrypted,
         "an address stays the same");
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  checkRefusals(text, size > 0 ? data[0] * 3U : 0);
  checkAddress(text);
  FuzzedClient fuzzed;
  Client& client = *fuzzed.client;
  client.opened();
  ByteReader reader(std::span(data, size));
  while (const auto message = nextMessage(reader, 4096)) {
    const auto heard = client.received(message->kind, message->bytes);
    if (message->has(4)) fuzzed.call("s", message->has(1) ? 10'000 : 10);
    if (message->has(8))
      while (client.next()) {
      }
    if (message->has(16)) fuzzed.clock->advance(std::chrono::seconds(1));
    client.tick();
    if (!heard || message->has(32)) {
      client.lost();
      client.opened();
    }
    if (message->has(64)) static_cast<void>(fuzzed.inbox.take());
    if (message->has(128)) client.publish("red1/remote/drive", std::string(1 + (message->head & 127U), ' '));
    demand(client.channels().size() <= 20 && client.services().size() <= 20, "offers are bounded");
  }
  client.lost();
  fuzzed.clock->advance(std::chrono::hours(1));
  client.tick();
  demand(fuzzed.calls == fuzzed.answers, "each call is answered once");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds{"ws://[::1]:8765/a?b#c", "wss://red1", "Unauthorized: give a token."};
  std::string all;
  unsigned head = 0;
  for (const auto& sample : serverSamples()) {
    seeds.push_back(framed(sample.wire, head++ & 0x5dU));
    all += framed(sample.wire, 0);
  }
  Advertise channels;
  channels.channels = {
      {1, "a", "json", "A", R"({"type":"object","properties":{"x":{"type":"number"}}})", "jsonschema"},
      {2, "b", "json", "", "", ""},
      {3, "red1/camera/image", "protobuf", "foxglove.RawImage", "", "protobuf"}};
  std::string conversation = framed(ServerInfo{"s", {"parameters"}, {}, {}, "1", {}, {}}, 0);
  conversation += framed(channels, 8);
  conversation += framed(AdvertiseServices{{{1, "s", "S", {}, {}}}}, 4);
  for (std::uint32_t id = 1; id < 4; ++id)
    conversation += framed(MessageData{id, Instant(), R"({"x":1.5,"y":[1]})"}, 0);
  conversation += framed(ServiceCallResponse{1, 1, "json", "{}"}, 8);
  seeds.push_back(conversation);
  seeds.push_back(conversation + all);
  const ServerInfo info{"s", {"assets", "clientPublish"}, {}, {{kCallPartsKey, "1"}}, "1", {}, {}};
  std::string parts = framed(info, 128);
  parts += framed(AdvertiseServices{{{1, "s", "S", {}, {}}}}, 5);
  parts += framed(FetchAssetResponse{1, "", "data"}, 8);
  seeds.push_back(parts + framed(ServiceCallResponse{1, 2, "json", "{}"}, 20));
  return seeds;
}

const FuzzRegistration kTarget({"foxglove_client", &fuzzSeeds, &runInput});

}  // namespace foxglove_client_fuzz
