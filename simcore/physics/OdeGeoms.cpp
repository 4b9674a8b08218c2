// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeGeoms.h"

namespace simcore {
namespace {

/// ODE reads the vertices and indices where they are, so the mesh must outlive the geom; `data` must be
/// destroyed after it.
dGeomID createTrimesh(dSpaceID space, const Mesh& mesh, dTriMeshDataID& data) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  static_assert(sizeof(mesh.triangles[0]) == 3 * sizeof(dTriIndex));
  data = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildSingle(data, mesh.vertices.data(), 3 * sizeof(float),
                              static_cast<int>(mesh.vertices.size()), mesh.triangles.data(),
                              static_cast<int>(mesh.triangles.size() * 3), 3 * sizeof(dTriIndex));
  return dCreateTriMesh(space, data, nullptr, nullptr, nullptr);
}

dGeomID createGeom(dSpaceID space, const Shape& shape, const Pose3& pose, dTriMeshDataID& data) {
  switch (shape.kind) {
    case Shape::Kind::kBox:
      return dCreateBox(space, shape.size.x(), shape.size.y(), shape.size.z());
    case Shape::Kind::kSphere:
      return dCreateSphere(space, shape.radius);
    case Shape::Kind::kCylinder:
      return dCreateCylinder(space, shape.radius, shape.length);
    case Shape::Kind::kCapsule:
      return dCreateCapsule(space, shape.radius, shape.length);
    case Shape::Kind::kMesh:
      return createTrimesh(space, *shape.mesh, data);
    case Shape::Kind::kPlane:
      break;
  }
  const Vector3 normal = pose.linear().col(2);
  return dCreatePlane(space, normal.x(), normal.y(), normal.z(), normal.dot(pose.translation()));
}

}  // namespace

dGeomID addGeom(OdeWorld& ode, dSpaceID space, const CollisionDescription& collision, int index,
                const Pose3& pose) {
  OdeGeom& geom = ode.geoms.emplace_back();
  geom.id = createGeom(space, collision.shape, pose, geom.triangles);
  geom.index = static_cast<std::uint32_t>(ode.geoms.size() - 1);
  geom.model = index;
  geom.friction = collision.friction;
  geom.restitution = collision.restitution;
  dGeomSetData(geom.id, &geom);
  return geom.id;
}

void addBodyGeom(OdeWorld& ode, const OdeBody& body, const CollisionDescription& collision, int index,
                 dSpaceID space) {
  const dGeomID geom = addGeom(ode, space, collision, index, Pose3::Identity());
  if (collision.shape.kind == Shape::Kind::kPlane) return;
  dGeomSetBody(geom, body.id);
  const Vector3 offset = collision.poseInLink.translation() - body.centerInLink;
  withOdePose(collision.poseInLink, [&](const dReal*, const dMatrix3 r) {
    dGeomSetOffsetPosition(geom, offset.x(), offset.y(), offset.z());
    dGeomSetOffsetRotation(geom, r);
  });
}

}  // namespace simcore
