// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/ReplayMoves.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "robotcontrol/Logging.pb.h"

namespace app {

using robotcontrol::ControlReplay;

namespace {

bool isJump(const ControlReplay& move) {
  return move.action() == ControlReplay::JUMP_TO_TIME || move.action() == ControlReplay::JUMP_TO_FRAME;
}

bool isStep(const ControlReplay& move) {
  return move.action() == ControlReplay::STEP_FRAME || move.action() == ControlReplay::STEP_MESSAGE;
}

}  // namespace

bool onlyMoves(const ControlReplay& control) {
  if (!isJump(control) && !isStep(control)) return false;
  ControlReplay rest = control;
  rest.clear_action();
  rest.clear_count();
  rest.clear_time();
  rest.clear_frame();
  rest.clear_process();
  rest.clear_stream();
  return rest.ByteSizeLong() == 0;
}

bool joinMoves(ControlReplay& first, const ControlReplay& second) {
  if (isJump(second)) {
    first = second;
    return true;
  }
  if (first.action() != second.action() || first.process() != second.process() ||
      first.stream() != second.stream()) {
    return false;
  }
  // At the ends of the log a step forward and one back need not lead back to the same instant.
  if ((first.count() < 0) != (second.count() < 0)) return false;
  constexpr std::int64_t kMax = std::numeric_limits<std::int32_t>::max();
  const std::int64_t sum = std::int64_t{first.count()} + second.count();
  first.set_count(static_cast<std::int32_t>(std::clamp(sum, -kMax, kMax)));
  return true;
}

}  // namespace app
