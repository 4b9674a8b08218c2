// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "robotcontrol/Perception.pb.h"
#include "robotlink/process/Process.h"

namespace robotlink::test {

/// A process whose frame is a function of the test.
class TestProcess final : public Process {
 public:
  using Process::Process;
  std::function<void()> body = [] {};

  /// Executes a frame, if it may begin.
  bool step() {
    if (!tryBeginFrame()) return false;
    runFrame();
    return true;
  }

 protected:
  void execute() override { body(); }
};

using Ball = robotcontrol::BallPercept;

/// A package that contains a number.
inline std::shared_ptr<const Ball> ball(double number) {
  auto package = std::make_shared<Ball>();
  package->set_radius_in_image(number);
  return package;
}

/// The number; -1 if there is no package yet.
inline double numberIn(const Receiver<Ball>& receiver) {
  return receiver.get() != nullptr ? receiver.get()->radius_in_image() : -1;
}

}  // namespace robotlink::test
