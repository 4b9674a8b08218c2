// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/ConnectionState.h"

#include <array>
#include <cstdio>

namespace robotlink::websocket {
namespace {

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string rateText(double bytesPerSecond) {
  if (bytesPerSecond >= 1e6) return formatted("%.1f MB/s", bytesPerSecond / 1e6);
  if (bytesPerSecond >= 1e3) return formatted("%.1f kB/s", bytesPerSecond / 1e3);
  return formatted("%.0f B/s", bytesPerSecond);
}

std::string withReason(const std::string& text, const std::string& reason) {
  return reason.empty() ? text : text + ": " + reason;
}

}  // namespace

std::string describe(const ConnectionState& state, Instant now) {
  switch (state.phase) {
    case ConnectionState::Phase::kConnected: {
      std::string text = "connected";
      if (state.roundTrip) text += formatted(", %.0f ms", seconds(*state.roundTrip) * 1e3);
      text += ", " + rateText(state.bytesPerSecond);
      if (state.thinned.value_or(0) > 0) text += ", " + std::to_string(*state.thinned) + " thinned";
      if (state.dropped.value_or(0) > 0) text += ", " + std::to_string(*state.dropped) + " dropped";
      return text;
    }
    case ConnectionState::Phase::kSilent:
      return withReason(formatted("silent for %.0f s", seconds(now - state.since)), state.reason);
    case ConnectionState::Phase::kRefused:
      return withReason("refused", state.reason);
    default:
      return withReason("connecting", state.reason);
  }
}

}  // namespace robotlink::websocket
