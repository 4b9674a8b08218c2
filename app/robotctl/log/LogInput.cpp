// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/log/LogInput.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "app/robotctl/Interrupt.h"

namespace app {
namespace {

using robotlink::Result;

constexpr char kStandardInput[] = "-";
constexpr int kLookEveryMs = 100;  // interval of the checks for an interrupt

/// Copies all of standard input into a file.
Result<void> copyInput(const std::filesystem::path& to) {
  const auto failed = [&](const std::string& what) {
    const std::string reason = std::strerror(errno);
    return robotlink::failure("file.io", what + ": " + reason, {to.string(), 0, 0}, {reason});
  };
  const Interrupt interrupt;
  std::ofstream file(to, std::ios::binary);
  std::array<char, 1 << 16> buffer{};
  while (true) {
    pollfd ready{STDIN_FILENO, POLLIN, 0};
    const int count = ::poll(&ready, 1, kLookEveryMs);
    if (Interrupt::noted())
      return robotlink::failure("log.given-up", "canceled while standard input was read");
    if (count == 0 || (count < 0 && errno == EINTR)) continue;
    const ssize_t bytes = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes < 0) return failed("standard input cannot be read");
    if (bytes == 0) break;
    if (!file.write(buffer.data(), bytes))
      return failed("standard input cannot be stored; set TMPDIR to a place with more room");
  }
  file.close();
  if (!file) return failed("standard input cannot be stored; set TMPDIR to a place with more room");
  return {};
}

}  // namespace

Result<LogInput> LogInput::of(const std::string& argument) {
  if (argument != kStandardInput) return LogInput(argument);
  auto folder = logplayer::TemporaryFolder::make();
  if (!folder) return tl::unexpected(folder.error());
  LogInput input(folder->path() / "standard-input");
  input.copy_.emplace(std::move(*folder));
  if (const auto copied = copyInput(input.path_); !copied) return tl::unexpected(copied.error());
  return input;
}

}  // namespace app
