// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "simcore/control/ControllerKind.h"
#include "simcore/control/ControllerOutput.h"
#include "simcore/world/ControllerDescription.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// The status of a controller of a simulation. A plain value.
struct ControllerStatus {
  /// "lift/elevator", or "referee" of the world.
  std::string path;
  /// The name of its model; empty: it is of the world.
  std::string model;
  std::string kind;
  /// Why it was switched off, and in which step; empty while it is on.
  std::string trouble = {};
  std::uint64_t troubleStep = 0;

  bool isOn() const { return trouble.empty(); }
};

/// The controllers of a simulation: makes them, calls them before each step in the order of the scene, first
/// those of the world, and switches off those that throw or whose outputs are wrong. One thread at a time.
class Controllers {
 public:
  /// Creates controllers that do not run before start(). The world must outlive this object.
  explicit Controllers(const WorldDescription& world);
  ~Controllers();
  Controllers(const Controllers&) = delete;
  Controllers& operator=(const Controllers&) = delete;

  bool isEmpty() const { return all_.empty(); }
  /// Makes all of them, at the start and after each reset. From the second time on they have the outputs that
  /// they had at first: those that declare others are switched off.
  void start(ControlledWorld& world);
  void step(ControlledWorld& world);
  /// Has controllers of the same path and kind remember what those of another simulation do.
  void adopt(const Controllers& before);

  std::span<const ControllerStatus> status() const { return status_; }
  /// In the order of the controllers; the pointers are valid until start().
  std::span<const ControllerOutput* const> outputs() const { return outputs_; }
  /// The state of controllers at an instant, for snapshots of a simulation.
  struct Memory {
    /// The state of each controller, as it returned it.
    std::vector<std::string> states = {};
    /// The contents of the outputs, in the order of outputs().
    std::vector<ControllerOutput> shown = {};
    /// Why and in which step each was switched off; empty while it is on.
    std::vector<std::pair<std::string, std::uint64_t>> troubles = {};
  };
  Memory memory() const;
  /// Restores controllers that have just started from a memory of the same scene.
  void restore(const Memory& memory, std::uint64_t step);

  /// A hash of all outputs; 0 if there are no controllers.
  std::uint64_t digest() const;

 private:
  struct Running;
  /// Calls something of a controller; an exception switches it off.
  template <typename Call>
  void guard(std::size_t index, std::uint64_t step, Call call);
  void switchOff(std::size_t index, std::uint64_t step, const std::string& why);
  std::vector<std::string> states() const;
  void make(std::size_t index, ControlledWorld& world);
  void checkOutputs(std::size_t index, std::uint64_t step);

  std::vector<std::unique_ptr<Running>> all_;
  std::vector<ControllerStatus> status_;
  std::vector<const ControllerOutput*> outputs_;
  bool hasStarted_ = false;
};

}  // namespace simcore
