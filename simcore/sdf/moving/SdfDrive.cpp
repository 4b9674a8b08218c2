// SPDX-License-Identifier: GPL-3.0-or-later
// readDrive() of SdfConversion.h: drives of wheeled models; unfitAsWheel() of SdfDevices.h.
#include <algorithm>
#include <cmath>

#include "simcore/physics/shapes/DriveGeometry.h"
#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

// How unequal the grip of tires along and across may be.
constexpr double kMaxSlipRatio = 5;

/// Reads <robotcontrol:drive> of one model.
class DriveReader {
 public:
  DriveReader(const sdf::Model& source, ModelDescription& model, const SdfContext& context)
      : source_(source),
        model_(model),
        context_(context),
        element_(source.Element()->GetElement("robotcontrol:drive")) {}

  void read() {
    if (element_->HasAttribute("name")) drive_.name = element_->Get<std::string>("name");
    readController();
    drive_.left = wheels("robotcontrol:left");
    drive_.right = wheels("robotcontrol:right");
    drive_.track = context_.within(track(), 0.01, 10, "a drive's track", element_);
    if (drive_.left.empty() || drive_.right.empty()) {
      return fail("scene.drive",
                  "a drive needs a wheel on each side: <robotcontrol:left>, <robotcontrol:right>");
    }
    if (model_.isStatic) return fail("scene.drive", "a static model has no drive");
    const double idleTorque = ownNumber(element_, "idle_torque", 0, 0, 1000, context_);
    if (!readJointLimits()) return;
    drive_.idleForce = idleTorque / drive_.wheelRadius;
    model_.drive = drive_;
    const double ratio = driveGeometry(model_).slipRatio;
    if (ratio > 1 / kMaxSlipRatio && ratio < kMaxSlipRatio) return;
    fail("scene.drive", "wheels at these places cannot turn the model with that track");
    model_.drive.reset();
  }

 private:
  void fail(std::string id, std::string text) const {
    context_.fail(element_, std::move(id), std::move(text));
  }

  void readController() {
    const std::string controller =
        element_->HasAttribute("controller") ? element_->Get<std::string>("controller") : "arcos";
    if (controller == "none") return;
    drive_.controller = controller;
    if (controller == "arcos") return;
    fail("scene.drive", "a drive has the controller 'arcos' or 'none', not '" + controller + "'");
  }

  double track() const {
    constexpr char kTrack[] = "robotcontrol:track";
    return element_->HasElement(kTrack) ? element_->Get<double>(kTrack) : 0;
  }

  std::vector<int> wheels(const char* key) const {
    std::vector<int> joints;
    for (sdf::ElementPtr child = element_->GetFirstElement(); child; child = child->GetNextElement()) {
      if (child->GetName() != key) continue;
      const auto name = child->Get<std::string>();
      const auto found = std::ranges::find(model_.joints, name, &JointDescription::name);
      // Reported by checkSdfTree() already.
      if (found == model_.joints.end()) continue;
      if (const char* reason = unfitAsWheel(model_, *found); reason != nullptr) {
        context_.fail(child, "scene.drive", "'" + name + "' cannot be a wheel's joint: " + reason);
      } else {
        found->wheel = true;
        joints.push_back(static_cast<int>(found - model_.joints.begin()));
      }
    }
    return joints;
  }

  /// Returns the property in which a wheel should agree with the first one, but does not; null if they agree.
  const char* unlike(const JointDescription& joint, const JointDescription& first, double radius) const {
    if (std::abs(radius - drive_.wheelRadius) > 1e-6) return "be of one radius";
    if (joint.parent != first.parent) return "be joined to the same link";
    return std::abs(joint.axisInModel.dot(first.axisInModel)) > 0.9999 ? nullptr : "turn about parallel axes";
  }

  /// Speed and force are the smallest of all wheels.
  bool readJointLimits() {
    drive_.maximumSpeed = drive_.maximumForce = 1e9;
    const JointDescription& first = model_.joints[static_cast<std::size_t>(drive_.left[0])];
    for (const std::vector<int>* side : {&drive_.left, &drive_.right}) {
      for (const int index : *side) {
        const JointDescription& joint = model_.joints[static_cast<std::size_t>(index)];
        const sdf::Joint& source = *source_.JointByName(joint.name);
        const double radius = model_.links[static_cast<std::size_t>(joint.child)].collisions[0].shape.radius;
        if (drive_.wheelRadius == 0) drive_.wheelRadius = radius;
        if (const char* reason = unlike(joint, first, radius); reason != nullptr) {
          fail("scene.drive", std::string("a drive's wheels must ") + reason);
          return false;
        }
        const sdf::JointAxis& axis = *source.Axis(0);
        const double speed =
            context_.within(axis.MaxVelocity(), 1e-6, 1000, "a wheel's <velocity>", source.Element());
        const double torque =
            context_.within(axis.Effort(), 1e-9, 1000, "a wheel's <effort>", source.Element());
        drive_.maximumSpeed = std::min(drive_.maximumSpeed, speed * radius);
        drive_.maximumForce = std::min(drive_.maximumForce, torque / radius);
      }
    }
    return true;
  }

  const sdf::Model& source_;
  ModelDescription& model_;
  const SdfContext& context_;
  const sdf::ElementPtr element_;
  DriveDescription drive_;
};

}  // namespace

const char* unfitAsWheel(const ModelDescription& model, const JointDescription& joint) {
  if (joint.kind != JointDescription::Kind::kHinge || joint.closesCycle || joint.servo)
    return "it must turn freely, without a servo";
  if (joint.wheel) return "it is named twice";
  if (joint.parent < 0) return "it must be fixed to a link of the model";
  const bool isLeaf =
      std::ranges::none_of(model.joints, [&](const auto& other) { return other.parent == joint.child; });
  if (!isLeaf) return "nothing may be joined to a wheel";
  const LinkDescription& link = model.links[static_cast<std::size_t>(joint.child)];
  if (link.collisions.size() != 1 || link.collisions[0].shape.kind != Shape::Kind::kCylinder)
    return "a wheel has one <collision>, a cylinder";
  const Pose3 solid = link.poseInModel * link.collisions[0].poseInLink;
  const bool along = std::abs(solid.linear().col(2).dot(joint.axisInModel)) > 0.9999;
  const Vector3 offset = solid.translation() - joint.anchorInModel;
  const bool centered = offset.cross(joint.axisInModel).norm() < 1e-4;
  return along && centered ? nullptr : "a wheel's cylinder must be around the joint's axis";
}

void readDrive(const sdf::Model& source, ModelDescription& model, const SdfContext& context) {
  if (source.Element()->HasElement("robotcontrol:drive")) DriveReader(source, model, context).read();
}

}  // namespace simcore
