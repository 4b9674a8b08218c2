// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/security/RememberedTokens.h"

#include <algorithm>

#include "robotlink/foxglove/security/SecretFile.h"

namespace robotlink::websocket {
namespace {

constexpr std::string_view kRememberedHeader = "robotcontrol-robot-tokens 1";

/// Whether a word is read back as it was written, and fits into a line of HTTP.
bool isPlain(std::string_view word) {
  return !word.empty() && std::ranges::all_of(word, [](char c) { return c > ' ' && c < 127; });
}

}  // namespace

std::filesystem::path RememberedTokens::defaultFile() {
  return stateDirectory() / "robot_tokens";
}

Result<RememberedTokens::ByUrl> RememberedTokens::parse(std::string_view text, const std::string& file) {
  ByUrl tokens;
  bool isFirst = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (std::exchange(isFirst, false)) {
      if (line == kRememberedHeader) continue;
      return failure("tokens.format", "the first line must be '" + std::string(kRememberedHeader) + "'",
                     {file, 1, 0});
    }
    const std::size_t space = line.find(' ');
    if (line.starts_with('#') || space == std::string_view::npos) continue;
    const std::string_view url = line.substr(0, space), token = line.substr(space + 1);
    if (isPlain(url) && isPlain(token)) tokens[std::string(url)] = token;
  }
  return tokens;
}

Result<RememberedTokens::ByUrl> RememberedTokens::read() const {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return ByUrl();
  const auto text = readSecret(file_);
  if (!text) return tl::unexpected(text.error());
  return parse(*text, file_.string());
}

std::optional<std::string> RememberedTokens::find(const std::string& url) const {
  const auto tokens = read();
  if (!tokens) return std::nullopt;
  const auto found = tokens->find(url);
  return found == tokens->end() ? std::nullopt : std::optional(found->second);
}

Result<void> RememberedTokens::add(const std::string& url, const std::string& token) const {
  if (!isPlain(url) || !isPlain(token))
    return failure("tokens.text", "a token must not contain blanks or non-ASCII characters");
  auto tokens = read();
  if (!tokens) return tl::unexpected(tokens.error());
  (*tokens)[url] = token;
  return write(*tokens);
}

Result<void> RememberedTokens::forget(const std::string& url) const {
  auto tokens = read();
  if (!tokens) return tl::unexpected(tokens.error());
  return tokens->erase(url) == 0 ? Result<void>() : write(*tokens);
}

Result<void> RememberedTokens::write(const ByUrl& tokens) const {
  std::string text = std::string(kRememberedHeader) + "\n# What this user shows to robots. Keep it secret.\n";
  for (const auto& [url, token] : tokens) text.append(url).append(" ").append(token).append("\n");
  return replaceSecret(file_, text);
}

}  // namespace robotlink::websocket
