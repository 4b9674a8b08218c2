// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/ReferenceCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simcore/rendering/BodyTree.h"

namespace simcore::test {
namespace {

constexpr int kLanes = 8;

void setTransform(RTCGeometry geometry, const Pose3& pose) {
  const Eigen::Matrix<float, 3, 4> matrix = pose.matrix().topRows<3>().cast<float>();
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix.data());
  rtcCommitGeometry(geometry);
}

RTCGeometry newInstance(RTCDevice device, RTCScene of, RTCScene into, unsigned id) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, of);
  setTransform(geometry, Pose3::Identity());
  rtcAttachGeometryByID(into, geometry, id);
  return geometry;
}

}  // namespace

/// A packet of eight pixels; where nothing is hit, the instance is invalid.
struct ReferenceCamera::Hits {
  alignas(32) int valid[kLanes];
  RTCRayHit8 rays;
  alignas(32) float nx[kLanes], ny[kLanes], nz[kLanes];  ///< interpolated, of any length
  alignas(32) float gx[kLanes], gy[kLanes], gz[kLanes];  ///< the triangle's, outwards
  alignas(32) float light[kLanes];
};

ReferenceCamera::ReferenceCamera(std::shared_ptr<const RenderScene> scene, bool shadows)
    : scene_(std::move(scene)),
      shadows_(shadows),
      device_(rendering::newRayDevice()),
      seen_(rtcNewScene(device_)),
      casting_(rtcNewScene(device_)),
      rotations_(scene_->instances.size(), Eigen::Matrix3f::Identity()) {
  for (const Mesh& mesh : scene_->meshes) meshScenes_.push_back(newMeshScene(mesh));
  for (std::size_t i = 0; i < scene_->instances.size(); ++i) {
    const RTCScene mesh = meshScenes_[static_cast<std::size_t>(scene_->instances[i].mesh)];
    seenInstances_.push_back(newInstance(device_, mesh, seen_, static_cast<unsigned>(i)));
    castingInstances_.push_back(scene_->instances[i].castsShadow
                                    ? newInstance(device_, mesh, casting_, static_cast<unsigned>(i))
                                    : nullptr);
  }
}

ReferenceCamera::~ReferenceCamera() {
  for (const RTCGeometry geometry : seenInstances_) rtcReleaseGeometry(geometry);
  for (const RTCGeometry geometry : castingInstances_) {
    if (geometry != nullptr) rtcReleaseGeometry(geometry);
  }
  for (const RTCScene scene : meshScenes_) rtcReleaseScene(scene);
  rtcReleaseScene(seen_);
  rtcReleaseScene(casting_);
  rtcReleaseDevice(device_);
}

RTCScene ReferenceCamera::newMeshScene(const Mesh& mesh) {
  const RTCScene scene = rtcNewScene(device_);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
  for (const auto& vertex : mesh.vertices) vertices = std::copy_n(vertex.data(), 3, vertices);
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) indices = std::copy_n(triangle.data(), 3, indices);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

void ReferenceCamera::setPoses(std::span<const Pose3> bodyInWorld) {
  for (std::size_t i = 0; i < scene_->instances.size(); ++i) {
    const RenderInstance& instance = scene_->instances[i];
    const Pose3 pose = bodyInWorld[static_cast<std::size_t>(instance.body)] * instance.meshInBody;
    rotations_[i] = pose.linear().cast<float>();
    setTransform(seenInstances_[i], pose);
    if (castingInstances_[i] != nullptr) setTransform(castingInstances_[i], pose);
  }
  rtcCommitScene(seen_);
  rtcCommitScene(casting_);
}

void ReferenceCamera::trace(const Pose3& cameraInWorld, const CameraModel& camera, int x, int y, Hits& hits) {
  const auto focalX = static_cast<float>(camera.width / 2.0 / std::tan(camera.horizontalAngle / 2));
  const auto focalY = static_cast<float>(camera.height / 2.0 / std::tan(camera.verticalAngle / 2));
  const Eigen::Matrix3f rotation = cameraInWorld.linear().cast<float>();
  const Eigen::Vector3f origin = cameraInWorld.translation().cast<float>();
  const float row = (static_cast<float>(camera.height) / 2 - static_cast<float>(y) - 0.5F) / focalY;
  RTCRay8& rays = hits.rays.ray;
  for (int i = 0; i < kLanes; ++i) {
    const float column = (static_cast<float>(camera.width) / 2 - static_cast<float>(x + i) - 0.5F) / focalX;
    hits.valid[i] = x + i < camera.width ? -1 : 0;
    rays.org_x[i] = origin.x();
    rays.org_y[i] = origin.y();
    rays.org_z[i] = origin.z();
    rays.dir_x[i] = rotation(0, 0) + rotation(0, 1) * column + rotation(0, 2) * row;
    rays.dir_y[i] = rotation(1, 0) + rotation(1, 1) * column + rotation(1, 2) * row;
    rays.dir_z[i] = rotation(2, 0) + rotation(2, 1) * column + rotation(2, 2) * row;
    rays.tnear[i] = 0;
    rays.tfar[i] = std::numeric_limits<float>::infinity();
    rays.mask[i] = ~0U;
    hits.rays.hit.geomID[i] = hits.rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(hits.valid, seen_, &context, &hits.rays);
  fetchNormals(hits);
  retraceBackFaces(hits);
}

void ReferenceCamera::fetchNormals(Hits& hits) const {
  for (int i = 0; i < kLanes; ++i) {
    if (hits.valid[i] == 0 || hits.rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const std::size_t instance = hits.rays.hit.instID[0][i];
    const Mesh& mesh = scene_->meshes[static_cast<std::size_t>(scene_->instances[instance].mesh)];
    const auto& triangle = mesh.triangles[hits.rays.hit.primID[i]];
    const float u = hits.rays.hit.u[i], v = hits.rays.hit.v[i];
    const Eigen::Vector3f inMesh = (1 - u - v) * mesh.normals[triangle[0]] + u * mesh.normals[triangle[1]] +
                                   v * mesh.normals[triangle[2]];
    const Eigen::Vector3f normal = rotations_[instance] * inMesh;
    const Eigen::Vector3f face =
        rotations_[instance] *
        Eigen::Vector3f(hits.rays.hit.Ng_x[i], hits.rays.hit.Ng_y[i], hits.rays.hit.Ng_z[i]);
    hits.nx[i] = normal.x();
    hits.ny[i] = normal.y();
    hits.nz[i] = normal.z();
    hits.gx[i] = face.x();
    hits.gy[i] = face.y();
    hits.gz[i] = face.z();
  }
}

void ReferenceCamera::retraceBackFaces(Hits& hits) {
  RTCRay8& rays = hits.rays.ray;
  for (int rounds = 0; rounds < 16; ++rounds) {
    alignas(32) int again[kLanes];
    bool any = false;
    for (int i = 0; i < kLanes; ++i) {
      const bool hit = hits.valid[i] != 0 && hits.rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      const bool back =
          hit && hits.gx[i] * rays.dir_x[i] + hits.gy[i] * rays.dir_y[i] + hits.gz[i] * rays.dir_z[i] > 0;
      again[i] = back ? -1 : 0;
      if (!back) continue;
      any = true;
      rays.tnear[i] = rays.tfar[i] * 1.00001F + 1e-6F;
      rays.tfar[i] = std::numeric_limits<float>::infinity();
      hits.rays.hit.geomID[i] = hits.rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    if (!any) return;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect8(again, seen_, &context, &hits.rays);
    fetchNormals(hits);
  }
}

void ReferenceCamera::addLamp(const Lamp& lamp, Hits& hits) {
  const RTCRay8& rays = hits.rays.ray;
  alignas(32) RTCRay8 shadow;
  alignas(32) float light[kLanes];
  alignas(32) int wanted[kLanes];
  int any = 0;
  for (int i = 0; i < kLanes; ++i) {
    const bool hit = hits.valid[i] != 0 && hits.rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    const float t = hit ? rays.tfar[i] : 1;
    const float x = rays.org_x[i] + t * rays.dir_x[i] - lamp.position.x();
    const float y = rays.org_y[i] + t * rays.dir_y[i] - lamp.position.y();
    const float z = rays.org_z[i] + t * rays.dir_z[i] - lamp.position.z();
    const float squared = x * x + y * y + z * z;
    const float length = hits.nx[i] * hits.nx[i] + hits.ny[i] * hits.ny[i] + hits.nz[i] * hits.nz[i];
    const float cosine =
        -(hits.nx[i] * x + hits.ny[i] * y + hits.nz[i] * z) / std::sqrt(std::max(length * squared, 1e-30F));
    const bool faces = hits.gx[i] * x + hits.gy[i] * y + hits.gz[i] * z < 0;
    light[i] = lamp.intensity * std::max(cosine, 0.0F) / (1 + squared * lamp.attenuation);
    if (!hit || (shadows_ && !faces)) light[i] = 0;
    wanted[i] = light[i] > 0 ? -1 : 0;
    any |= wanted[i];
    shadow.org_x[i] = lamp.position.x();
    shadow.org_y[i] = lamp.position.y();
    shadow.org_z[i] = lamp.position.z();
    shadow.dir_x[i] = x;
    shadow.dir_y[i] = y;
    shadow.dir_z[i] = z;
    shadow.tnear[i] = 0;
    shadow.tfar[i] = 1 - 2e-4F;
    shadow.mask[i] = ~0U;
  }
  if (shadows_ && any != 0) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded8(wanted, casting_, &context, &shadow);
    for (int i = 0; i < kLanes; ++i) light[i] = shadow.tfar[i] < 0 ? 0 : light[i];
  }
  for (int i = 0; i < kLanes; ++i) hits.light[i] += light[i];
}

void ReferenceCamera::render(const Pose3& cameraInWorld, const CameraModel& camera, robotlink::Image& image) {
  if (image.width != camera.width || image.height != camera.height) {
    image = robotlink::Image(camera.width, camera.height, robotlink::PixelFormat::kRgb8);
  }
  Hits hits{};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; x += kLanes) {
      trace(cameraInWorld, camera, x, y, hits);
      std::fill_n(hits.light, kLanes, scene_->ambient);
      for (const Lamp& lamp : scene_->lamps) addLamp(lamp, hits);
      for (int i = 0; i < std::min(kLanes, camera.width - x); ++i) {
        const bool hit = hits.rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        const Rgb color = hit ? scene_->instances[hits.rays.hit.instID[0][i]].color : scene_->background;
        const float light = hit ? std::min(hits.light[i], 1.0F) : 1.0F;
        std::uint8_t* out = image.row(y) + 3 * (x + i);
        out[0] = static_cast<std::uint8_t>(static_cast<float>(color.r) * light + 0.5F);
        out[1] = static_cast<std::uint8_t>(static_cast<float>(color.g) * light + 0.5F);
        out[2] = static_cast<std::uint8_t>(static_cast<float>(color.b) * light + 0.5F);
      }
    }
  }
}

}  // namespace simcore::test
