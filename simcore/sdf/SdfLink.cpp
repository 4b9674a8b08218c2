// SPDX-License-Identifier: GPL-3.0-or-later
// readLink() and resolvedPose() of SdfConversion.h: links with their shapes.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

constexpr double kFarAway = 100'000;
/// Visuals without a material.
constexpr Rgb kPlain{200, 200, 200};
/// No moment of inertia is larger, kg m^2.
constexpr double kMaxMoment = 1e12;
/// A link without mass gets this, so that the solver can move it.
constexpr double kMinMass = 1e-6, kReplacementMass = 0.01;  // kg
constexpr double kReplacementInertia = 1e-5;                // kg m^2

/// Converts a channel of SDFormat's colors, 0 to 1, to a byte.
std::uint8_t channel(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.F, 1.F) * 255));
}

void readColor(const sdf::Visual& visual, VisualDescription& result, const SdfContext& context) {
  const sdf::ElementPtr element = visual.Element();
  if (!element->HasElement("robotcontrol:color")) {
    if (const sdf::Material* material = visual.Material()) {
      const auto diffuse = material->Diffuse();
      result.color = {channel(diffuse.R()), channel(diffuse.G()), channel(diffuse.B())};
    }
    return;
  }
  const auto name = element->Get<std::string>("robotcontrol:color");
  const auto found = context.palette.find(name);
  result.teamColor = name == "team";
  if (found != context.palette.end()) {
    result.color = found->second;
    result.colorName = name;
  }
  if (!result.teamColor && found == context.palette.end()) {
    context.fail(element->GetElement("robotcontrol:color"), "scene.color",
                 "no palette has the color '" + name + "'");
  }
}

void readVisual(const sdf::Visual& visual, std::vector<VisualDescription>& results,
                const SdfContext& context) {
  if (visual.Geom() == nullptr) return;
  const Pose3 pose = resolvedPose(visual.SemanticPose(), "", visual.Element(), context);
  const sdf::ElementPtr element = visual.Element();
  const bool colored =
      element->HasElement("robotcontrol:color") ||
      (element->HasElement("material") && element->GetElement("material")->HasElement("diffuse"));
  const std::vector<SurfaceRadiation> radiation = readSurface(element, context);
  for (const PlacedShape& placed : readVisibleShapes(*visual.Geom(), context)) {
    VisualDescription result;
    result.name = visual.Name();
    result.poseInLink = pose * placed.poseInGeometry;
    result.shape = placed.shape;
    result.castsShadow = visual.CastShadows();
    result.color = placed.color.value_or(kPlain);
    result.radiation = radiation;
    if (colored) readColor(visual, result, context);
    results.push_back(std::move(result));
  }
}

void readContactSurface(const sdf::ElementPtr& surface, CollisionDescription& result,
                        const SdfContext& context) {
  if (const auto friction = descendant(surface, {"friction", "ode", "mu"})) {
    result.friction = context.within(friction->Get<double>(), 0, 1e12, "mu", friction);
  }
  if (const auto bounce = descendant(surface, {"bounce", "restitution_coefficient"})) {
    result.restitution = context.within(bounce->Get<double>(), 0, 1, "restitution_coefficient", bounce);
  }
}

void readCollision(const sdf::Collision& collision, std::vector<CollisionDescription>& results,
                   const SdfContext& context) {
  if (collision.Geom() == nullptr) return;
  const sdf::ElementPtr element = collision.Element();
  const Pose3 pose = resolvedPose(collision.SemanticPose(), "", element, context);
  for (const PlacedShape& placed : readSolidShapes(*collision.Geom(), context)) {
    CollisionDescription result;
    result.name = collision.Name();
    result.poseInLink = pose * placed.poseInGeometry;
    result.shape = placed.shape;
    if (element->HasElement("surface")) readContactSurface(element->GetElement("surface"), result, context);
    results.push_back(std::move(result));
  }
}

double numberIn(const sdf::ElementPtr& element, const char* name, double otherwise) {
  return element && element->HasElement(name) ? element->GetElement(name)->Get<double>() : otherwise;
}

/// Masses and moments that the solver cannot use are raised.
void repairInertia(const sdf::ElementPtr& element, LinkDescription& result, const SdfContext& context) {
  if (result.mass < kMinMass) {
    if (!context.isStatic) context.omit(element, "mass 0", "the solver needs one: it is 0.01 kg");
    result.mass = kReplacementMass;
    result.inertia = Eigen::Matrix3d::Identity() * kReplacementInertia;
    return;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(result.inertia);
  const double least = std::max(1e-12, moments.eigenvalues().maxCoeff() * 1e-6);
  if (moments.eigenvalues().minCoeff() >= least) return;
  if (!context.isStatic)
    context.omit(element, "<inertia>", "no body has such moments: the smallest ones are raised");
  const Eigen::Vector3d raised = moments.eigenvalues().cwiseMax(std::max(least, result.mass * 1e-6));
  result.inertia = moments.eigenvectors() * raised.asDiagonal() * moments.eigenvectors().transpose();
}

/// libsdformat rejects unlikely inertias, so the element is read here; it has another name for that.
void readInertia(const sdf::Link& link, LinkDescription& result, const SdfContext& context) {
  constexpr const char* kInertial = "robotcontrol:inertial";
  result.mass = 1;
  if (!link.Element()->HasElement(kInertial)) return;
  const sdf::ElementPtr inertial = link.Element()->GetElement(kInertial);
  result.mass = context.within(numberIn(inertial, "mass", 1), 0, 1e9, "a mass", inertial);
  Pose3 centerInLink = Pose3::Identity();
  if (inertial->HasElement("pose"))
    centerInLink = toEigen(inertial->GetElement("pose")->Get<ignition::math::Pose3d>());
  result.centerOfMass = centerInLink.translation();
  const sdf::ElementPtr moments = inertial->HasElement("inertia") ? inertial->GetElement("inertia") : nullptr;
  const auto moment = [&](const char* name, double otherwise) { return numberIn(moments, name, otherwise); };
  const double xy = moment("ixy", 0), xz = moment("ixz", 0), yz = moment("iyz", 0);
  Eigen::Matrix3d inertia;
  inertia << moment("ixx", 1), xy, xz, xy, moment("iyy", 1), yz, xz, yz, moment("izz", 1);
  const Eigen::Matrix3d& rotation = centerInLink.linear();
  result.inertia = rotation * inertia * rotation.transpose();
  const bool isPossible = inertia.allFinite() && inertia.cwiseAbs().maxCoeff() <= kMaxMoment &&
                          result.centerOfMass.allFinite() && result.centerOfMass.norm() <= kFarAway;
  if (!isPossible) {
    context.fail(inertial, "scene.inertia",
                 "the moments of inertia of '" + link.Name() +
                     "' must be at most 1e12 kg m^2, and its center of mass at most 100 km away");
    result.inertia.setIdentity();
    result.centerOfMass.setZero();
  }
  repairInertia(inertial, result, context);
}

}  // namespace

Pose3 resolvedPose(const sdf::SemanticPose& semantic, const std::string& frame,
                   const sdf::ElementPtr& element, const SdfContext& context) {
  ignition::math::Pose3d pose;
  context.take(semantic.Resolve(pose, frame), element);
  if (pose.Pos().IsFinite() && pose.Pos().Length() <= kFarAway && pose.Rot().IsFinite()) return toEigen(pose);
  context.fail(element, "scene.pose", "a pose must be finite and at most 100 km away");
  return Pose3::Identity();
}

LinkDescription readLink(const sdf::Link& link, const SdfContext& context) {
  LinkDescription result;
  result.name = link.Name();
  result.poseInModel = resolvedPose(link.SemanticPose(), "__model__", link.Element(), context);
  readInertia(link, result, context);
  if (link.Element()->HasElement("gravity")) result.weightless = !link.Element()->Get<bool>("gravity");
  if (link.Element()->HasElement("velocity_decay")) {
    const sdf::ElementPtr decay = link.Element()->GetElement("velocity_decay");
    result.linearDamping = context.within(decay->Get<double>("linear"), 0, 100, "linear", decay);
    result.angularDamping = context.within(decay->Get<double>("angular"), 0, 100, "angular", decay);
  }
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    readCollision(*link.CollisionByIndex(i), result.collisions, context);
  }
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    readVisual(*link.VisualByIndex(i), result.visuals, context);
  }
  result.emitters = readEmitters(link.Element(), context);
  return result;
}

}  // namespace simcore
