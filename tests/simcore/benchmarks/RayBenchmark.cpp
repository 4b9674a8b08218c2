// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <cmath>

#include "simcore/ranging/ImageSensing.h"
#include "simcore/rendering/BodyTree.h"
#include "simcore/rendering/CameraRenderer.h"
#include "simcore/rendering/RayCaster.h"
#include "tests/simcore/CameraScenes.h"

// A facette camera of 1000 facettes, a depth image of 176 x 144, and a laser scan of 181 readings, on a field
// with eight robots and about 14,400 triangles; each beside Embree alone for the same rays: packets of eight
// neighbors, made before, and the tree of all bodies, committed before. The aim is at most 1.3 times the time
// of Embree.
namespace {

using namespace simcore;
using namespace simcore::test;

const CameraScene& field() {
  static const CameraScene kScene = fieldScene();
  return kScene;
}

/// A tree over the trees of all bodies, as Embree is meant to be used, and rays in the world.
class EmbreeAlone {
 public:
  EmbreeAlone(const RayBundle& rays, const Pose3& frame) : device_(rendering::newRayDevice()) {
    rendering::BodyTrees trees(device_, *field().scene, rendering::Contents::kEverything);
    scene_ = rtcNewScene(device_);
    for (int body = 0; body < rendering::bodyCount(*field().scene); ++body) {
      const RTCScene tree = trees.treeOf(body);
      if (tree == nullptr) continue;
      const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(geometry, tree);
      const Eigen::Matrix<float, 3, 4> transform =
          field().poses[static_cast<std::size_t>(body)].matrix().topRows<3>().cast<float>();
      rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, transform.data());
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene_, geometry);
      rtcReleaseGeometry(geometry);
      rtcReleaseScene(tree);
    }
    rtcCommitScene(scene_);
    for (const RayBundle::Packet& packet : rays.packets()) add(packet, frame);
  }
  ~EmbreeAlone() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeAlone(const EmbreeAlone&) = delete;
  EmbreeAlone& operator=(const EmbreeAlone&) = delete;

  int trace() {
    alignas(32) const int valid[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
    int hits = 0;
    for (const RTCRayHit8& packet : packets_) {
      RTCRayHit8 traced = packet;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      rtcIntersect8(valid, scene_, &context, &traced);
      hits += traced.hit.geomID[0] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    }
    return hits;
  }

 private:
  void add(const RayBundle::Packet& packet, const Pose3& frame) {
    RTCRayHit8 rays{};
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const Eigen::Vector3f along =
          (frame.linear() *
           Eigen::Vector3d(packet.direction[0][lane], packet.direction[1][lane], packet.direction[2][lane]))
              .cast<float>();
      const Eigen::Vector3f from = frame.translation().cast<float>();
      rays.ray.org_x[lane] = from.x();
      rays.ray.org_y[lane] = from.y();
      rays.ray.org_z[lane] = from.z();
      rays.ray.dir_x[lane] = along.x();
      rays.ray.dir_y[lane] = along.y();
      rays.ray.dir_z[lane] = along.z();
      rays.ray.tfar[lane] = 1000;
      rays.ray.mask[lane] = ~0U;
      rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    packets_.push_back(rays);
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::vector<RTCRayHit8> packets_;
};

ImageGeometry facettes() {
  ImageGeometry geometry;
  geometry.kind = ImageGeometry::Kind::kFacette;
  geometry.camera.width = 40;
  geometry.camera.height = 25;
  geometry.azimuthStart = 2.6;
  geometry.azimuthEnd = -2.6;
  geometry.elevationStart = 0.8;
  geometry.elevationEnd = -0.8;
  return geometry;
}

ImageGeometry depthImage() {
  return {};
}

ImageGeometry laser() {
  ImageGeometry geometry = facettes();
  geometry.camera.width = 181;
  geometry.camera.height = 1;
  geometry.azimuthStart = -robotlink::kPi / 2;
  geometry.azimuthEnd = robotlink::kPi / 2;
  geometry.elevationStart = geometry.elevationEnd = 0;
  return geometry;
}

void embreeAlone(benchmark::State& state, const ImageGeometry& geometry) {
  EmbreeAlone embree(bundleOf(geometry), field().cameras[0]);
  for (auto _ : state) benchmark::DoNotOptimize(embree.trace());
}

void facetteCamera(benchmark::State& state) {
  const RayBundle rays = bundleOf(facettes());
  RayCaster caster(field().scene);
  caster.setPoses(field().poses);
  std::vector<BundleHit> hits(rays.size());
  for (auto _ : state) {
    caster.castBundle(rays, field().cameras[0], 1000, {}, hits);
    benchmark::DoNotOptimize(hits.data());
  }
}

void depthCamera(benchmark::State& state) {
  const CameraModel camera = depthImage().camera;
  CameraRenderer renderer(field().scene, {.shadows = false});
  renderer.setPoses(field().poses);
  std::vector<float> depth(static_cast<std::size_t>(camera.width * camera.height));
  for (auto _ : state) {
    renderer.renderDepth(field().cameras[0], camera, depth);
    benchmark::DoNotOptimize(depth.data());
  }
}

void laserScan(benchmark::State& state) {
  const RayFan fan(-robotlink::kPi / 2, robotlink::kPi / 2, 181);
  RayCaster caster(field().scene);
  caster.setPoses(field().poses);
  std::vector<FanHit> hits(fan.size());
  for (auto _ : state) {
    caster.castFan(fan, field().cameras[0], 1000, {}, hits);
    benchmark::DoNotOptimize(hits.data());
  }
}

BENCHMARK_CAPTURE(embreeAlone, facettes, facettes())->Unit(benchmark::kMicrosecond);
BENCHMARK(facetteCamera)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(embreeAlone, depth, depthImage())->Unit(benchmark::kMicrosecond);
BENCHMARK(depthCamera)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(embreeAlone, laser, laser())->Unit(benchmark::kMicrosecond);
BENCHMARK(laserScan)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
