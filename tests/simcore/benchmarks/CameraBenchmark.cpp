// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>

#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/rendering/CameraRenderer.h"
#include "simcore/rendering/RayCaster.h"
#include "tests/simcore/CameraScenes.h"
#include "tests/simcore/ReferenceCamera.h"

// Images of a field with eight robots and about 14,400 triangles, 176 x 144, one core, microseconds an image.
// The reference is Embree alone in packets of eight with the same formula, in turns with ours; the aims are 8
// times its speed without and 5 times with shadows. Times are those of the thread's processor time, so others
// on the machine do not count.
namespace {

using namespace simcore;
using namespace simcore::test;
using robotlink::Image;
using robotlink::PixelFormat;

double threadMicroseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_nsec) * 1e-3;
}

class Times {
 public:
  void measure(const std::function<void()>& run) {
    const double start = threadMicroseconds();
    run();
    values_.push_back(threadMicroseconds() - start);
  }
  double median() {
    std::nth_element(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(values_.size() / 2),
                     values_.end());
    return values_[values_.size() / 2];
  }

 private:
  std::vector<double> values_;
};

/// The shipped world, its ball and eight robots, after some steps; 58,140 triangles.
CameraScene shippedScene() {
  std::ifstream in(robotlink::resource("scenes/field2002.sdf"));
  std::string world((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const auto end = world.rfind("</world>");
  if (end == std::string::npos) return {};
  std::string robots;
  for (int i = 0; i < 7; ++i) {
    robots += "<include><uri>model://ers210</uri><name>blue" + std::to_string(i + 1) + "</name><pose>" +
              std::to_string(1.5 - 0.45 * i) + (i % 2 == 0 ? " 0.5" : " -0.6") + " 0.1138 0 0 " +
              std::to_string(i) + "</pose><robotcontrol:team>blue</robotcontrol:team></include>\n";
  }
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("CameraBenchmark" + std::to_string(getpid()) + ".sdf");
  std::ofstream(file) << world.insert(end, robots);
  const auto scene = Scene::load(file);
  std::filesystem::remove(file);
  if (!scene) return {};
  const auto simulation = Simulation::create(*scene, {});
  if (!simulation) return {};
  for (int i = 0; i < 20; ++i) (*simulation)->step();
  const auto poses = (*simulation)->bodyPoses();
  CameraScene result{(*simulation)->renderScene(), {poses.begin(), poses.end()}, {}};
  for (const CameraSensor& camera : (*simulation)->cameras()) {
    result.cameras.push_back(poses[static_cast<std::size_t>(camera.body)] * camera.cameraInBody);
  }
  return result;
}

void compare(benchmark::State& state, const CameraScene& scene) {
  if (scene.cameras.empty()) return state.SkipWithError("the shipped world could not be loaded");
  const bool shadows = state.range(0) != 0;
  CameraModel camera;
  camera.width = static_cast<int>(state.range(1));
  camera.height = static_cast<int>(state.range(2));
  CameraRenderer renderer(scene.scene, {shadows});
  ReferenceCamera reference(scene.scene, shadows);
  renderer.setPoses(scene.poses);
  reference.setPoses(scene.poses);
  Times ours, theirs;
  Image image, other;
  renderer.render(scene.cameras.front(), camera, PixelFormat::kYuyv, {}, image);
  for ([[maybe_unused]] const auto _ : state) {
    ours.measure([&] {
      for (const Pose3& pose : scene.cameras) renderer.render(pose, camera, PixelFormat::kYuyv, {}, image);
    });
    theirs.measure([&] {
      for (const Pose3& pose : scene.cameras) reference.render(pose, camera, other);
    });
  }
  const auto images = static_cast<double>(scene.cameras.size());
  state.counters["ours_us"] = ours.median() / images;
  state.counters["embree_us"] = theirs.median() / images;
  state.counters["times_faster"] = theirs.median() / ours.median();
}

void againstEmbree(benchmark::State& state) {
  compare(state, fieldScene());
}
BENCHMARK(againstEmbree)
    ->ArgNames({"shadows", "w", "h"})
    ->Args({0, 176, 144})
    ->Args({1, 176, 144})
    ->Args({1, 640, 480});

/// Here Embree also has to look out of the robots' heads, whose inner sides it hits first.
void againstEmbreeInShippedWorld(benchmark::State& state) {
  compare(state, shippedScene());
}
BENCHMARK(againstEmbreeInShippedWorld)
    ->ArgNames({"shadows", "w", "h"})
    ->Args({0, 176, 144})
    ->Args({1, 176, 144});

void render(benchmark::State& state, const CameraRenderer::Options& options, PixelFormat format,
            double sigma) {
  const CameraScene scene = fieldScene();
  CameraRenderer renderer(scene.scene, options);
  renderer.setPoses(scene.poses);
  Image image;
  std::uint64_t frame = 0;
  for ([[maybe_unused]] const auto _ : state) {
    renderer.render(scene.cameras[frame % scene.cameras.size()], {}, format, {sigma, 1, 1, frame}, image);
    ++frame;
  }
}
using Arithmetic = CameraRenderer::Arithmetic;
BENCHMARK_CAPTURE(render, withoutShadows, {false}, PixelFormat::kYuyv, 0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(render, withShadows, {true}, PixelFormat::kYuyv, 0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(render, withShadowsAndNoise, {true}, PixelFormat::kYuyv, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(render, asRgb, {true}, PixelFormat::kRgb8, 0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(render, portable, {true, Arithmetic::kPortable}, PixelFormat::kYuyv, 0)
    ->Unit(benchmark::kMicrosecond);

/// A bumpy square of 0.8 m with two triangles for each of `side`^2 fields.
Mesh bumps(int side) {
  Mesh mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(side) - 0.5F,
                  v = static_cast<float>(y) / static_cast<float>(side) - 0.5F;
      mesh.vertices.emplace_back(0.8F * u, 0.8F * v, 0.1F + 0.05F * std::sin(20 * u) * std::cos(20 * v));
      mesh.normals.emplace_back(
          Eigen::Vector3f(-std::cos(20 * u) * std::cos(20 * v), std::sin(20 * u) * std::sin(20 * v), 0.8F)
              .normalized());
    }
  }
  const auto row = static_cast<std::uint32_t>(side + 1);
  for (std::uint32_t y = 0; y + 1 < row; ++y) {
    for (std::uint32_t x = 0; x + 1 < row; ++x) {
      const std::uint32_t i = y * row + x;
      mesh.triangles.push_back({i, i + 1, i + row});
      mesh.triangles.push_back({i + 1, i + row + 1, i + row});
    }
  }
  return mesh;
}

/// What a mesh of 100,000 triangles costs more than a box in the same place, microseconds an image; at a
/// distance of 1 m it fills half of the image.
void largeMesh(benchmark::State& state) {
  const CameraScene field = fieldScene();
  const auto with = [&](Mesh mesh) {
    RenderScene scene = *field.scene;
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back(
        {static_cast<int>(scene.meshes.size()) - 1, 0, Pose3::Identity(), {200, 30, 30}, "object"});
    auto renderer = std::make_unique<CameraRenderer>(std::make_shared<const RenderScene>(std::move(scene)),
                                                     CameraRenderer::Options{state.range(1) != 0});
    renderer->setPoses(field.poses);
    return renderer;
  };
  const auto mesh = with(bumps(224)), box = with(boxMesh({0.8F, 0.8F, 0.2F}));
  Pose3 camera = Pose3::Identity();
  const double distance = static_cast<double>(state.range(0)) / 10;
  camera.translation() = Eigen::Vector3d(-distance, 0, distance / 2);
  camera.rotate(Eigen::AngleAxisd(std::atan(0.5), Eigen::Vector3d::UnitY()));
  Times meshTimes, boxTimes;
  Image image;
  for ([[maybe_unused]] const auto _ : state) {
    meshTimes.measure([&] { mesh->render(camera, {}, PixelFormat::kYuyv, {}, image); });
    boxTimes.measure([&] { box->render(camera, {}, PixelFormat::kYuyv, {}, image); });
  }
  state.counters["mesh_us"] = meshTimes.median();
  state.counters["box_us"] = boxTimes.median();
  state.counters["more_us"] = meshTimes.median() - boxTimes.median();
}
BENCHMARK(largeMesh)
    ->ArgNames({"distance_dm", "shadows"})
    ->ArgsProduct({{10, 20}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

/// What the number of what is seen at each pixel costs beside an image.
void label(benchmark::State& state) {
  const CameraScene scene = fieldScene();
  CameraRenderer renderer(scene.scene, {});
  renderer.setPoses(scene.poses);
  const std::vector<std::uint8_t> labels(scene.scene->instances.size(), 1);
  Image image, labeled;
  renderer.render(scene.cameras.front(), {}, PixelFormat::kYuyv, {}, image);
  for ([[maybe_unused]] const auto _ : state) {
    renderer.label(labels, 0, labeled);
    benchmark::DoNotOptimize(labeled.data.data());
  }
}
BENCHMARK(label)->Unit(benchmark::kMicrosecond);

/// As withShadowsAndNoise, through a lens with vignetting.
void renderThroughLens(benchmark::State& state) {
  const CameraScene scene = fieldScene();
  CameraRenderer renderer(scene.scene, {});
  renderer.setPoses(scene.poses);
  CameraModel camera;
  camera.vignetting = {0.4, 0.1};
  Image image;
  std::uint64_t frame = 0;
  for ([[maybe_unused]] const auto _ : state) {
    renderer.render(scene.cameras[frame % scene.cameras.size()], camera, PixelFormat::kYuyv, {3, 1, 1, frame},
                    image);
    ++frame;
  }
}
BENCHMARK(renderThroughLens)->Unit(benchmark::kMicrosecond);

/// What eight images share after the bodies moved, found as the cost of an image of one pixel.
void newPoses(benchmark::State& state) {
  CameraScene scene = fieldScene();
  CameraRenderer renderer(scene.scene, {state.range(0) != 0});
  Image image;
  double sign = 1;
  for ([[maybe_unused]] const auto _ : state) {
    for (std::size_t i = 1; i < scene.poses.size(); ++i) scene.poses[i].translation().x() += 0.01 * sign;
    sign = -sign;
    renderer.setPoses(scene.poses);
    renderer.render(scene.cameras.front(), {1, 1}, PixelFormat::kRgb8, {}, image);
  }
}
BENCHMARK(newPoses)->ArgName("shadows")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void ray(benchmark::State& state) {
  const CameraScene scene = fieldScene();
  RayCaster caster(scene.scene);
  caster.setPoses(scene.poses);
  std::size_t i = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const Pose3& pose = scene.cameras[++i % scene.cameras.size()];
    benchmark::DoNotOptimize(caster.firstHit(pose.translation(), pose.linear().col(0), 10));
  }
}
BENCHMARK(ray);

}  // namespace
