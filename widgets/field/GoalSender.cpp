// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/GoalSender.h"

#include <cmath>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

constexpr int kRefusalTicks = 120;  // four seconds at 30 ticks a second
constexpr int kSentTicks = 90;

}  // namespace

GoalSender::GoalSender() : answer_(std::make_shared<Answer>()) {}

void GoalSender::begin(Aim at) {
  start_ = at;
  aim_ = std::move(at);
  answer_->refusal.clear();
}

void GoalSender::moveTo(const robotlink::Vector2& cursor, double turnRadius) {
  if (!aim_) return;
  const robotlink::Vector2 off = cursor - start_->pose.translation();
  aim_ = start_;
  if (off.norm() < turnRadius) return;
  aim_->pose.heading = std::atan2(off.y(), off.x());
  aim_->anyHeading = false;
}

void GoalSender::end(robotlink::Session& session, const std::string& robot) {
  if (!aim_) return;
  send(session, robot, *aim_, false);
  sent_ = aim_;
  sentTicks_ = 0;
  aim_.reset();
}

void GoalSender::cancelGoal(robotlink::Session& session, const std::string& robot) {
  aim_.reset();
  sent_.reset();
  send(session, robot, {}, true);
}

void GoalSender::send(robotlink::Session& session, const std::string& robot, const Aim& aim, bool canceled) {
  robotcontrol::Request request;
  request.set_robot(robot);
  auto& goal = *request.mutable_set_goal();
  robotlink::assign(*goal.mutable_timestamp(), session.timeline().newest());
  goal.set_cancelled(canceled);
  if (!canceled) {
    robotlink::assign(*goal.mutable_pose_in_field(), aim.pose);
    goal.set_any_heading(aim.anyHeading);
    goal.set_name(aim.name);
  }
  const std::weak_ptr<Answer> answer = answer_;
  session.request(std::move(request), [answer](const robotcontrol::RequestResult& result) {
    const auto reported = answer.lock();
    if (!reported || result.accepted()) return;
    reported->refusal = QString::fromStdString(result.reason());
    reported->ticks = 0;
  });
}

void GoalSender::tick() {
  if (!answer_->refusal.isEmpty()) {
    sent_.reset();
    if (++answer_->ticks > kRefusalTicks) answer_->refusal.clear();
  }
  if (sent_ && ++sentTicks_ > kSentTicks) sent_.reset();
}

QString GoalSender::refusal() const {
  return answer_->refusal;
}

}  // namespace widgets
