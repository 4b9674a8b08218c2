// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MotionCommands.h"

#include <functional>
#include <memory>

#include "robotlink/commands/CommandTable.h"
#include "widgets/motion/ManualSteering.h"
#include "widgets/motion/MotionButtons.h"

namespace widgets {
namespace {

using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;
using Values = CommandTable::Values;

/// The motions that have a button.
std::vector<std::string> motionNames() {
  std::vector<std::string> names{MotionCommander::kGetUp};
  for (const QString& name : MotionButtons::shippedMotions()) names.push_back(name.toStdString());
  return names;
}

Result<void> play(ManualSteering& steering, const std::string& name) {
  std::string known;
  for (const std::string& motion : motionNames()) {
    if (motion == name) return steering.play(name);
    known += (known.empty() ? "" : ", ") + motion;
  }
  return failure("robot.motion", "there is no motion " + name + "; there are " + known, {}, {name});
}

}  // namespace

void attachMotionCommands(ViewContext& context) {
  if (context.commands.isAttached("robot.take-over")) return;
  manualSteering(context);
  using Run = std::function<Result<void>(ManualSteering&, const Values&)>;
  const auto attach = [&](const char* name, Run run, CommandTable::Offer offer = {}) {
    const auto act = [run = std::move(run),
                      shared = std::weak_ptr(context.steering)](const Values& values) -> Result<void> {
      if (const auto steering = shared.lock()) return run(*steering, values);
      return failure("robot.closed", "the window that steered the robot is closed");
    };
    context.commands.attach(name, act, std::move(offer));
  };
  attach("robot.take-over",
         [](auto& steering, const Values& values) { return steering.takeOver(std::get<bool>(values[0])); });
  attach("robot.walk", [](auto& steering, const Values& values) {
    return steering.walk(
        {std::get<double>(values[0]), std::get<double>(values[1]), std::get<double>(values[2])});
  });
  attach("robot.stand", [](auto& steering, auto&) { return steering.stand(); });
  attach("robot.head", [](auto& steering, const Values& values) {
    return steering.setHeadMode(std::get<std::string>(values[0]));
  });
  attach("robot.head-joint", [](auto& steering, const Values& values) {
    return steering.setHeadJoint(std::get<std::string>(values[0]), std::get<double>(values[1]));
  });
  attach(
      "robot.motion",
      [](auto& steering, const Values& values) { return play(steering, std::get<std::string>(values[0])); },
      [](const auto&) { return motionNames(); });
}

}  // namespace widgets
