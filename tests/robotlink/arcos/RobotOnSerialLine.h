// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <thread>

#include "robotlink/arcos/codec/PacketParser.h"
#include "tests/robotlink/arcos/IdealRobot.h"
#include "tests/robotlink/arcos/PseudoTerminal.h"

/// A robot that runs in real time at the end of a bad serial line of 9600 baud: bytes arrive one by one,
/// every fifth packet has a wrong byte, and there is noise between packets. The robot does not notice when
/// the cable is pulled.
class RobotOnSerialLine {
 public:
  explicit RobotOnSerialLine(PseudoTerminal& line)
      : line_(line), thread_([this](const std::stop_token& stop) { run(stop); }) {}

  /// Pulls the cable; the robot keeps running.
  void pull() {
    const std::lock_guard lock(mutex_);
    line_.unplug();
  }
  void plugIn() {
    const std::lock_guard lock(mutex_);
    line_.plugIn();
  }
  /// Number of bytes from the client that were not part of a packet.
  std::uint64_t skippedBytes() const { return skippedBytes_; }

 private:
  static constexpr double kBytesPerSecond = 960;

  void run(const std::stop_token& stop) {
    const robotlink::SteadyClock clock;
    double sent = 0;
    while (!stop.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(3));
      const std::lock_guard lock(mutex_);
      listen();
      while (robot_.now < clock.now()) robot_.step();
      for (const auto& packet : robot_.received) queue(packet);
      robot_.forget();
      // The number of bytes that the line could have carried so far; time while it is idle does not count.
      const double carried = kBytesPerSecond * robotlink::seconds(clock.now());
      if (waiting_.empty()) sent = carried;
      for (; sent < carried && !waiting_.empty(); ++sent) transmit();
    }
  }

  void listen() {
    std::array<std::uint8_t, 256> bytes{};
    pollfd polled{line_.master(), POLLIN, 0};
    while (polled.fd >= 0 && ::poll(&polled, 1, 0) > 0 && (polled.revents & POLLIN)) {
      const ssize_t count = ::read(polled.fd, bytes.data(), bytes.size());
      if (count <= 0) break;
      parser_.push(std::span(bytes).first(static_cast<std::size_t>(count)));
    }
    while (const auto found = parser_.next()) {
      if (const auto* packet = std::get_if<robotlink::arcos::Packet>(&*found)) robot_.send(*packet);
    }
    skippedBytes_ = parser_.counters().skippedBytes;
  }

  void queue(const robotlink::arcos::Packet& packet) {
    auto bytes = encode(packet);
    if (++packets_ % 5 == 0) bytes[bytes.size() / 2] ^= 0x10U;
    if (packets_ % 3 == 0) waiting_.insert(waiting_.end(), {0x00, 0xFA, 0x7F});
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  }

  void transmit() {
    const std::uint8_t byte = waiting_.front();
    waiting_.pop_front();
    if (line_.master() >= 0 && ::write(line_.master(), &byte, 1) != 1) waiting_.clear();
  }

  PseudoTerminal& line_;
  /// Protects line_ and the robot.
  std::mutex mutex_;
  IdealRobot robot_;
  robotlink::arcos::PacketParser parser_;
  std::deque<std::uint8_t> waiting_;
  int packets_ = 0;
  std::atomic<std::uint64_t> skippedBytes_{0};
  /// Declared last, since it uses all others.
  std::jthread thread_;
};
