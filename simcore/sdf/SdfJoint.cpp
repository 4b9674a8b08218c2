// SPDX-License-Identifier: GPL-3.0-or-later
// readJoints() and orderJoints() of SdfConversion.h.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

constexpr double kFullTurn = JointDescription::kFullTurn;
/// Limits from this value on count as none.
constexpr double kEndless = 1e15;
using JointKind = JointDescription::Kind;

int linkIndex(const ModelDescription& model, const std::string& name) {
  const auto found = std::ranges::find(model.links, name, &LinkDescription::name);
  return found == model.links.end() ? -1 : static_cast<int>(found - model.links.begin());
}

/// Reads the joints of one model, which may be part of another one.
class JointReader {
 public:
  JointReader(const Pose3& sourceInModel, const std::string& prefix, ModelDescription& model,
              const SdfContext& context)
      : sourceInModel_(sourceInModel), prefix_(prefix), model_(model), context_(context) {}

  void read(const sdf::Joint& joint) {
    JointDescription result;
    result.name = prefix_ + joint.Name();
    if (!readKind(joint, result) || !readEnds(joint, result)) return;
    result.anchorInModel =
        sourceInModel_ *
        resolvedPose(joint.SemanticPose(), "__model__", joint.Element(), context_).translation();
    checkDevices(joint.Element(), result.kind);
    if (result.kind != JointKind::kFixed && result.kind != JointKind::kBall) readAxes(joint, result);
    if (result.kind == JointKind::kBall && joint.Element()->HasElement("axis"))
      context_.omit(joint.Element(), "<axis> of a ball joint", "it turns freely in all directions");
    if (turned_) {
      // The child is the world: seen from there everything turns the other way.
      result.axisInModel = -result.axisInModel;
      turned_ = false;
    }
    model_.joints.push_back(std::move(result));
  }

 private:
  /// Only joints with a position have motors and sensors.
  void checkDevices(const sdf::ElementPtr& joint, JointKind kind) {
    if (kind == JointKind::kHinge || kind == JointKind::kSlider) return;
    for (const char* device : {"servo", "speed_sensor", "load_sensor", "position_sensor"}) {
      const std::string key = std::string("robotcontrol:") + device;
      if (!joint->HasElement(key)) continue;
      context_.fail(joint->GetElement(key), "scene.servo",
                    "only a revolute, continuous or prismatic joint can have a <" + key + ">");
    }
  }

  bool readKind(const sdf::Joint& joint, JointDescription& result) {
    const sdf::ElementPtr element = joint.Element();
    switch (joint.Type()) {
      case sdf::JointType::FIXED:
        result.kind = JointKind::kFixed;
        return true;
      case sdf::JointType::BALL:
        result.kind = JointKind::kBall;
        return true;
      case sdf::JointType::PRISMATIC:
        result.kind = JointKind::kSlider;
        break;
      case sdf::JointType::UNIVERSAL:
        result.kind = joint.Axis(1) != nullptr ? JointKind::kUniversal : JointKind::kHinge;
        break;
      case sdf::JointType::REVOLUTE:
      case sdf::JointType::CONTINUOUS:
        break;
      default:
        context_.omit(
            element, "joint of type '" + element->Get<std::string>("type") + "'",
            "only revolute, continuous, prismatic, ball, universal and fixed joints are supported: its "
            "links are not joined");
        return false;
    }
    if (joint.Axis(0) != nullptr) return true;
    context_.fail(element, "scene.axis", "a joint of this type needs an <axis>");
    return false;
  }

  bool readEnds(const sdf::Joint& joint, JointDescription& result) {
    std::string parent, child;
    const bool sound = context_.take(joint.ResolveParentLink(parent), joint.Element()) &&
                       context_.take(joint.ResolveChildLink(child), joint.Element());
    if (!sound) return false;
    if (child == "world" && parent != "world") {
      std::swap(parent, child);
      turned_ = true;
    }
    result.parent = parent == "world" ? -1 : linkIndex(model_, prefix_ + parent);
    result.child = linkIndex(model_, prefix_ + child);
    if (result.child >= 0 && (result.parent >= 0 || parent == "world") && result.child != result.parent)
      return true;
    context_.fail(joint.Element(), "scene.joint", "the joint '" + joint.Name() + "' does not join two links");
    return false;
  }

  Vector3 direction(const sdf::Joint& joint, unsigned index) {
    ignition::math::Vector3d axis;
    context_.take(joint.Axis(index)->ResolveXyz(axis, "__model__"), joint.Element());
    const Vector3 result = sourceInModel_.linear() * toEigen(axis).normalized();
    if (result.allFinite() && result.norm() > 0.5) return result;
    context_.fail(joint.Element(), "scene.axis", "an axis must be a finite vector that is not 0 0 0");
    return Vector3::UnitZ();
  }

  void readAxes(const sdf::Joint& joint, JointDescription& result) {
    const sdf::JointAxis& axis = *joint.Axis(0);
    result.axisInModel = direction(joint, 0);
    readLimits(joint, axis, result);
    if (result.kind == JointKind::kUniversal) {
      result.secondAxisInModel = direction(joint, 1);
      readTurns(joint, *joint.Axis(1), result.secondLower, result.secondUpper);
      if (std::abs(result.axisInModel.dot(result.secondAxisInModel)) > 0.99) {
        context_.fail(joint.Element(), "scene.axis", "the two axes of a universal joint must differ");
      }
    }
    const bool servo = joint.Element()->HasElement("robotcontrol:servo");
    const bool isOutside =
        result.lower > 0 || result.upper < 0 || result.secondLower > 0 || result.secondUpper < 0;
    if (!servo && isOutside) {
      context_.omit(joint.Element(), "the start of the joint",
                    "it starts at 0, outside its stops, which push it back");
    }
    if (servo && result.kind != JointKind::kUniversal) {
      readServo(axis, joint.Element(), result);
    } else {
      result.damping = context_.within(axis.Damping(), 0, 1e6, "damping", joint.Element());
      result.friction = context_.within(axis.Friction(), 0, 1e6, "friction", joint.Element());
    }
    readMotor(joint.Element(), result, context_);
    if (result.servo && result.control.kind == MotorControl::Kind::kPosition &&
        !(std::isfinite(result.lower) && std::isfinite(result.upper))) {
      context_.fail(joint.Element(), "scene.servo",
                    "a prismatic joint with a position servo needs <lower> and <upper>");
    }
  }

  void readLimits(const sdf::Joint& joint, const sdf::JointAxis& axis, JointDescription& result) {
    if (result.kind == JointKind::kSlider) {
      const double none = std::numeric_limits<double>::infinity();
      result.lower = axis.Lower() <= -kEndless ? -none : axis.Lower();
      result.upper = axis.Upper() >= kEndless ? none : axis.Upper();
      if (!(result.lower <= result.upper)) {
        context_.fail(joint.Element(), "scene.range", "lower must not be above upper");
        result.upper = result.lower;
      }
    } else if (joint.Type() == sdf::JointType::CONTINUOUS) {
      result.lower = -kFullTurn;
      result.upper = kFullTurn;
    } else {
      readTurns(joint, axis, result.lower, result.upper);
    }
  }

  /// The solver knows angles within half a turn: a stop beyond is never reached.
  void readTurns(const sdf::Joint& joint, const sdf::JointAxis& axis, double& lower, double& upper) {
    lower = std::max(axis.Lower(), -kFullTurn);
    upper = std::min(axis.Upper(), kFullTurn);
    if (!(axis.Lower() <= axis.Upper())) {
      // A message with the numbers.
      upper = context_.within(axis.Upper(), axis.Lower(), std::max(axis.Lower(), kFullTurn), "upper",
                              joint.Element());
      return;
    }
    const bool endless = axis.Lower() <= -kFullTurn && axis.Upper() >= kFullTurn;
    const bool within = axis.Lower() >= -robotlink::kPi && axis.Upper() <= robotlink::kPi;
    const bool isServo = joint.Element()->HasElement("robotcontrol:servo");
    const bool hasStops = axis.Lower() > -kEndless || axis.Upper() < kEndless;
    if (endless && hasStops)
      context_.omit(joint.Element(), "stops beyond a full turn", "the joint turns without stops");
    if (isServo && !endless && !within && (axis.Lower() < -kFullTurn || axis.Upper() > kFullTurn))
      context_.omit(joint.Element(), "a stop beyond a full turn", "the servo only turns up to there");
    if (endless || within || isServo) return;
    context_.omit(joint.Element(), "stops beyond half a turn", "the joint turns without stops");
    lower = -kFullTurn;
    upper = kFullTurn;
  }

  void readServo(const sdf::JointAxis& axis, const sdf::ElementPtr& element, JointDescription& result) const {
    const sdf::ElementPtr servo = element->GetElement("robotcontrol:servo");
    result.servo = true;
    // Without limits, SDFormat has infinite values, which no servo has.
    result.maximumSpeed = context_.within(axis.MaxVelocity(), 1e-6, 1000, "a servo's <velocity>", element);
    const double most = result.kind == JointKind::kSlider ? 1e6 : 1000;
    result.maximumTorque = context_.within(axis.Effort(), 1e-9, most, "a servo's <effort>", element);
    const double initial = ownNumber(servo, "initial_position", 0, result.lower, result.upper, context_);
    // Without one it is 0, where that is possible.
    result.initialAngle = context_.within(initial, result.lower, result.upper,
                                          "initial_position of '" + result.name + "'", servo);
    const double noise = ownNumber(servo, "position_noise", 0, 0, 1, context_);
    if (noise > 0) result.positionErrors.noise = {{.stddev = noise}};
  }

  const Pose3& sourceInModel_;
  const std::string& prefix_;
  ModelDescription& model_;
  const SdfContext& context_;
  /// Whether the ends of the joint that is being read were exchanged.
  bool turned_ = false;
};

}  // namespace

void readJoints(const sdf::Model& source, const Pose3& sourceInModel, const std::string& prefix,
                ModelDescription& model, const SdfContext& context) {
  JointReader reader(sourceInModel, prefix, model, context);
  for (std::uint64_t i = 0; i < source.JointCount(); ++i) reader.read(*source.JointByIndex(i));
}

namespace {

/// Puts joints behind those that place their parents, otherwise in the order of the file.
class JointOrder {
 public:
  JointOrder(std::vector<JointDescription> joints, std::size_t links)
      : joints_(std::move(joints)), isTaken_(joints_.size()), isPlaced_(links, true), ofParent_(links) {
    for (JointDescription& joint : joints_) {
      // The first joint of a link says where it is; further ones close cycles.
      const auto child = static_cast<std::size_t>(joint.child);
      joint.closesCycle = !isPlaced_[child];
      isPlaced_[child] = false;
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i].closesCycle) continue;
      const int parent = joints_[i].parent;
      if (parent < 0 || isPlaced_[static_cast<std::size_t>(parent)])
        ready_.push(i);
      else
        ofParent_[static_cast<std::size_t>(parent)].push_back(i);
    }
  }

  /// All but those that close cycles.
  std::vector<JointDescription> take() {
    std::vector<JointDescription> ordered;
    for (auto first = joints_.begin(); first != joints_.end();) {
      takeReady(ordered);
      // All joints that are left depend on a cycle: cut it at its first joint.
      first = std::find_if(first, joints_.end(), [&](const JointDescription& joint) {
        return !joint.closesCycle && !isTaken_[indexOf(joint)];
      });
      if (first == joints_.end()) break;
      first->closesCycle = true;
      place(first->child);
    }
    return ordered;
  }

  /// Returns the joints that take() has not removed, in their order.
  std::vector<JointDescription> rest() {
    std::vector<JointDescription> result;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (!isTaken_[i]) result.push_back(std::move(joints_[i]));
    }
    return result;
  }

 private:
  std::size_t indexOf(const JointDescription& joint) const {
    return static_cast<std::size_t>(&joint - joints_.data());
  }

  void place(int link) {
    isPlaced_[static_cast<std::size_t>(link)] = true;
    for (const std::size_t i : ofParent_[static_cast<std::size_t>(link)]) ready_.push(i);
  }

  void takeReady(std::vector<JointDescription>& ordered) {
    while (!ready_.empty()) {
      const std::size_t i = ready_.top();
      ready_.pop();
      // An earlier cut may have opened this cycle already.
      if (joints_[i].closesCycle) continue;
      isTaken_[i] = true;
      const int child = joints_[i].child;
      ordered.push_back(std::move(joints_[i]));
      place(child);
    }
  }

  std::vector<JointDescription> joints_;
  std::vector<bool> isTaken_, isPlaced_;
  /// The joints that wait for a link.
  std::vector<std::vector<std::size_t>> ofParent_;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready_;
};

}  // namespace

void orderJoints(ModelDescription& model, const sdf::ElementPtr& element, const SdfContext& context) {
  JointOrder order(std::move(model.joints), model.links.size());
  model.joints = order.take();
  for (JointDescription& joint : order.rest()) {
    if (joint.servo) {
      context.fail(element, "scene.joint-cycle",
                   "the joint '" + joint.name +
                       "' closes a cycle or gives a link a second parent, so it can have no servo");
    }
    model.joints.push_back(std::move(joint));
  }
}

}  // namespace simcore
