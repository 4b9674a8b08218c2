// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/ForceMarkers.h"

#include <algorithm>

#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/Requests.h"
#include "widgets/scene/MarkerShapes.h"

namespace widgets {
namespace {

using robotlink::Vector3;

constexpr double kForceRadius = 0.0025;  // m, of the shafts of arrows
constexpr double kReadingSeconds = 10;   // much longer than until the next request
constexpr MarkerColor kContactColor{250, 90, 30, 255}, kReactionColor{70, 120, 240, 255},
    kHandColor{60, 190, 80, 255};

template <typename Message>
Vector3 vectorFrom(const Message& message) {
  return {message.x(), message.y(), message.z()};
}

/// An arrow for a force that acts at a point.
void addForce(SceneShape& shape, const Vector3& at, const Vector3& force, MarkerColor color) {
  const double length = std::min(ForceMarkers::kMetersPerNewton * force.norm(), ForceMarkers::kMaxArrow);
  if (!force.allFinite() || !(length > 0)) return;
  addMarkerArrow(shape, at, at + length * force.normalized(), kForceRadius, color);
}

}  // namespace

SceneShape forcesShape(const robotcontrol::WorldForces& forces, const ObjectFilter& isShown) {
  SceneShape shape;
  int count = 0;
  for (const auto& contact : forces.contacts()) {
    if (!isShown(contact.first()) && !isShown(contact.second())) continue;
    if (++count > ForceMarkers::kMaxForces) break;
    const Vector3 point = vectorFrom(contact.point());
    addMarkerPoint(shape, point, kContactColor, 5);
    addForce(shape, point, vectorFrom(contact.force()), kContactColor);
  }
  for (const auto& joint : forces.joints()) {
    if (!isShown(joint.joint())) continue;
    if (++count > ForceMarkers::kMaxForces) break;
    addForce(shape, vectorFrom(joint.anchor()), vectorFrom(joint.force()), kReactionColor);
  }
  for (const auto& hand : forces.hands()) {
    if (!isShown(hand.path())) continue;
    const Vector3 point = vectorFrom(hand.point());
    addForce(shape, point, vectorFrom(hand.force()), kHandColor);
    if (hand.kind() == robotcontrol::HandForce::DRAG && hand.has_target())
      addMarkerLine(shape, point, vectorFrom(hand.target()), kHandColor);
  }
  return shape;
}

void ForceMarkers::keepReading(robotlink::Session& session) {
  if (--untilAsked_ > 0 || session.store().find(robotlink::streams::kForces) == nullptr) return;
  untilAsked_ = kAskEvery;
  robotcontrol::Request request;
  request.mutable_read_forces()->set_seconds(kReadingSeconds);
  // Failures are ignored: without a simulation there are no forces to read.
  ask(session, {}, std::move(request), nullptr, [](bool, const QString&) {});
}

std::vector<SceneBody> ForceMarkers::bodies(robotlink::Session& session, robotlink::Instant shown,
                                            int revision, const ObjectFilter& isShown) {
  keepReading(session);
  const auto* message = session.store().latest(robotlink::streams::kForces, shown);
  const auto* forces =
      message == nullptr ? nullptr : dynamic_cast<const robotcontrol::WorldForces*>(message->value.get());
  if (forces == nullptr) return {};
  if (message->value != message_ || revision != revision_) {
    message_ = message->value;
    revision_ = revision;
    shape_ = std::make_shared<const SceneShape>(forcesShape(*forces, isShown));
  }
  return {{shape_, robotlink::Pose3::Identity(), {}}};
}

}  // namespace widgets
