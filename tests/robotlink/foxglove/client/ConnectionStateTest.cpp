// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/ConnectionState.h"

#include <gtest/gtest.h>

namespace robotlink::websocket {
namespace {

using Phase = ConnectionState::Phase;
using std::chrono::milliseconds;

ConnectionState in(Phase phase, const std::string& reason = {}) {
  ConnectionState state;
  state.phase = phase;
  state.reason = reason;
  return state;
}

TEST(ConnectionState, aConnectionIsDescribedByItsLine) {
  ConnectionState state = in(Phase::kConnected);
  EXPECT_TRUE(state.isConnected());
  EXPECT_EQ(describe(state, {}), "connected, 0 B/s");
  state.roundTrip = milliseconds(12);
  state.bytesPerSecond = 1'340'000;
  EXPECT_EQ(describe(state, {}), "connected, 12 ms, 1.3 MB/s");
  state.thinned = 0;
  state.dropped = 0;
  EXPECT_EQ(describe(state, {}), "connected, 12 ms, 1.3 MB/s") << "what is zero needs no words";
  state.thinned = 3;
  state.dropped = 1;
  EXPECT_EQ(describe(state, {}), "connected, 12 ms, 1.3 MB/s, 3 thinned, 1 dropped");
}

TEST(ConnectionState, ratesHaveTheirUnits) {
  struct Case {
    double rate;
    const char* text;
  };
  for (const Case& one : {Case{999, "999 B/s"}, Case{1000, "1.0 kB/s"}, Case{999'000, "999.0 kB/s"},
                          Case{1e6, "1.0 MB/s"}, Case{2.5e9, "2500.0 MB/s"}}) {
    ConnectionState state = in(Phase::kConnected);
    state.bytesPerSecond = one.rate;
    EXPECT_EQ(describe(state, {}), std::string("connected, ") + one.text);
  }
}

TEST(ConnectionState, whatIsNotConnectedSaysWhy) {
  EXPECT_EQ(describe(in(Phase::kConnecting), {}), "connecting");
  EXPECT_EQ(describe(in(Phase::kConnecting, "nobody listens there"), {}), "connecting: nobody listens there");
  EXPECT_EQ(describe(in(Phase::kRefused, "it wants a token"), {}), "refused: it wants a token");
  ConnectionState silent = in(Phase::kSilent, "is the cable in?");
  silent.since = Instant(milliseconds(500));
  EXPECT_EQ(describe(silent, Instant(milliseconds(3600))), "silent for 3 s: is the cable in?");
  EXPECT_FALSE(silent.isConnected());
}

}  // namespace
}  // namespace robotlink::websocket
