// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/ConnectionState.h"

#include <fmt/format.h>

namespace robotlink::websocket {
namespace {

std::string rateText(double bytesPerSecond) {
  if (bytesPerSecond >= 1e6) return fmt::format("{:.1f} MB/s", bytesPerSecond / 1e6);
  if (bytesPerSecond >= 1e3) return fmt::format("{:.1f} kB/s", bytesPerSecond / 1e3);
  return fmt::format("{:.0f} B/s", bytesPerSecond);
}

std::string withReason(const std::string& text, const std::string& reason) {
  return reason.empty() ? text : text + ": " + reason;
}

}  // namespace

std::string describe(const ConnectionState& state, Instant now) {
  switch (state.phase) {
    case ConnectionState::Phase::kConnected: {
      std::string text = "connected";
      if (state.roundTrip) text += fmt::format(", {:.0f} ms", seconds(*state.roundTrip) * 1e3);
      text += ", " + rateText(state.bytesPerSecond);
      if (state.thinned.value_or(0) > 0) text += ", " + std::to_string(*state.thinned) + " thinned";
      if (state.dropped.value_or(0) > 0) text += ", " + std::to_string(*state.dropped) + " dropped";
      return text;
    }
    case ConnectionState::Phase::kSilent:
      return withReason(fmt::format("silent for {:.0f} s", seconds(now - state.since)), state.reason);
    case ConnectionState::Phase::kRefused:
      return withReason("refused", state.reason);
    default:
      return withReason("connecting", state.reason);
  }
}

}  // namespace robotlink::websocket
