// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of both directions, JSON and binary, and what is asked at the port.
#include "robotlink/foxglove/server/Admission.h"
#include "robotlink/foxglove/server/ListenAddress.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/Demand.h"
#include "tests/robotlink/foxglove/Samples.h"

namespace foxglove_codec_fuzz {

using namespace robotlink;
using namespace robotlink::websocket;
using robotlink::websocket::test::demand;

namespace {

template <typename Message>
void check(Result<Message> (*decode)(FrameKind, std::string_view), FrameKind kind, std::string_view bytes) {
  const auto message = decode(kind, bytes);
  if (!message) return demand(!message.error().text.empty(), "every error has a text");
  const Frame frame = encode(*message);
  demand(frame.kind == kind, "a message keeps its kind");
  const auto again = decode(frame.kind, frame.bytes);
  demand(again.has_value(), "what is written can be read");
  demand(encode(*again) == frame, "what is read again is written as before");
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const FrameKind kind : {FrameKind::kText, FrameKind::kBinary}) {
    check(decodeServerMessage, kind, bytes);
    check(decodeClientMessage, kind, bytes);
  }
  Admission admission({"token", {"https://a.org"}});
  const std::string text(bytes);
  for (const Knock& knock :
       {Knock{true, text, text, {}, "Bearer token", {}}, Knock{true, text, kSdkProtocol, text, text, text}})
    static_cast<void>(admission.decide(knock, Instant()));
  if (const auto address = parseListenAddress(text))
    demand(parseListenAddress(toString(*address)) == *address, "an address stays the same");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds{"127.0.0.1:8765", "[::1]:0", "/?a=b&token=c", "x, foxglove.sdk.v1"};
  for (const auto& sample : websocket::test::serverSamples()) seeds.push_back(sample.wire);
  for (const auto& sample : websocket::test::clientSamples()) seeds.push_back(sample.wire);
  return seeds;
}

const FuzzRegistration kTarget({"foxglove_codec", &fuzzSeeds, &runInput});

}  // namespace foxglove_codec_fuzz
