// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// The tokens that a user wanted to be remembered, by the URLs of the servers that they are for: one for
/// wss:// is never shown to ws://. Reads the file each time, so that several programs may use it at once. Any
/// thread.
///
/// The file, with mode 0600: the line "robotcontrol-robot-tokens 1", then lines "URL TOKEN". Empty lines and
/// those that begin with # are ignored; so are lines that are damaged.
class RememberedTokens {
 public:
  using ByUrl = std::map<std::string, std::string>;

  /// The path of the user's file, in stateDirectory().
  static std::filesystem::path defaultFile();
  explicit RememberedTokens(std::filesystem::path file = defaultFile()) : file_(std::move(file)) {}

  /// Reads the tokens; none without a file. Fails if the file has another format, or if others may read it.
  Result<ByUrl> read() const;
  /// The token for a URL, as toString(ServerUrl) has it; nothing if there is none, or if the file cannot be
  /// read.
  std::optional<std::string> find(const std::string& url) const;
  /// Remembers a token, replacing an earlier one.
  Result<void> add(const std::string& url, const std::string& token) const;
  Result<void> forget(const std::string& url) const;

  static Result<ByUrl> parse(std::string_view text, const std::string& file);

 private:
  Result<void> write(const ByUrl& tokens) const;

  const std::filesystem::path file_;
};

}  // namespace robotlink::websocket
