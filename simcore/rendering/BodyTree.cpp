// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/BodyTree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace simcore::rendering {
namespace {

using Matrix34 = std::array<float, 12>;

/// Column by column, in Embree's order.
Matrix34 columns(const Pose3& pose) {
  Matrix34 result;
  auto* out = result.begin();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) *out++ = static_cast<float>(pose.matrix()(row, column));
  }
  return result;
}

/// Attaches a copy of an instance's mesh, transformed to the body's frame.
void attachMesh(RTCDevice device, RTCScene scene, const Mesh& mesh, const Pose3& meshInBody) {
  if (mesh.triangles.empty()) return;
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    const Eigen::Vector3f point = (meshInBody * vertex.cast<double>()).cast<float>();
    for (int k = 0; k < 3; ++k) *vertices++ = point[k];
  }
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                              mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) *indices++ = index;
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace

RayInstructions fastestRayInstructions() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return RayInstructions::kAvx2;
#endif
  return RayInstructions::kSse2;
}

RTCDevice newRayDevice(RayInstructions instructions) {
  // The instruction set is one of two because others give other bits for some rays. One thread is enough, as
  // the trees are small.
  return rtcNewDevice(instructions == RayInstructions::kAvx2 ? "threads=1,set_affinity=0,isa=avx2"
                                                             : "threads=1,set_affinity=0,isa=sse2");
}

BodyTrees::~BodyTrees() {
  for (const Tree& tree : trees_) rtcReleaseScene(tree.scene);
}

bool BodyTrees::isWanted(const RenderInstance& instance, int body) const {
  return instance.body == body && (instance.castsShadow || contents_ == Contents::kEverything);
}

BodyTrees::Content BodyTrees::contentOf(int body) const {
  Content content;
  for (const RenderInstance& instance : scene_.instances) {
    if (!isWanted(instance, body)) continue;
    content.push_back(instance.mesh);
    const double* const pose = instance.meshInBody.matrix().data();
    content.insert(content.end(), pose, pose + 16);
  }
  return content;
}

RTCScene BodyTrees::treeOf(int body) {
  Content content = contentOf(body);
  if (content.empty()) return nullptr;
  auto found =
      std::find_if(trees_.begin(), trees_.end(), [&](const Tree& tree) { return tree.content == content; });
  if (found == trees_.end()) found = trees_.insert(trees_.end(), Tree{std::move(content), build(body)});
  rtcRetainScene(found->scene);
  return found->scene;
}

RTCScene BodyTrees::build(int body) const {
  const RTCScene tree = rtcNewScene(device_);
  // A measuring ray must not slip through between two triangles; of the thousands of shadow rays one may.
  if (contents_ == Contents::kEverything) rtcSetSceneFlags(tree, RTC_SCENE_FLAG_ROBUST);
  for (const RenderInstance& instance : scene_.instances) {
    if (!isWanted(instance, body)) continue;
    attachMesh(device_, tree, scene_.meshes[static_cast<std::size_t>(instance.mesh)], instance.meshInBody);
  }
  rtcCommitScene(tree);
  return tree;
}

int bodyCount(const RenderScene& scene) {
  int count = static_cast<int>(scene.bodies.size());
  for (const RenderInstance& instance : scene.instances) count = std::max(count, instance.body + 1);
  return count;
}

BodyTree::BodyTree(const RenderScene& scene) : device_(newRayDevice()), scene_(rtcNewScene(device_)) {
  BodyTrees trees(device_, scene, Contents::kCasters);
  for (int body = 0; body < bodyCount(scene); ++body) addBody(trees, body);
}

BodyTree::~BodyTree() {
  for (const Body& body : bodies_) rtcReleaseGeometry(body.geometry);
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void BodyTree::addBody(BodyTrees& trees, int body) {
  const RTCScene inner = trees.treeOf(body);
  if (inner == nullptr) return;
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, inner);
  rtcReleaseScene(inner);
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns(Pose3::Identity()).data());
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(body));
  bodies_.push_back({geometry, body});
}

void BodyTree::setPoses(std::span<const Pose3> bodyInWorld) {
  for (const Body& body : bodies_) {
    const auto index = static_cast<std::size_t>(body.index);
    if (index == 0 || index >= bodyInWorld.size()) continue;
    rtcSetGeometryTransform(body.geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                            columns(bodyInWorld[index]).data());
    rtcCommitGeometry(body.geometry);
    changed_ = true;
  }
}

RTCScene BodyTree::scene() {
  if (changed_) rtcCommitScene(scene_);
  changed_ = false;
  return scene_;
}

}  // namespace simcore::rendering
