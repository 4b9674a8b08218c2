// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/PioneerGripper.h"

#include <algorithm>

#include "simcore/Simulation.h"

namespace app {

using robotlink::arcos::GripperCommand;
using robotlink::arcos::GripperSensing;

namespace {

/// The ends of slides, m: a position as near as that counts as the end.
constexpr double kEnd = 0.003;
/// The distance of a paddle's target behind its place while it presses, m.
constexpr double kPress = 0.01;

template <typename Devices>
bool findDevice(const Devices& devices, const std::string& path, std::size_t& index) {
  const auto found = std::ranges::find(
      devices, path, [](const auto& device) -> const std::string& { return device.info.path; });
  index = static_cast<std::size_t>(found - devices.begin());
  return found != devices.end();
}

}  // namespace

bool PioneerGripper::find(const simcore::Simulation& simulation, const std::string& path, Slide& slide) {
  return findDevice(simulation.servos(), path + "/request", slide.servo) &&
         findDevice(simulation.sensors(), path + "/position", slide.position);
}

std::optional<PioneerGripper> PioneerGripper::of(const simcore::Simulation& simulation,
                                                 const std::string& robot) {
  PioneerGripper gripper;
  const auto sensor = [&](const char* name, std::size_t& index) {
    return findDevice(simulation.sensors(), robot + "/" + name, index);
  };
  const bool complete = find(simulation, robot + "/paddleLeft", gripper.left_) &&
                        find(simulation, robot + "/paddleRight", gripper.right_) &&
                        find(simulation, robot + "/lift", gripper.lift_) &&
                        sensor("paddleLeftTouch", gripper.leftTouch_) &&
                        sensor("paddleRightTouch", gripper.rightTouch_) &&
                        sensor("innerBeam", gripper.innerBeam_) && sensor("outerBeam", gripper.outerBeam_);
  return complete ? std::optional(gripper) : std::nullopt;
}

GripperSensing PioneerGripper::sense(const simcore::Simulation& simulation) const {
  const auto sensors = simulation.sensors();
  const auto value = [&](std::size_t index) { return sensors[index].values[0]; };
  const auto atEnd = [&](const Slide& slide, bool upper) {
    const simcore::Servo& servo = simulation.servos()[slide.servo];
    const double end = upper ? servo.maximum : servo.minimum;
    return std::abs(value(slide.position) - end) < kEnd;
  };
  const double gap = value(left_.position) + value(right_.position);
  GripperSensing sensing;
  sensing.open = atEnd(left_, true) && atEnd(right_, true);
  sensing.closed = atEnd(left_, false) && atEnd(right_, false);
  sensing.liftUp = atEnd(lift_, true);
  sensing.liftDown = atEnd(lift_, false);
  sensing.leftPaddle = value(leftTouch_) > 0;
  sensing.rightPaddle = value(rightTouch_) > 0;
  // The beams end at the other paddle.
  sensing.innerBeam = value(innerBeam_) < gap;
  sensing.outerBeam = value(outerBeam_) < gap;
  return sensing;
}

void PioneerGripper::move(simcore::Simulation& simulation, const Slide& slide, int direction,
                          double preload) const {
  const simcore::Servo& servo = simulation.servos()[slide.servo];
  const double here = simulation.sensors()[slide.position].values[0];
  if (direction > 0) simulation.requestAngle(slide.servo, servo.maximum);
  if (direction < 0) simulation.requestAngle(slide.servo, std::max(servo.minimum, here - kPress));
  // A slide that holds is not commanded again, so that it does not creep; one that is to stop, stops here.
  const bool moving = !simulation.servoState(slide.servo).reached;
  if (direction == 0 && preload == 0 && moving) simulation.requestAngle(slide.servo, here);
}

void PioneerGripper::move(simcore::Simulation& simulation, const GripperCommand& command) const {
  const double preload = command.grasps ? kPress : 0;
  move(simulation, left_, command.paddles, preload);
  move(simulation, right_, command.paddles, preload);
  move(simulation, lift_, command.lift, 0);
}

}  // namespace app
