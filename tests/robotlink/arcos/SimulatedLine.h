// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>

#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/stream/ByteStream.h"
#include "tests/robotlink/arcos/IdealRobot.h"

/// A robot at the end of a line, in one thread and without waiting: reading from the line advances the
/// robot's time and the client's clock. The robot outlives its lines, like a real one.
class SimulatedLine : public robotlink::arcos::ByteStream {
 public:
  struct World {
    explicit World(robotlink::arcos::ServerSettings settings = {}) : robot(std::move(settings)) {}

    IdealRobot robot;
    robotlink::ManualClock clock;
    /// Packets received from the client.
    std::vector<robotlink::arcos::Packet> commands;
    /// Whether the robot's packets are lost.
    bool silent = false;
    bool unplugged = false;
    /// Bytes that precede each packet.
    std::vector<std::uint8_t> noise;

    void advance(robotlink::Duration time) {
      for (const auto end = robot.now + time; robot.now < end;) robot.step();
      clock.set(robot.now);
    }
    int count(robotlink::arcos::CommandId id) const {
      int n = 0;
      for (const auto& command : commands) n += command.id == static_cast<std::uint8_t>(id);
      return n;
    }
  };

  explicit SimulatedLine(World& world) : world_(world) {}
  ~SimulatedLine() override { SimulatedLine::close(); }
  SimulatedLine(const SimulatedLine&) = delete;
  SimulatedLine& operator=(const SimulatedLine&) = delete;

  robotlink::Result<std::size_t> read(std::span<std::uint8_t> bytes, robotlink::Duration timeout) override {
    const auto limit = world_.robot.now + timeout;
    collect();
    while (waiting_.empty() && world_.robot.now < limit) {
      world_.advance(IdealWheels::kStep);
      collect();
    }
    if (world_.unplugged) return lost();
    const std::size_t count = std::min(bytes.size(), waiting_.size());
    const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(waiting_.begin(), end, bytes.begin());
    waiting_.erase(waiting_.begin(), end);
    return count;
  }

  robotlink::Result<void> write(std::span<const std::uint8_t> bytes) override {
    if (world_.unplugged) return lost();
    parser_.push(bytes);
    while (const auto found = parser_.next()) {
      const auto& packet = std::get<robotlink::arcos::Packet>(*found);
      world_.commands.push_back(packet);
      world_.robot.send(packet);
    }
    return {};
  }

  void close() override {
    if (!closed_) world_.robot.session.clientGone(world_.robot.now);
    closed_ = true;
  }
  std::string address() const override { return "simulated"; }

 private:
  static tl::unexpected<robotlink::Error> lost() {
    return robotlink::failure("stream.lost", "the cable was pulled");
  }
  void collect() {
    for (const auto& packet : world_.robot.received) {
      if (world_.silent) continue;
      waiting_.insert(waiting_.end(), world_.noise.begin(), world_.noise.end());
      const auto bytes = encode(packet);
      waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    }
    world_.robot.forget();
  }

  World& world_;
  robotlink::arcos::PacketParser parser_;
  std::deque<std::uint8_t> waiting_;
  bool closed_ = false;
};
