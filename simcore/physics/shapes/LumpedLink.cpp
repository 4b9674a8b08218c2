// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/shapes/LumpedLink.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace simcore {
namespace {

/// The inertia of a mass about a point at `offset` from its center of mass.
Eigen::Matrix3d shiftedInertia(const Eigen::Matrix3d& inertia, double mass, const Vector3& offset) {
  return inertia + mass * (offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose());
}

/// Sets of links, each known by its first one.
class LinkSets {
 public:
  explicit LinkSets(std::size_t count) : first_(count) { std::iota(first_.begin(), first_.end(), 0); }
  int of(int link) const {
    while (first_[static_cast<std::size_t>(link)] != link) link = first_[static_cast<std::size_t>(link)];
    return link;
  }
  void join(int a, int b) {
    const int setA = of(a), setB = of(b);
    first_[static_cast<std::size_t>(std::max(setA, setB))] = std::min(setA, setB);
  }

 private:
  std::vector<int> first_;
};

bool moveAlike(const LinkDescription& a, const LinkDescription& b) {
  return a.weightless == b.weightless && a.linearDamping == b.linearDamping &&
         a.angularDamping == b.angularDamping;
}

/// For each link, the one that carries it if it is a wheel, and otherwise itself.
std::vector<int> carriersOf(const ModelDescription& model) {
  std::vector<int> carriers(model.links.size());
  std::iota(carriers.begin(), carriers.end(), 0);
  for (const JointDescription& joint : model.joints) {
    if (joint.wheel) carriers[static_cast<std::size_t>(joint.child)] = joint.parent;
  }
  return carriers;
}

/// A part of a rigid piece, in the frame of the piece.
struct RigidPart {
  double mass;
  Vector3 center;
  Eigen::Matrix3d inertia;
};

RigidPart partOf(const LinkDescription& link, const Pose3& frame) {
  const Pose3 linkInFrame = frame.inverse() * link.poseInModel;
  const Eigen::Matrix3d rotation = linkInFrame.linear();
  return {link.mass, linkInFrame * link.centerOfMass, rotation * link.inertia * rotation.transpose()};
}

}  // namespace

bool isWheel(const ModelDescription& model, int link) {
  return std::ranges::any_of(
      model.joints, [&](const JointDescription& joint) { return joint.wheel && joint.child == link; });
}

std::vector<int> rigidParts(const ModelDescription& model) {
  const auto linkAt = [&](int link) -> const LinkDescription& {
    return model.links[static_cast<std::size_t>(link)];
  };
  const std::vector<int> carriers = carriersOf(model);
  const auto isCarried = [&](int link) { return carriers[static_cast<std::size_t>(link)] != link; };
  LinkSets sets(model.links.size());
  for (const JointDescription& joint : model.joints) {
    if (joint.kind == JointDescription::Kind::kFixed && !joint.isMeasured && joint.parent >= 0 &&
        !isCarried(joint.parent) && !isCarried(joint.child) &&
        moveAlike(linkAt(joint.parent), linkAt(joint.child)))
      sets.join(joint.parent, joint.child);
  }
  // A joint cannot connect a body with itself.
  std::vector<bool> stayApart(model.links.size(), false);
  for (const JointDescription& joint : model.joints) {
    if (joint.kind == JointDescription::Kind::kFixed || joint.wheel || joint.parent < 0) continue;
    const int above = sets.of(carriers[static_cast<std::size_t>(joint.parent)]);
    if (above == sets.of(carriers[static_cast<std::size_t>(joint.child)]))
      stayApart[static_cast<std::size_t>(above)] = true;
  }
  std::vector<int> parts(model.links.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int set = sets.of(static_cast<int>(i));
    parts[i] = stayApart[static_cast<std::size_t>(set)] ? static_cast<int>(i) : set;
  }
  return parts;
}

LinkDescription lumpedLink(const ModelDescription& model, const std::vector<int>& parts, int link) {
  LinkDescription result = model.links[static_cast<std::size_t>(link)];
  const Pose3 frame = result.poseInModel;
  std::vector<RigidPart> pieces = {{result.mass, result.centerOfMass, result.inertia}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] == link && static_cast<int>(i) != link) pieces.push_back(partOf(model.links[i], frame));
  }
  for (const JointDescription& joint : model.joints) {
    if (joint.wheel && parts[static_cast<std::size_t>(joint.parent)] == link)
      pieces.push_back(partOf(model.links[static_cast<std::size_t>(joint.child)], frame));
  }
  if (pieces.size() == 1) return result;
  result.mass = 0;
  Vector3 moment = Vector3::Zero();
  for (const RigidPart& piece : pieces) {
    result.mass += piece.mass;
    moment += piece.mass * piece.center;
  }
  result.centerOfMass = moment / result.mass;
  result.inertia.setZero();
  for (const RigidPart& piece : pieces) {
    result.inertia += shiftedInertia(piece.inertia, piece.mass, piece.center - result.centerOfMass);
  }
  return result;
}

}  // namespace simcore
