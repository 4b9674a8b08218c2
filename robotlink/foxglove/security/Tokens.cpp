// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/security/Tokens.h"

#include <sys/random.h>

#include <algorithm>
#include <array>

#include "robotlink/base/TextParts.h"
#include "robotlink/foxglove/security/SecretFile.h"

namespace robotlink::websocket {
namespace {

constexpr std::string_view kTokensHeader = "robotcontrol-tokens 1";
constexpr std::size_t kMinToken = 16, kMaxToken = 200;

bool isTokenCharacter(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("-._~").find(c) != std::string_view::npos;
}

std::string problemOfToken(std::string_view token) {
  if (token.size() < kMinToken || token.size() > kMaxToken) return "a token has 16 to 200 characters";
  if (!std::ranges::all_of(token, isTokenCharacter)) return "a token has letters, digits and -._~ only";
  return {};
}

/// Takes a line of the file. Returns the problem with it; empty if there is none.
std::string takeTokenLine(std::string_view line, Tokens& to) {
  const std::size_t space = line.find_first_of(" \t");
  const std::string_view kind = line.substr(0, space);
  const std::string_view token = space == std::string_view::npos ? "" : trimmed(line.substr(space));
  std::string* place = kind == "control" ? &to.control : kind == "watch" ? &to.watch : nullptr;
  if (place == nullptr) return "a line is 'control TOKEN' or 'watch TOKEN'";
  if (!place->empty()) return "there is a line '" + std::string(kind) + "' already";
  if (std::string problem = problemOfToken(token); !problem.empty()) return problem;
  *place = token;
  return {};
}

}  // namespace

Result<Tokens> parseTokens(std::string_view text, const std::string& file) {
  Tokens tokens;
  int number = 0;
  const auto wrong = [&](const std::string& why) { return failure("tokens.syntax", why, {file, number, 0}); };
  while (!text.empty()) {
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    text.remove_prefix(
        std::min(text.size(), text.find('\n') == text.npos ? text.size() : text.find('\n') + 1));
    if (++number == 1) {
      if (line != kTokensHeader) return wrong("the first line must be '" + std::string(kTokensHeader) + "'");
    } else if (!line.empty() && line.front() != '#') {
      if (const std::string why = takeTokenLine(line, tokens); !why.empty()) return wrong(why);
    }
  }
  if (tokens.control.empty() && tokens.watch.empty())
    return wrong("there is no token: add a line 'control TOKEN', or remove the file to have one created");
  if (tokens.control == tokens.watch)
    return wrong("both tokens are the same, so no client could be limited to watching; change one");
  return tokens;
}

std::string toText(const Tokens& tokens) {
  std::string text =
      std::string(kTokensHeader) +
      "\n# Whoever has a token may connect to this robot: with 'control' to do everything, with\n"
      "# 'watch' to look. Without this file new ones are made.\n";
  if (!tokens.control.empty()) text += "control " + tokens.control + "\n";
  if (!tokens.watch.empty()) text += "watch " + tokens.watch + "\n";
  return text;
}

Result<Tokens> makeTokens() {
  std::array<unsigned char, 32> random{};
  if (::getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size()))
    return failure("tokens.random", "the system provides no random numbers to create a token");
  std::string text;
  for (const unsigned char byte : random)
    for (const unsigned digit : {byte / 16U, byte % 16U}) text += "0123456789abcdef"[digit];
  return Tokens{text.substr(0, random.size()), text.substr(random.size())};
}

Result<KeptTokens> loadOrMakeTokens(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    auto made = makeTokens();
    if (!made) return tl::unexpected(made.error());
    const auto created = createSecret(file, toText(*made));
    if (!created) return tl::unexpected(created.error());
    if (*created) return KeptTokens{*std::move(made), true};
  }
  const auto text = readSecret(file);
  if (!text) return tl::unexpected(text.error());
  auto tokens = parseTokens(*text, file.string());
  if (!tokens) return tl::unexpected(tokens.error());
  return KeptTokens{*std::move(tokens), false};
}

}  // namespace robotlink::websocket
