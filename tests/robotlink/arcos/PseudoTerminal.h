// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

/// A serial line without hardware: the program under test opens path(), and the test is the device at the
/// other end of the cable. plugIn() and unplug() may be repeated; path() stays the same, like that of a USB
/// adapter.
class PseudoTerminal {
 public:
  /// Creates `path` as a symbolic link to the pseudo-terminal.
  explicit PseudoTerminal(std::filesystem::path path) : path_(std::move(path)) { plugIn(); }
  ~PseudoTerminal() { unplug(); }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void plugIn() {
    int slave = -1;
    std::array<char, 256> name{};
    termios raw{};
    ::cfmakeraw(&raw);
    if (::openpty(&master_, &slave, name.data(), &raw, nullptr) != 0)
      throw std::runtime_error("openpty failed");
    ::close(slave);
    std::filesystem::create_symlink(name.data(), path_);
  }

  void unplug() {
    if (master_ < 0) return;
    ::close(master_);
    master_ = -1;
    std::filesystem::remove(path_);
  }

  std::string url(int baud = 9600) const {
    return "serial://" + path_.string() + "?baud=" + std::to_string(baud);
  }
  const std::filesystem::path& path() const { return path_; }

  /// Sends at the speed of a line of `baud` (10 bits per byte), in pieces of `piece` bytes.
  void send(std::span<const std::uint8_t> bytes, int baud = 9600, std::size_t piece = 7) const {
    auto due = std::chrono::steady_clock::now();
    while (!bytes.empty()) {
      const auto now = bytes.first(std::min(piece, bytes.size()));
      due += std::chrono::microseconds(10'000'000LL * static_cast<long long>(now.size()) / baud);
      std::this_thread::sleep_until(due);  // a byte has arrived when its last bit has
      if (::write(master_, now.data(), now.size()) != static_cast<ssize_t>(now.size())) {
        throw std::runtime_error("the pseudo-terminal takes no bytes");
      }
      bytes = bytes.subspan(now.size());
    }
  }

  /// Returns what the program under test has sent; waits for at least `count` bytes, but for at most 2 s.
  std::vector<std::uint8_t> receive(std::size_t count) const {
    std::vector<std::uint8_t> bytes;
    while (bytes.size() < count) {
      pollfd polled{master_, POLLIN, 0};
      std::array<std::uint8_t, 256> piece{};
      if (::poll(&polled, 1, 2000) <= 0) break;
      const ssize_t got = ::read(master_, piece.data(), piece.size());
      if (got <= 0) break;
      bytes.insert(bytes.end(), piece.begin(), piece.begin() + got);
    }
    return bytes;
  }

  int master() const { return master_; }

 private:
  const std::filesystem::path path_;
  int master_ = -1;
};
