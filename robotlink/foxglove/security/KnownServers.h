// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// The fingerprints of the servers' certificates that a user has seen, as ssh's known_hosts: a server that is
/// known must show the same one again. Reads the file each time, so that several programs may use it at once.
/// Any thread.
///
/// The file: the line "robotcontrol-known-robots 1", then lines "HOST:PORT FINGERPRINT". Empty lines and
/// those that begin with # are ignored; so are lines that are damaged, with the effect that their servers are
/// new.
class KnownServers {
 public:
  using Fingerprints = std::map<std::string, std::string>;

  /// The path of the user's file, in stateDirectory().
  static std::filesystem::path defaultFile();
  explicit KnownServers(std::filesystem::path file = defaultFile()) : file_(std::move(file)) {}

  /// Reads the fingerprints, keyed by "HOST:PORT"; none without a file. Fails if the file has another format.
  Result<Fingerprints> read() const;
  /// Whether the server is known. Fails if it shows another fingerprint than before, with a sentence that
  /// says what that may mean and what to do.
  Result<bool> isKnown(const std::string& server, const std::string& fingerprint) const;
  /// Remembers a server, replacing an earlier entry.
  Result<void> add(const std::string& server, const std::string& fingerprint) const;

  static Result<Fingerprints> parse(std::string_view text, const std::string& file);

 private:
  const std::filesystem::path file_;
};

}  // namespace robotlink::websocket
