// SPDX-License-Identifier: GPL-3.0-or-later
// readVehicle() of SdfDevices.h: wheels that roll by forces, and joints that steer them.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

struct VehicleKind {
  const char* name;
  GuidedMotion::Kind kind;
};
constexpr VehicleKind kVehicleKinds[] = {{"differential", GuidedMotion::Kind::kDifferential},
                                         {"skid", GuidedMotion::Kind::kSkid},
                                         {"omni", GuidedMotion::Kind::kOmni},
                                         {"ackermann", GuidedMotion::Kind::kAckermann}};
/// Rollers that push across the rolling direction could not drive, rad.
constexpr double kMaxRollers = 1.4;
/// A wheel's axis, or that of a steering joint, may lean by this much of a unit vector.
constexpr double kLean = 0.2;
/// Smaller singular values mean that some motion is impossible.
constexpr double kSmallestMotion = 0.01;

/// Reads <robotcontrol:vehicle> of one model.
class VehicleReader {
 public:
  VehicleReader(const sdf::Model& source, ModelDescription& model, const SdfContext& context)
      : source_(source),
        model_(model),
        context_(context),
        element_(source.Element()->GetElement("robotcontrol:vehicle")) {}

  void read() {
    if (model_.isStatic || model_.drive || model_.guided)
      return fail("a model that has a <robotcontrol:vehicle> is not static, has no drive, and is not guided");
    if (!readKind()) return;
    if (element_->HasAttribute("name")) motion_.name = element_->Get<std::string>("name");
    idleTorque_ = ownNumber(element_, "idle_torque", 0, 0, 1000, context_);
    motion_.acceleration = ownNumber(element_, "acceleration", motion_.acceleration, 1e-3, 1000, context_);
    motion_.angularAcceleration =
        ownNumber(element_, "angular_acceleration", motion_.angularAcceleration, 1e-3, 1e4, context_);
    readSteering();
    for (sdf::ElementPtr child = element_->GetFirstElement(); child; child = child->GetNextElement()) {
      if (child->GetName() == "robotcontrol:wheel") addWheel(child, true);
      if (child->GetName() == "robotcontrol:free_wheel") addWheel(child, false);
    }
    if (!checkWheels() || !measure()) return;
    model_.vehicle = vehicle_;
    model_.guided = motion_;
  }

 private:
  using Kind = GuidedMotion::Kind;

  void fail(std::string text) const { failAt(element_, std::move(text)); }
  void failAt(const sdf::ElementPtr& element, std::string text) const {
    context_.fail(element, "scene.vehicle", std::move(text));
  }

  bool readKind() {
    motion_.name = "drive";
    const std::string kind = element_->HasAttribute("kind") ? element_->Get<std::string>("kind") : "";
    const auto* found =
        std::ranges::find_if(kVehicleKinds, [&](const VehicleKind& each) { return kind == each.name; });
    if (found == std::end(kVehicleKinds)) {
      fail("the kind of <robotcontrol:vehicle> is differential, skid, omni or ackermann, not '" + kind + "'");
      return false;
    }
    motion_.kind = found->kind;
    const std::string control =
        element_->HasAttribute("control") ? element_->Get<std::string>("control") : "speed";
    vehicle_.byTorque = control == "torque";
    if (control == "speed" || (control == "torque" && motion_.kind != Kind::kOmni)) return true;
    fail("the control of <robotcontrol:vehicle> is speed or torque (of omni vehicles only speed), not '" +
         control + "'");
    return false;
  }

  JointDescription* jointOf(const sdf::ElementPtr& element) const {
    const auto name = element->Get<std::string>();
    const auto found = std::ranges::find(model_.joints, name, &JointDescription::name);
    if (found != model_.joints.end()) return &*found;
    failAt(element, "the model has no joint '" + name + "'");
    return nullptr;
  }

  void readSteering() {
    for (sdf::ElementPtr child = element_->GetFirstElement(); child; child = child->GetNextElement()) {
      if (child->GetName() != "robotcontrol:steer") continue;
      const JointDescription* joint = jointOf(child);
      if (joint == nullptr) continue;
      const double upward = joint->axisInModel.z();
      if (joint->kind != JointDescription::Kind::kHinge || !joint->servo ||
          joint->control.kind != MotorControl::Kind::kPosition || std::abs(upward) < 1 - kLean) {
        failAt(child,
               "a joint that steers turns about a vertical axis, by a <robotcontrol:servo> that is "
               "controlled by position");
        continue;
      }
      vehicle_.steering.push_back(static_cast<int>(joint - model_.joints.data()));
      vehicle_.steeringSigns.push_back(upward > 0 ? 1 : -1);
    }
  }

  void addWheel(const sdf::ElementPtr& element, bool driven) {
    JointDescription* joint = jointOf(element);
    if (joint == nullptr) return;
    if (const char* reason = unfitAsWheel(model_, *joint); reason != nullptr)
      return failAt(element, "'" + joint->name + "' cannot be a wheel's joint: " + reason);
    joint->wheel = true;
    const CollisionDescription& tread =
        model_.links[static_cast<std::size_t>(joint->child)].collisions.front();
    VehicleWheel wheel;
    wheel.joint = static_cast<int>(joint - model_.joints.data());
    wheel.driven = driven;
    wheel.radius = tread.shape.radius;
    wheel.center =
        (model_.links[static_cast<std::size_t>(joint->child)].poseInModel * tread.poseInLink).translation();
    wheel.forward = joint->axisInModel.cross(Vector3::UnitZ());
    if (std::abs(joint->axisInModel.z()) > kLean) failAt(element, "a wheel's axis must be level");
    if (wheel.forward.x() < -1e-6 || (std::abs(wheel.forward.x()) <= 1e-6 && wheel.forward.y() < 0))
      wheel.forward = -wheel.forward;
    wheel.forward.normalize();
    readRollers(element, wheel);
    readLimits(element, *joint, wheel);
    const auto steers = std::ranges::find_if(vehicle_.steering, [&](int each) {
      return model_.joints[static_cast<std::size_t>(each)].child == joint->parent;
    });
    if (steers != vehicle_.steering.end())
      wheel.steering = static_cast<int>(steers - vehicle_.steering.begin());
    vehicle_.wheels.push_back(wheel);
  }

  void readRollers(const sdf::ElementPtr& element, VehicleWheel& wheel) const {
    if (!element->HasAttribute("rollers")) return;
    const std::string text = element->Get<std::string>("rollers");
    char* end = nullptr;
    const double angle = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !(std::abs(angle) <= kMaxRollers)) {
      return failAt(element,
                    "rollers is the angle in which they push, rad, from -1.4 to 1.4, not '" + text + "'");
    }
    wheel.rollers = angle;
  }

  /// Free wheels have no motor.
  void readLimits(const sdf::ElementPtr& element, const JointDescription& joint, VehicleWheel& wheel) const {
    wheel.idleForce = idleTorque_ / wheel.radius;
    if (!wheel.driven) return;
    const sdf::Joint* source = source_.JointByName(joint.name);
    if (source == nullptr || source->Axis(0) == nullptr) return failAt(element, "the joint has no axis");
    const sdf::JointAxis& axis = *source->Axis(0);
    wheel.maximumSpeed = wheel.radius * context_.within(axis.MaxVelocity(), 1e-6, 1000,
                                                        "a driven wheel's <velocity>", source->Element());
    wheel.maximumForce =
        context_.within(axis.Effort(), 1e-9, 1000, "a driven wheel's <effort>", source->Element()) /
        wheel.radius;
  }

  bool checkWheels() const {
    const bool driven = std::ranges::any_of(vehicle_.wheels, &VehicleWheel::driven);
    const bool steered =
        std::ranges::any_of(vehicle_.wheels, [](const VehicleWheel& wheel) { return wheel.steering >= 0; });
    if (!driven) fail("a vehicle needs driven wheels: <robotcontrol:wheel>");
    if (driven && steered != (motion_.kind == Kind::kAckermann)) {
      fail(steered ? "only a vehicle of the kind ackermann has wheels that are steered"
                   : "a vehicle of the kind ackermann needs <robotcontrol:steer>: the joints between it and "
                     "what carries its front wheels");
    }
    return driven && steered == (motion_.kind == Kind::kAckermann);
  }

  /// Computes the limits of the motion, which follow from the places of the wheels.
  bool measure() {
    motion_.maximumSpeed = 1e9;
    double farthest = 0.01;
    for (const VehicleWheel& wheel : vehicle_.wheels) {
      farthest = std::max(farthest, wheel.center.head<2>().norm());
      if (wheel.driven) motion_.maximumSpeed = std::min(motion_.maximumSpeed, wheel.maximumSpeed);
    }
    motion_.maximumRate = motion_.maximumSpeed / farthest;
    if (motion_.kind == Kind::kOmni) return measureOmni();
    return motion_.kind == Kind::kAckermann ? measureAxles() : measureSides();
  }

  bool measureOmni() const {
    // The Gram matrix of the wheels' motions: its eigenvalues are the squares of their singular values.
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const VehicleWheel& wheel : vehicle_.wheels) {
      if (!wheel.driven) continue;
      const robotlink::Vector2 push = pushOf(wheel);
      const Vector3 motion(push.x(), push.y(), wheel.center.x() * push.y() - wheel.center.y() * push.x());
      squares += motion * motion.transpose();
    }
    const double least =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares, Eigen::EigenvaluesOnly).eigenvalues()[0];
    const bool hasRollers = std::ranges::all_of(
        vehicle_.wheels, [](const VehicleWheel& wheel) { return !wheel.driven || wheel.rollers; });
    if (hasRollers && least > kSmallestMotion * kSmallestMotion) return true;
    fail(
        "an omni vehicle needs at least three driven wheels with rollers, which together can push it in all "
        "directions and turn it");
    return false;
  }

  static robotlink::Vector2 pushOf(const VehicleWheel& wheel) {
    return Eigen::Rotation2Dd(wheel.rollers.value_or(0)) * robotlink::Vector2(wheel.forward.head<2>());
  }

  bool measureAxles() {
    double steered = 0, fixed = 0, widest = 0, limit = 1.5;
    int steeredCount = 0, fixedCount = 0;
    for (const VehicleWheel& wheel : vehicle_.wheels) {
      (wheel.steering >= 0 ? steered : fixed) += wheel.center.x();
      ++(wheel.steering >= 0 ? steeredCount : fixedCount);
      if (wheel.steering < 0) continue;
      widest = std::max(widest, std::abs(wheel.center.y()));
      const JointDescription& joint =
          model_
              .joints[static_cast<std::size_t>(vehicle_.steering[static_cast<std::size_t>(wheel.steering)])];
      limit = std::min({limit, joint.upper, -joint.lower});
    }
    const double rear = fixedCount > 0 ? fixed / fixedCount : 0;
    const double length = steered / steeredCount - rear;
    if (fixedCount == 0 || std::abs(length) < 0.01 || std::abs(rear) > 0.01) {
      fail(
          "a vehicle of the kind ackermann needs wheels that are not steered, on one axle below the model's "
          "origin, and those that are steered at another place");
      return false;
    }
    if (!(limit > 0.01)) {
      fail("the joints that steer must turn to both sides from 0");
      return false;
    }
    motion_.wheelbase = length;
    // The inner wheel turns most.
    motion_.maximumSteering = std::atan(std::abs(length) / (std::abs(length) / std::tan(limit) + widest));
    return true;
  }

  bool measureSides() {
    double left = 0, right = 0;
    int leftCount = 0, rightCount = 0;
    for (const VehicleWheel& wheel : vehicle_.wheels) {
      if (!wheel.driven) continue;
      (wheel.center.y() > 0 ? left : right) += wheel.center.y();
      ++(wheel.center.y() > 0 ? leftCount : rightCount);
    }
    if (leftCount == 0 || rightCount == 0) {
      fail("a vehicle of this kind needs driven wheels on both sides of the model's x-axis");
      return false;
    }
    const double track = left / leftCount - right / rightCount;
    motion_.track = ownNumber(element_, "track", track, 0.01, 100, context_);
    return true;
  }

  const sdf::Model& source_;
  ModelDescription& model_;
  const SdfContext& context_;
  const sdf::ElementPtr element_;
  VehicleDescription vehicle_;
  GuidedMotion motion_;
  double idleTorque_ = 0;
};

}  // namespace

void readVehicle(const sdf::Model& source, ModelDescription& model, const SdfContext& context) {
  if (source.Element()->HasElement("robotcontrol:vehicle")) VehicleReader(source, model, context).read();
}

}  // namespace simcore
