// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/requests/WorldRequests.h"

#include <cmath>

#include "robotcontrol/Requests.pb.h"

namespace robotlink {

using robotcontrol::Request;

namespace {

constexpr double kMaxHandSpeed = 100;  // m/s
constexpr double kMaxHandSpin = 1000;  // rad/s
constexpr double kMaxHandForce = 1e6;  // N
constexpr double kMaxHandPlace = 1e4;  // m
constexpr double kMaxHandStrength = 100;
constexpr double kMaxHandSeconds = 60;
constexpr double kMaxRewindSeconds = 1e6;
constexpr std::size_t kMaxSnapshotName = 100;

/// Whether all components are numbers, and none is larger than `limit`. Written so that a NaN is not.
template <typename Vector>
bool isWithin(const Vector& vector, double limit) {
  return std::abs(vector.x()) <= limit && std::abs(vector.y()) <= limit && std::abs(vector.z()) <= limit;
}

bool isWithin(double value, double low, double high) {
  return value >= low && value <= high;
}

std::string unless(bool right, const char* wrong) {
  return right ? std::string() : std::string(wrong);
}

}  // namespace

std::string wrongTurn(const Request& request) {
  const auto& turn = request.turn_model();
  if (turn.model().empty()) return "the request must name the model to turn";
  return unless(std::isfinite(turn.heading()) && std::isfinite(turn.roll()) && std::isfinite(turn.pitch()),
                "the angles by which the model is turned are not all numbers");
}

std::string wrongThrow(const Request& request) {
  const auto& thrown = request.throw_model();
  if (thrown.model().empty()) return "the request must name the model to throw";
  if (!isWithin(thrown.velocity(), kMaxHandSpeed)) return "a model can be thrown with at most 100 m/s";
  return unless(isWithin(thrown.spin(), kMaxHandSpin), "a model can be spun with at most 1000 rad/s");
}

std::string wrongPin(const Request& request) {
  return unless(!request.pin_object().path().empty(), "the request must name the object to pin");
}

std::string wrongDrag(const Request& request) {
  const auto& drag = request.drag_object();
  if (drag.released()) return "";
  if (drag.path().empty()) return "the request must name the object to drag";
  if (!isWithin(drag.grip(), kMaxHandPlace) || !isWithin(drag.target(), kMaxHandPlace))
    return "the points between which the object is dragged are too far away";
  return unless(drag.strength() == 0 || isWithin(drag.strength(), 1 / kMaxHandStrength, kMaxHandStrength),
                "the strength of dragging must be between 0.01 and 100 times the usual one");
}

std::string wrongPush(const Request& request) {
  const auto& push = request.push_object();
  if (push.path().empty()) return "the request must name the object to push";
  if (!isWithin(push.force(), kMaxHandForce)) return "an object can be pushed with at most 1000000 N";
  if (!isWithin(push.point(), kMaxHandPlace))
    return "the point at which the object is pushed is too far away";
  return unless(isWithin(push.seconds(), 0, kMaxHandSeconds), "an object can be pushed for at most 60 s");
}

std::string wrongForceReading(const Request& request) {
  return unless(isWithin(request.read_forces().seconds(), 0, kMaxHandSeconds),
                "forces can be read for at most 60 s; then request them again");
}

std::string wrongSnapshots(const Request& request) {
  using robotcontrol::ControlSnapshots;
  const ControlSnapshots& control = request.control_snapshots();
  if (!ControlSnapshots::Action_IsValid(control.action())) return "there is no such action on a snapshot";
  if (control.name().size() > kMaxSnapshotName) return "the name of a snapshot is too long";
  if (control.action() == ControlSnapshots::REWIND)
    return unless(control.seconds() > 0 && control.seconds() <= kMaxRewindSeconds,
                  "the time to go back must be above 0 s");
  const bool needsName =
      control.action() == ControlSnapshots::TAKE || control.action() == ControlSnapshots::RESTORE;
  if (needsName && control.name().empty() == control.file().empty())
    return "a snapshot has either a name or a file";
  return "";
}

std::string fileOfSnapshot(const Request& request) {
  return request.control_snapshots().file();
}

}  // namespace robotlink
