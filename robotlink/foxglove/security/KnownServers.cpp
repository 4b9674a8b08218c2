// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/security/KnownServers.h"

#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/foxglove/security/SecretFile.h"

namespace robotlink::websocket {
namespace {

constexpr std::string_view kKnownHeader = "robotcontrol-known-robots 1";
constexpr std::string_view kDigest = "SHA256:";
constexpr std::size_t kMaxKnownBytes = 4U << 20U;

std::string_view nextLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
  return line;
}

bool isDamaged(std::string_view server, std::string_view fingerprint) {
  return server.empty() || !fingerprint.starts_with(kDigest) ||
         fingerprint.find(' ') != std::string_view::npos;
}

}  // namespace

std::filesystem::path KnownServers::defaultFile() {
  return stateDirectory() / "known_robots";
}

Result<KnownServers::Fingerprints> KnownServers::parse(std::string_view text, const std::string& file) {
  Fingerprints known;
  if (text.empty()) return known;
  if (nextLine(text) != kKnownHeader)
    return failure("known.format", "the first line must be '" + std::string(kKnownHeader) + "'",
                   {file, 1, 0});
  while (!text.empty()) {
    const std::string_view line = nextLine(text);
    const std::size_t space = line.find(' ');
    if (line.starts_with('#') || space == std::string_view::npos) continue;
    const std::string_view server = line.substr(0, space), fingerprint = line.substr(space + 1);
    if (!isDamaged(server, fingerprint)) known[std::string(server)] = fingerprint;
  }
  return known;
}

Result<KnownServers::Fingerprints> KnownServers::read() const {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return Fingerprints();
  const auto text = readFile(file_, kMaxKnownBytes);
  if (!text) return tl::unexpected(text.error());
  return parse(*text, file_.string());
}

Result<bool> KnownServers::isKnown(const std::string& server, const std::string& fingerprint) const {
  const auto known = read();
  if (!known) return tl::unexpected(known.error());
  const auto found = known->find(server);
  if (found == known->end()) return false;
  if (found->second == fingerprint) return true;
  return failure(
      "known.changed",
      "the robot at " + server +
          " is not the one that was there before: its certificate has the "
          "fingerprint " +
          fingerprint + " now, it had " + found->second +
          ". Someone may be intercepting the connection. If you know that the robot was set up again, remove "
          "its line from " +
          file_.string() + " and connect again",
      {}, {server, fingerprint, found->second, file_.string()});
}

Result<void> KnownServers::add(const std::string& server, const std::string& fingerprint) const {
  auto known = read();
  if (!known) return tl::unexpected(known.error());
  (*known)[server] = fingerprint;
  std::string text = std::string(kKnownHeader) + "\n# The certificates by which robots are known again.\n";
  for (const auto& [name, digest] : *known) text.append(name).append(" ").append(digest).append("\n");
  return writeFileAtomically(file_, text);
}

}  // namespace robotlink::websocket
