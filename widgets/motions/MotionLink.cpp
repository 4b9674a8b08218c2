// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionLink.h"

#include <algorithm>
#include <utility>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/session/Session.h"
#include "widgets/Requests.h"
#include "widgets/motion/ManualSteering.h"
#include "widgets/motions/MotionBench.h"
#include "widgets/motions/MotionFiles.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

namespace {

/// 30 times a second.
constexpr int kPatienceTicks = 150, kAutoSendTicks = 10;

}  // namespace

MotionLink::MotionLink(MotionBench& bench)
    : QObject(&bench), bench_(bench), manual_(manualSteering(bench.context())) {
  setObjectName(QStringLiteral("motionLink"));
  connect(&bench, &MotionBench::changed, this, [this] {
    ticksUnchanged_ = 0;
    refusal_.clear();
    Q_EMIT changed();
  });
  connect(&bench, &MotionBench::robotChanged, this, &MotionLink::changed);
}

Result<void> MotionLink::requireRobot() const {
  bench_.tick();
  if (bench_.isEmpty())
    return failure("motion.none", "there is no motion; open one, or start one: motion.new NAME");
  if (bench_.robot().empty()) return failure("motion.no-robot", "there is no robot; open a scene first");
  const auto& description = bench_.description();
  if (description != nullptr && description->joints.empty())
    return failure("motion.no-joints", bench_.robot() + " has no joints, so it plays no motions", {},
                   {bench_.robot()});
  return {};
}

void MotionLink::ask(const std::string& text, std::function<void()> accepted) {
  robot_ = bench_.robot();
  sent_ = text;
  refusal_.clear();
  isPending_ = true;
  ticksPending_ = 0;
  robotcontrol::Request request;
  auto& motion = *request.mutable_set_motion()->mutable_motion();
  motion.set_name(bench_.motion().name);
  motion.set_text(text);
  widgets::ask(
      bench_.context().session, robot_, std::move(request), this,
      [this, number = ++asked_, accepted = std::move(accepted)](bool isAccepted, const QString& reason) {
        if (number != asked_) return;
        isPending_ = false;
        if (!isAccepted) refusal_ = reason;
        Q_EMIT changed();
        if (isAccepted && accepted) accepted();
      });
  Q_EMIT changed();
}

Result<void> MotionLink::send() {
  return requireRobot().and_then([&]() -> Result<void> {
    if (!bench_.document().errors().empty()) return tl::unexpected(bench_.document().errors().front());
    ask(bench_.document().text(), {});
    return {};
  });
}

Result<void> MotionLink::takeBack() {
  return requireRobot().map([&] { ask({}, {}); });
}

void MotionLink::setAutoSend(bool on) {
  if (on == autoSend_) return;
  autoSend_ = on;
  Q_EMIT changed();
}

Result<void> MotionLink::play() {
  if (const auto has = requireRobot(); !has) return has;
  if (const auto has = manual_.play(bench_.motion().name); !has) return has;
  if (state() == State::kSame) return {};
  if (!bench_.document().errors().empty()) {
    static_cast<void>(manual_.stand());
    return tl::unexpected(bench_.document().errors().front());
  }
  // The robot stands still until it has received the motion, and then plays it.
  static_cast<void>(manual_.stand());
  ask(bench_.document().text(), [this] { static_cast<void>(manual_.play(bench_.motion().name)); });
  return {};
}

Result<void> MotionLink::step(int count) {
  const int frames = static_cast<int>(bench_.frames().size());
  if (frames == 0) return failure("motion.no-frame", "the motion has no key frames");
  bench_.setFrame(std::clamp(std::max(bench_.frame(), 0) + count, 0, frames - 1));
  if (manual_.isTaken()) pose();
  return {};
}

/// Angles beyond the limits of a joint go as far as it can; joints that stay or are released are not turned.
void MotionLink::pose() {
  const auto* robot = manual_.description().get();
  const int selected = bench_.frame();
  if (robot == nullptr || selected < 0) return;
  const auto& frame =
      robotlink::keyFrameAt(bench_.motion(), bench_.frames()[static_cast<std::size_t>(selected)]);
  const auto columns = bench_.columns();
  for (std::size_t i = 0; i < std::min(columns.size(), frame.joints.size()); ++i) {
    const int index = robot->jointIndex(columns[i]);
    if (index < 0 || frame.joints[i].kind != robotlink::JointValue::Kind::kAngle) continue;
    const auto& joint = robot->joints[static_cast<std::size_t>(index)];
    static_cast<void>(
        manual_.setJoint(joint.name, std::clamp(frame.joints[i].angle, joint.minimum, joint.maximum)));
  }
}

MotionLink::State MotionLink::state() const {
  if (bench_.isEmpty() || bench_.robot().empty()) return State::kNone;
  if (isPending_ && robot_ == bench_.robot()) return State::kSending;
  if (!refusal_.isEmpty() && robot_ == bench_.robot()) return State::kRefused;
  if (bench_.table() == nullptr) return State::kNone;
  const auto has = bench_.robotText();
  return has && has->text == bench_.document().text() ? State::kSame : State::kOther;
}

QString MotionLink::text() const {
  const QString robot = QString::fromStdString(bench_.robot());
  const auto& description = bench_.description();
  switch (state()) {
    case State::kSending:
      return tr("Sending to %1…").arg(robot);
    case State::kRefused:
      return tr("%1 refuses it: %2").arg(robot, refusal_);
    case State::kSame:
      return bench_.robotText()->isSent ? tr("%1 has this motion, as it was sent").arg(robot)
                                        : tr("%1 has this motion").arg(robot);
    case State::kOther:
      return bench_.robotText() ? tr("%1 has a different version of this motion").arg(robot)
                                : tr("%1 does not have this motion yet").arg(robot);
    case State::kNone:
      break;
  }
  if (bench_.isEmpty()) return {};
  if (robot.isEmpty()) return tr("No robot to send it to");
  if (description != nullptr && description->joints.empty())
    return tr("%1 has no joints, so it plays no motions").arg(robot);
  return tr("The program of %1 plays no motions").arg(robot);
}

void MotionLink::tick() {
  if (isPending_ && ++ticksPending_ > kPatienceTicks) {
    isPending_ = false;
    ++asked_;  // later replies are ignored
    refusal_ = tr("there is no answer; is its program running?");
    Q_EMIT changed();
  }
  ++ticksUnchanged_;
  const bool isDue = autoSend_ && ticksUnchanged_ == kAutoSendTicks && bench_.errors().empty();
  if (isDue && !isPending_ && state() == State::kOther) static_cast<void>(send());
  followPlaying();
}

void MotionLink::followPlaying() {
  const auto* status = manual_.status();
  const bool isPlayed = status != nullptr && !bench_.isEmpty() &&
                        status->executed().kind() == robotcontrol::MotionRequest::KEY_FRAMES &&
                        status->executed().motion() == bench_.motion().name;
  if (!isPlayed)
    playedSince_.reset();
  else if (!playedSince_)
    playedSince_ = bench_.context().session.timeline().newest();
}

void tickMotions(ViewContext& context) {
  motionFiles(context).tick();
  motionLink(context).tick();
}

MotionLink& motionLink(ViewContext& context) {
  MotionBench& bench = motionBench(context);
  auto* link = bench.findChild<MotionLink*>(QString(), Qt::FindDirectChildrenOnly);
  return link != nullptr ? *link : *new MotionLink(bench);
}

}  // namespace widgets
