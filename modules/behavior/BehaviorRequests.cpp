// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/BehaviorRequests.h"

#include <array>

#include "robotlink/packages/Conversions.h"

namespace modules {

using robotcontrol::HeadMode;
using robotcontrol::MotionRequest;

BehaviorRequests::BehaviorRequests(robotlink::SolutionContext& context)
    : debug_(context.debug()),
      clock_(context.clock()),
      motion_(context.output(robotlink::kMotionRequest)),
      head_(context.output(robotlink::kHeadMode)) {}

void BehaviorRequests::send(const Intention& intention) {
  auto motion = std::make_shared<MotionRequest>();
  switch (intention.motion) {
    case Intention::Motion::kStand:
      motion->set_kind(MotionRequest::STAND);
      break;
    case Intention::Motion::kWalk:
      motion->set_kind(MotionRequest::WALK);
      motion->mutable_walk()->set_x(intention.forward);
      motion->mutable_walk()->set_y(intention.left);
      motion->mutable_walk()->set_rotation(intention.turn);
      break;
    case Intention::Motion::kKick:
      motion->set_kind(MotionRequest::KEY_FRAMES);
      motion->set_motion(intention.kick);
      break;
    case Intention::Motion::kGetUp:
      motion->set_kind(MotionRequest::GET_UP);
      break;
  }
  static constexpr std::array kHeads{HeadMode::LOOK_AHEAD, HeadMode::SEARCH_BALL, HeadMode::TRACK_BALL,
                                     HeadMode::LOOK_AROUND};
  auto head = std::make_shared<HeadMode>();
  head->set_kind(kHeads[static_cast<std::size_t>(intention.head)]);
  send(std::move(motion), std::move(head));
}

void BehaviorRequests::send(std::shared_ptr<MotionRequest> motion, std::shared_ptr<HeadMode> head) {
  robotlink::assign(*motion->mutable_timestamp(), clock_.now());
  robotlink::assign(*head->mutable_timestamp(), clock_.now());
  if (debug_.on(kBehaviorSpeedKey)) {
    debug_.plot(kBehaviorSpeedKey, "x", motion->walk().x(), "m/s");
    debug_.plot(kBehaviorSpeedKey, "y", motion->walk().y(), "m/s");
    debug_.plot(kBehaviorSpeedKey, "rotation", motion->walk().rotation(), "rad/s");
  }
  if (debug_.on(kBehaviorWalkKey)) {
    auto drawing = debug_.robotDrawing(kBehaviorWalkKey);
    const robotlink::Vector2 end(motion->walk().x(), motion->walk().y());
    drawing.line(robotlink::Vector2(0, 0), end, robotlink::colors::kOrange, 3);
  }
  motion_.send(std::move(motion));
  head_.send(std::move(head));
}

}  // namespace modules
