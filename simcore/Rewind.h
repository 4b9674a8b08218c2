// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace simcore {

/// The kinds of external commands to a simulation: one for each function of Simulation that changes its
/// state.
enum class CommandKind : std::uint8_t {
  kAngle,
  kTorqueLimit,
  kWheelSpeeds,
  kDriveOn,
  kGuide,
  kDoor,
  kPlace,
  kErrors,
  kTurn,
  kThrow,
  kPin,
  kDrag,
  kRelease,
  kPush,
  kEvent,
};

/// The recent past of a simulation: its state each kPeriod steps, and all commands since the oldest of them,
/// so that every step in between can be computed again. Bounded by bytes; the oldest is given up. Only for
/// the sources of Simulation. One thread at a time.
class Rewind {
 public:
  /// Steps from state to state: a second.
  static constexpr std::uint64_t kPeriod = 250;

  struct Command {
    CommandKind kind = CommandKind::kAngle;
    std::uint32_t index = 0;
    std::vector<double> values;
    std::string text;
  };

  explicit Rewind(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  /// Whether a state is to be added at a step.
  bool isDue(std::uint64_t step) const {
    return segments_.empty() || step >= segments_.back().step + kPeriod;
  }
  /// Adds the state after a step, beyond the last one.
  void add(std::uint64_t step, std::vector<std::uint8_t> state);
  /// Notes a command that counts from a step on.
  void note(std::uint64_t step, CommandKind kind, std::size_t index, std::span<const double> values,
            const std::string& text);
  void clear();

  /// The step of the oldest state.
  std::optional<std::uint64_t> oldest() const;
  /// The step of the last state up to a step, which must not be before the oldest, and that state.
  std::uint64_t stateBefore(std::uint64_t step) const;
  const std::vector<std::uint8_t>& stateAt(std::uint64_t step) const;
  /// Calls `apply` for the commands that count from exactly this step on, in order, of the state at `from`.
  void replay(std::uint64_t from, std::uint64_t step, const std::function<void(const Command&)>& apply);
  /// Forgets what came after a step.
  void forgetAfter(std::uint64_t step);

 private:
  struct Segment {
    std::uint64_t step = 0;
    std::vector<std::uint8_t> state, commands;
    /// The position in `commands` that replay() has reached.
    std::size_t next = 0;
    std::size_t bytes() const { return sizeof *this + state.size() + commands.size(); }
  };
  Segment& segmentOf(std::uint64_t step);
  void giveUpOldest();

  std::size_t maxBytes_;
  std::size_t bytes_ = 0;
  std::deque<Segment> segments_;
};

}  // namespace simcore
