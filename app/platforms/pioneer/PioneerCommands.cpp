// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerCommands.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "app/core/CommandValues.h"
#include "app/core/RobotCommands.h"
#include "app/core/Workbench.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/arcos/GripperState.h"
#include "robotlink/arcos/codec/Command.h"

namespace app {
namespace {

using robotlink::Result;
using robotlink::arcos::CommandId;
using robotlink::arcos::GripperAction;

robotcontrol::Request arcosRequest(CommandId id, int argument) {
  const auto bytes = encode(toPacket(robotlink::arcos::command(id, argument)));
  robotcontrol::Request request;
  request.mutable_control_drive()->add_packets(std::string(bytes.begin(), bytes.end()));
  return request;
}

Result<robotcontrol::Request> gripperRequest(const std::string& action) {
  constexpr std::pair<std::string_view, GripperAction> kActions[]{
      {"open", GripperAction::kOpen},          {"close", GripperAction::kClose},
      {"stop", GripperAction::kStop},          {"lift-up", GripperAction::kLiftUp},
      {"lift-down", GripperAction::kLiftDown}, {"lift-stop", GripperAction::kLiftStop},
      {"store", GripperAction::kStore},        {"deploy", GripperAction::kDeploy},
      {"halt", GripperAction::kHalt}};
  const auto* found = std::ranges::find(kActions, action, &std::pair<std::string_view, GripperAction>::first);
  if (found == std::end(kActions))
    return robotlink::failure("robot.gripper", "a gripper cannot do " + action, {}, {action});
  return arcosRequest(CommandId::kGripper, static_cast<int>(found->second));
}

Result<robotcontrol::Request> outputRequest(double number, bool on) {
  if (number < 0 || number > 7 || number != std::floor(number))
    return robotlink::failure("robot.output", "digital outputs are numbered 0 to 7");
  // The high byte says which outputs change, the low one how.
  const unsigned bit = 1U << static_cast<unsigned>(number);
  return arcosRequest(CommandId::kDigOut, static_cast<std::int16_t>(bit << 8U | (on ? bit : 0U)));
}

}  // namespace

void addPioneerCommands(Workbench& workbench) {
  const auto ask = [&workbench](const Result<robotcontrol::Request>& request) {
    return request ? askSelectedRobot(workbench, *request) : tl::unexpected(request.error());
  };
  workbench.commands().attach("robot.gripper",
                              [ask](const Values& values) { return ask(gripperRequest(text(values, 0))); });
  workbench.commands().attach("robot.output", [ask](const Values& values) {
    return ask(outputRequest(number(values, 0), flag(values, 1)));
  });
}

}  // namespace app
