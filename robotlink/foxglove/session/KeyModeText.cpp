// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/KeyModeText.h"

#include <regex>

namespace robotlink::websocket {

using robotcontrol::KeyMode;

std::string textOf(const KeyMode& mode) {
  const std::string n = std::to_string(mode.n());
  switch (mode.kind()) {
    case KeyMode::ALWAYS:
      return "always";
    case KeyMode::N_TIMES:
      return n + " times";
    case KeyMode::EVERY_N:
      return "every " + n;
    case KeyMode::EVERY_MS:
      return "every " + n + " ms";
    default:
      return "off";
  }
}

Result<KeyMode> keyModeOf(const std::string& text) {
  static const std::regex kForm(R"((off)|(always)|([1-9]\d{0,8}) times|every ([1-9]\d{0,8})( ms)?)");
  std::smatch match;
  if (!std::regex_match(text, match, kForm)) {
    return failure(
        "foxglove.key-mode",
        "the mode of a debug key is off, always, '5 times', 'every 3' or 'every 200 ms', not '" + text + "'");
  }
  KeyMode mode;
  if (match[2].matched) mode.set_kind(KeyMode::ALWAYS);
  if (match[3].matched) mode.set_kind(KeyMode::N_TIMES);
  if (match[4].matched) mode.set_kind(match[5].matched ? KeyMode::EVERY_MS : KeyMode::EVERY_N);
  const std::string n = match[3].str() + match[4].str();
  if (!n.empty()) mode.set_n(static_cast<std::uint32_t>(std::stoul(n)));
  return mode;
}

}  // namespace robotlink::websocket
