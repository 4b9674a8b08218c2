// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions as people type them, and paths to values of messages.

#include "foxglove/Robot.pb.h"
#include "robotlink/expressions/BoundExpression.h"
#include "tests/fuzz/FuzzTarget.h"

namespace expression_fuzz {

using robotlink::BoundExpression;
using robotlink::Expression;

namespace {

foxglove::JointStates joints() {
  foxglove::JointStates states;
  states.add_joints()->set_name("neck");
  states.mutable_joints(0)->set_position(1);
  return states;
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  auto bound = BoundExpression::bind(text, {"red1/log", "red1/joints/states", "/a.b"}, {"red1"});
  if (!bound) {
    require(!bound.error().text.empty(), "a refusal says why");
    require(bound.error().where.column <= static_cast<int>(size) + 1, "its place is in the text");
    return 0;
  }
  foxglove::Log log;
  log.set_message("lost");
  for (BoundExpression& one : *bound) {
    // Fields that do not exist are errors, nothing else.
    if (!one.take("red1/log", log) || !one.take("red1/joints/states", joints())) continue;
    one.value();
    one.forget("red1/log");
    one.value();
  }
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {"joints/states.joints[name=\"neck\"].position > 0.5 && log.level != 3",
          "log.message =~ \"(?i)lo+st\\\"?\" || red1/log.name == \"a\"",
          "max(1, joints/states.joints[-1].position, 2e3) ? pi : -joints/states.joints ^ 2", "!(/a.b.x < 1)",
          "sqrt(joints/states.timestamp / 2)"};
}

const FuzzRegistration kTarget({"expression", &fuzzSeeds, &runInput});

}  // namespace expression_fuzz
