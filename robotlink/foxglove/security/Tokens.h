// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// The tokens that authorize clients: one for clients with full control, one for those that may only
/// watch. An empty token admits no client.
struct Tokens {
  std::string control, watch;
  bool operator==(const Tokens&) const = default;
};

// The file: the line "robotcontrol-tokens 1", then lines "control TOKEN" and "watch TOKEN". A token has 16 to
// 200 letters, digits, or any of -._~ . Empty lines and those that begin with # are ignored.

/// Fails with the line of the first mistake; `file` is for that.
Result<Tokens> parseTokens(std::string_view text, const std::string& file);
std::string toText(const Tokens& tokens);
/// Two random tokens of 128 bits.
Result<Tokens> makeTokens();

/// The tokens of a robot, and whether they were made just now and have to be shown.
struct KeptTokens {
  Tokens tokens;
  bool isNew = false;
};
/// Reads the file, or makes it with mode 0600 if there is none.
Result<KeptTokens> loadOrMakeTokens(const std::filesystem::path& file);

}  // namespace robotlink::websocket
