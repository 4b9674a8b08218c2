// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/KeyModes.h"

#include <algorithm>
#include <array>

#include "robotlink/base/ParsedNumber.h"

namespace robotlink {
namespace {

using robotcontrol::KeyMode;

struct Word {
  const char* text;
  KeyMode::Kind kind;
  bool hasNumber;
};

constexpr std::array<Word, 5> kWords{{{"off", KeyMode::OFF, false},
                                      {"always", KeyMode::ALWAYS, false},
                                      {"n", KeyMode::N_TIMES, true},
                                      {"every", KeyMode::EVERY_N, true},
                                      {"every-ms", KeyMode::EVERY_MS, true}}};

}  // namespace

std::optional<KeyMode> keyModeOf(const std::string& words) {
  const auto space = words.find(' ');
  const auto* word = std::ranges::find(kWords, words.substr(0, space),
                                       [](const Word& each) { return std::string(each.text); });
  if (word == kWords.end() || word->hasNumber != (space != std::string::npos)) return std::nullopt;
  KeyMode mode;
  mode.set_kind(word->kind);
  if (!word->hasNumber) return mode;
  constexpr std::uint32_t kMaxNumber = 9'999'999;
  const auto number = parsedNumber<std::uint32_t>(words.substr(space + 1));
  if (!number || *number > kMaxNumber) return std::nullopt;
  mode.set_n(*number);
  return mode;
}

std::string inWords(const KeyMode& mode) {
  const auto* word = std::ranges::find(kWords, mode.kind(), &Word::kind);
  if (word == kWords.end()) return "off";
  return word->text + (word->hasNumber ? " " + std::to_string(mode.n()) : std::string());
}

}  // namespace robotlink
