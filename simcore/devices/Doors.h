// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "simcore/devices/Actuation.h"
#include "simcore/devices/Ports.h"

namespace simcore {

class StateStream;

/// Opens and closes the doors of a world: joints with a servo and a DoorDescription. A door opens when its
/// sensor reads less than a distance or is touched, or on command, and closes some time after the last such
/// event. Sensors are read kLookSteps apart. One thread at a time.
class Doors {
 public:
  static constexpr std::uint64_t kLookSteps = 10;

  /// Both must outlive it. The doors begin closed, which their servos begin to do at once.
  Doors(const Ports& ports, Actuation& actuation);

  /// The smallest number that the sensor of a door reads now; it is only called for doors that have one.
  using Reading = std::function<double(const Door& door)>;
  /// Call this after each step of the physics, whose number is `step`.
  void afterStep(std::uint64_t step, const Reading& reading);

  /// Opens a door for its time, or closes it at once; if its sensor still detects something, it opens again.
  void command(std::size_t door, bool open, std::uint64_t step);
  /// A door continues at step `now` as another one at step `then` of its simulation; its servo does so, too.
  void takeOver(std::size_t door, const Doors& before, std::size_t other, std::uint64_t then,
                std::uint64_t now) {
    states_[door] = before.states_[other];
    std::uint64_t& closesAt = states_[door].closesAt;
    closesAt = closesAt > then ? closesAt - then + now : std::min(closesAt, now);
  }
  /// Writes or reads which doors are open, and until when.
  void transfer(StateStream& stream);
  /// Whether it opens or is open.
  bool isOpen(std::size_t door) const { return states_[door].open; }

 private:
  struct State {
    bool open = false;
    std::uint64_t closesAt = 0;
  };
  void move(std::size_t door, bool open, std::uint64_t step);

  const Ports& ports_;
  Actuation& actuation_;
  std::vector<State> states_;
};

}  // namespace simcore
