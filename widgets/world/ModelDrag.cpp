// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/ModelDrag.h"

#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

constexpr int kDragRefusalTicks = 60;

}  // namespace

struct ModelDrag::Answer {
  std::uint64_t newest = 0;  ///< id of the newest request
  QString refusal;
};

ModelDrag::ModelDrag() : answer_(std::make_shared<Answer>()) {}

void ModelDrag::begin(const std::string& model, const robotlink::Pose2& pose,
                      const robotlink::Vector2& grabbed) {
  active_ = true;
  unsent_ = false;
  model_ = model;
  wanted_ = pose;
  offset_ = pose.translation() - grabbed;
  answer_ = std::make_shared<Answer>();
}

void ModelDrag::moveTo(const robotlink::Vector2& cursor, double step) {
  robotlink::Vector2 place = cursor + offset_;
  if (step > 0) place = (place / step).array().round() * step;
  if (!active_ || place == wanted_.translation()) return;
  wanted_.x = place.x();
  wanted_.y = place.y();
  unsent_ = true;
}

void ModelDrag::turn(double by) {
  if (!active_) return;
  wanted_.heading = robotlink::normalizedAngle(wanted_.heading + by);
  unsent_ = true;
}

void ModelDrag::tick(robotlink::Session& session) {
  if (unsent_) send(session);
  if (!active_ && ++ticksSinceEnd_ > kDragRefusalTicks) answer_->refusal.clear();
}

void ModelDrag::end(robotlink::Session& session) {
  if (unsent_) send(session);
  active_ = false;
  ticksSinceEnd_ = 0;
}

void ModelDrag::cancel() {
  active_ = unsent_ = false;
  ticksSinceEnd_ = 0;
}

QString ModelDrag::refusal() const {
  return answer_->refusal;
}

void ModelDrag::send(robotlink::Session& session) {
  unsent_ = false;
  robotcontrol::Request request;
  request.mutable_place_model()->set_model(model_);
  robotlink::assign(*request.mutable_place_model()->mutable_pose_in_field(), wanted_);
  // The reply to an older request says nothing about the newest pose.
  const auto answered = [answer = answer_](const robotcontrol::RequestResult& result) {
    if (result.id() < answer->newest) return;
    answer->refusal = result.accepted() ? QString() : QString::fromStdString(result.reason());
  };
  answer_->newest = session.request(std::move(request), answered);
}

}  // namespace widgets
