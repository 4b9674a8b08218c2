// SPDX-License-Identifier: GPL-3.0-or-later
// Images that cameras deliver late are made while the simulation goes on.
#include <gtest/gtest.h>

#include <fstream>

#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

/// Four tumbling boxes, each with a camera: three of them are late, one also has a rolling shutter and a
/// lens, one loses images.
std::string worldOfCameras() {
  const std::string timing[] = {
      "", "<robotcontrol:delay>0.05</robotcontrol:delay>",
      "<robotcontrol:delay>0.018</robotcontrol:delay><robotcontrol:dropout>0.2</robotcontrol:dropout>",
      "<robotcontrol:delay>0.1</robotcontrol:delay>"};
  const std::string optics =
      "<distortion><k1>-0.1</k1></distortion><robotcontrol:exposure>0.008</robotcontrol:exposure>"
      "<robotcontrol:readout>0.01</robotcontrol:readout>";
  std::string text =
      "<?xml version='1.0'?><sdf version='1.9' xmlns:robotcontrol='urn:robotcontrol:sdf'><world name='w'>"
      "<light name='sun' type='directional'><direction>0.3 0.2 "
      "-1</direction><intensity>0.6</intensity></light>"
      "<model name='ground'><static>true</static><link name='l'><collision name='c'><geometry><plane>"
      "<normal>0 0 1</normal><size>20 20</size></plane></geometry></collision><visual "
      "name='v'><geometry><plane>"
      "<normal>0 0 1</normal><size>20 20</size></plane></geometry></visual></link></model>";
  for (int i = 0; i < 4; ++i) {
    const std::string shape = "<geometry><box><size>0.3 0.2 0.1</size></box></geometry>";
    text += "<model name='box" + std::to_string(i) + "'><pose>" + std::to_string(i) +
            " 0 1.5 0.4 0.3 1</pose><link name='l'><inertial><mass>1</mass><inertia><ixx>0.01</ixx>"
            "<iyy>0.01</iyy><izz>0.01</izz></inertia></inertial><collision name='c'>" +
            shape + "</collision><visual name='v'>" + shape +
            "<material><diffuse>1 0.4 0 1</diffuse></material></visual><sensor name='eye' type='camera'>"
            "<update_rate>25</update_rate>" +
            timing[i] +
            "<camera><horizontal_fov>1.2</horizontal_fov><image><width>48</width><height>32</height></image>"
            "<noise><type>gaussian</type><stddev>2</stddev></noise>" +
            (i == 3 ? optics : "") + "</camera></sensor></link></model>";
  }
  return text + "</world></sdf>";
}

struct Played {
  std::uint64_t digest = 0;
  std::uint64_t ahead = 0, images = 0;
};

/// Plays a second, with changes of light, of errors and of places in it, and going back.
Played playedBy(const std::shared_ptr<const simcore::Scene>& scene, int threads) {
  SimulatedWorld::Options options;
  options.seed = 3;
  options.threads = threads;
  options.rewindBytes = 1U << 24U;
  auto made = SimulatedWorld::create(scene, options);
  EXPECT_TRUE(made);
  SimulatedWorld& world = **made;
  for (int step = 0; step < 160; ++step) {
    world.advance();
    if (step == 40) {
      EXPECT_TRUE(world.setLighting({.brightness = 0.7, .warmth = 0.2}));
    }
    if (step == 61) world.cameraSetting(1).gain = 1.5;
    if (step % 25 == 7) {
      EXPECT_TRUE(
          world.simulation().placeModel("box1", {1, 0.01 * step, 0}, simcore::ModelPosture{.height = 2}));
    }
    if (step == 90) {
      EXPECT_TRUE(world.setSensorErrors("box0/eye/image", {.noise = {{.stddev = 1}}, .delay = 0.03}));
    }
    if (step == 120) {
      EXPECT_TRUE(world.rewind(std::chrono::milliseconds(40)));
    }
    for (std::size_t camera = 0; camera < world.simulation().cameras().size(); ++camera) {
      if (!world.imageDue(camera)) continue;
      world.render(camera);
      // What nobody asks for does not change what others get.
      if (camera == 2 && threads > 2) world.preview(3);
    }
  }
  return {world.digest(), world.imagesBegunAhead(), world.costs().images};
}

TEST(DelayedImages, haveTheSameBytesForAnyNumberOfThreads) {
  const TestFolder folder;
  const std::string file = folder / "cameras.sdf";
  std::ofstream(file) << worldOfCameras();
  const auto scene = simcore::Scene::load(file);
  ASSERT_TRUE(scene) << robotlink::describe(scene.error());
  const Played alone = playedBy(*scene, 1);
  EXPECT_GT(alone.images, 100U);
  EXPECT_EQ(alone.ahead, 0U) << "there is no other thread";
  for (const int threads : {2, 3, 8}) {
    const Played played = playedBy(*scene, threads);
    EXPECT_EQ(played.digest, alone.digest) << threads;
    EXPECT_EQ(played.images, alone.images) << threads;
    EXPECT_GT(played.ahead, 40U) << threads;
  }
}

}  // namespace
}  // namespace app
