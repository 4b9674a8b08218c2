// SPDX-License-Identifier: GPL-3.0-or-later
// readVisibleShapes() and readSolidShapes() of SdfConversion.h: what a <geometry> describes.
#include <algorithm>

#include "simcore/meshes/PolylineMesh.h"
#include "simcore/sdf/SdfConversion.h"

namespace simcore {
namespace {

constexpr double kSmallest = 1e-6, kLargest = 1e5;  // meters
/// Above this, static solids are boxes, too: ODE tests every triangle near a body.
constexpr std::size_t kMaxSolidTriangles = 100'000;
/// The minimum thickness, so that flat meshes have a volume.
constexpr double kThinnest = 1e-3;  // m

using Shapes = std::vector<PlacedShape>;

double checkedLength(double value, const char* what, const sdf::ElementPtr& element,
                     const SdfContext& context) {
  return context.within(value, kSmallest, kLargest, what, element);
}

Vector3 checkedEdges(const ignition::math::Vector3d& size, const char* what, const sdf::ElementPtr& element,
                     const SdfContext& context) {
  Vector3 result = toEigen(size);
  for (double& edge : result) edge = checkedLength(edge, what, element, context);
  return result;
}

PlacedShape round(Shape::Kind kind, double radius, double length) {
  PlacedShape result;
  result.shape.kind = kind;
  result.shape.radius = radius;
  result.shape.length = length;
  return result;
}

PlacedShape planeOf(const sdf::Plane& plane, const sdf::ElementPtr& element, const SdfContext& context) {
  PlacedShape result;
  result.shape.kind = Shape::Kind::kPlane;
  result.shape.size = {checkedLength(plane.Size().X(), "a plane's size", element, context),
                       checkedLength(plane.Size().Y(), "a plane's size", element, context), 0};
  const Vector3 normal = toEigen(plane.Normal());
  if (normal != Vector3::UnitZ()) result.poseInGeometry.linear() = robotlink::rotationFromZAxis(normal);
  return result;
}

/// Returns a box, sphere, cylinder, capsule or plane; empty if the geometry is none of these.
Shapes readBasicShape(const sdf::Geometry& geometry, const SdfContext& context) {
  const sdf::ElementPtr element = geometry.Element();
  const auto size = [&](double value, const char* what) {
    return checkedLength(value, what, element, context);
  };
  if (const sdf::Box* box = geometry.BoxShape()) {
    PlacedShape result;
    result.shape.size = checkedEdges(box->Size(), "a box's edge", element, context);
    return {result};
  }
  if (const sdf::Sphere* sphere = geometry.SphereShape())
    return {round(Shape::Kind::kSphere, size(sphere->Radius(), "a sphere's radius"), 0)};
  if (const sdf::Cylinder* one = geometry.CylinderShape()) {
    return {round(Shape::Kind::kCylinder, size(one->Radius(), "a cylinder's radius"),
                  size(one->Length(), "a cylinder's length"))};
  }
  if (const sdf::Capsule* one = geometry.CapsuleShape()) {
    return {round(Shape::Kind::kCapsule, size(one->Radius(), "a capsule's radius"),
                  size(one->Length(), "a capsule's length"))};
  }
  if (const sdf::Plane* plane = geometry.PlaneShape()) return {planeOf(*plane, element, context)};
  return {};
}

PlacedShape meshShape(std::shared_ptr<const Mesh> mesh, std::optional<Rgb> color = {}) {
  PlacedShape result;
  result.shape.kind = Shape::Kind::kMesh;
  result.shape.mesh = std::move(mesh);
  result.color = color;
  return result;
}

Shapes readEllipsoid(const sdf::Geometry& geometry, const SdfContext& context) {
  const Vector3 radii =
      checkedEdges(geometry.EllipsoidShape()->Radii(), "an ellipsoid's radius", geometry.Element(), context);
  if (radii.maxCoeff() - radii.minCoeff() < 1e-9) return {round(Shape::Kind::kSphere, radii.x(), 0)};
  return {meshShape(scaledMesh(sphereMesh(1), radii))};
}

/// SDFormat 1.12; libsdformat does not know it.
Shapes readCone(const sdf::ElementPtr& cone, const SdfContext& context) {
  const auto number = [&](const char* key, double otherwise) {
    return checkedLength(cone->HasElement(key) ? cone->GetElement(key)->Get<double>() : otherwise,
                         "a cone's size", cone, context);
  };
  return {meshShape(std::make_shared<const Mesh>(
      coneMesh(static_cast<float>(number("radius", 0.5)), static_cast<float>(number("length", 1)))))};
}

Shapes readPolylines(const sdf::Geometry& geometry, const SdfContext& context) {
  const sdf::ElementPtr line = geometry.Element()->GetElement("polyline");
  if (line->GetNextElement("polyline"))
    context.omit(geometry.Element(), "<polyline>s after the first", "holes are filled");
  std::vector<robotlink::Vector2> points;
  for (sdf::ElementPtr child = line->GetFirstElement(); child; child = child->GetNextElement()) {
    if (child->GetName() != "point") continue;
    const auto point = child->Get<ignition::math::Vector2d>();
    points.emplace_back(point.X(), point.Y());
  }
  const double height = checkedLength(line->HasElement("height") ? line->Get<double>("height") : 1,
                                      "a polyline's height", geometry.Element(), context);
  auto mesh = extrudedMesh(points, height);
  if (!mesh) {
    context.fail(geometry.Element(), "scene.polyline",
                 "a polyline needs 3 to 1000 points that do not cross: " + mesh.error());
    return {};
  }
  return {meshShape(std::make_shared<const Mesh>(std::move(*mesh)))};
}

/// The parts that <submesh> names, or all; centered if it requires that.
Shapes partsOf(const MeshFiles::Parts& parts, const sdf::Mesh& source, const SdfContext& context) {
  const std::string& wanted = source.Submesh();
  std::vector<const MeshPart*> chosen;
  for (const MeshPart& part : parts) {
    if (wanted.empty() || part.name == wanted || part.node == wanted) chosen.push_back(&part);
  }
  if (chosen.empty()) {
    std::string names;
    for (const MeshPart& part : parts) names += (names.empty() ? "" : ", ") + part.node;
    context.omit(source.Element(), "submesh '" + wanted + "'",
                 "the file has no such part; there are " + names.substr(0, 300));
    return {};
  }
  const Vector3 scale = toEigen(source.Scale());
  if (!scale.allFinite() || scale.cwiseAbs().minCoeff() <= 0 || scale.cwiseAbs().maxCoeff() > 1e6) {
    context.fail(source.Element(), "scene.mesh", "a mesh's <scale> must be finite and not 0");
    return {};
  }
  Vector3 offset = Vector3::Zero();
  if (source.CenterSubmesh() && !wanted.empty()) {
    Eigen::AlignedBox3f box;
    for (const MeshPart* part : chosen) {
      for (const auto& vertex : part->mesh->vertices) box.extend(vertex);
    }
    offset = -box.center().cast<double>().cwiseProduct(scale);
  }
  Shapes result;
  for (const MeshPart* part : chosen) {
    const bool unchanged = scale == Vector3::Ones() && offset.isZero(0);
    result.push_back(meshShape(unchanged ? part->mesh : scaledMesh(*part->mesh, scale, offset), part->color));
  }
  return result;
}

Shapes readMeshFile(const sdf::Mesh& source, const SdfContext& context) {
  const std::string& uri = source.Uri();
  const sdf::ElementPtr element = source.Element();
  if (isNoText(uri)) {
    context.omit(element, "<mesh>", "it has no <uri> that names a file");
    return {};
  }
  const std::string what = "mesh " + uri;
  if (isNetworkUri(uri)) {
    context.omit(element, what, "nothing is fetched from the network");
    return {};
  }
  const auto file = context.search.find(uri, element->FilePath());
  if (!file) {
    context.omit(element, what, "there is no such file; name the folder of its model with --models");
    return {};
  }
  const auto& parts = context.meshes.read(*file);
  if (!parts) {
    context.omit(element, what, parts.error().text);
    return {};
  }
  return partsOf(*parts, source, context);
}

Shapes readShapes(const sdf::Geometry& geometry, const SdfContext& context) {
  Shapes basic = readBasicShape(geometry, context);
  if (!basic.empty()) return basic;
  const sdf::ElementPtr element = geometry.Element();
  if (geometry.EllipsoidShape() != nullptr) return readEllipsoid(geometry, context);
  if (geometry.MeshShape() != nullptr) return readMeshFile(*geometry.MeshShape(), context);
  if (element && element->HasElement("polyline")) return readPolylines(geometry, context);
  if (element && element->HasElement("cone")) return readCone(element->GetElement("cone"), context);
  const sdf::ElementPtr first = element ? element->GetFirstElement() : nullptr;
  const std::string name = first ? first->GetName() : "";
  if (name == "empty") return {};
  context.omit(
      element, name.empty() ? "<geometry>" : "<" + name + ">",
      "only box, sphere, cylinder, capsule, ellipsoid, cone, plane, mesh and polyline are supported");
  return {};
}

Mesh joinedMesh(const Shapes& shapes) {
  Mesh result;
  for (const PlacedShape& one : shapes) {
    const Mesh& mesh = *one.shape.mesh;
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.insert(result.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    result.normals.insert(result.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const auto& t : mesh.triangles)
      result.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return result;
}

PlacedShape boxAround(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex);
  PlacedShape result;
  result.shape.size = box.sizes().cast<double>().cwiseMax(kThinnest);
  result.poseInGeometry.translation() = box.center().cast<double>();
  return result;
}

}  // namespace

std::vector<PlacedShape> readVisibleShapes(const sdf::Geometry& geometry, const SdfContext& context) {
  return readShapes(geometry, context);
}

std::vector<PlacedShape> readSolidShapes(const sdf::Geometry& geometry, const SdfContext& context) {
  Shapes shapes = readShapes(geometry, context);
  if (shapes.empty() || shapes.front().shape.kind != Shape::Kind::kMesh) return shapes;
  Mesh mesh = joinedMesh(shapes);
  if (context.isStatic && mesh.triangles.size() <= kMaxSolidTriangles)
    return {meshShape(std::make_shared<const Mesh>(std::move(mesh)))};
  context.omit(geometry.Element(), "shape of a solid",
               context.isStatic ? "it has more than 100000 triangles: it is solid as the box around it"
                                : "meshes of moving bodies are solid as the boxes around them");
  return {boxAround(mesh)};
}

}  // namespace simcore
