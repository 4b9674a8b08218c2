// SPDX-License-Identifier: GPL-3.0-or-later
// Depth, class, facette and radiation cameras in whole simulations.
#include "simcore/ranging/ImageSensing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robotlink/base/Random.h"
#include "tests/simcore/SensorScenes.h"

namespace simcore {
namespace {

std::vector<float> imageOf(const Simulation& simulation, const std::string& path) {
  const Port* port = simulation.port(path);
  if (port == nullptr || port->kind != Port::Kind::kImage) {
    ADD_FAILURE() << path;
    return {};
  }
  std::vector<float> values(simulation.imageSensors()[port->index].values());
  simulation.measureImage(port->index, values);
  return values;
}

/// A camera of a type, 21 x 11 pixels, 0.3 m above the cart's origin, looking along x.
std::string camera(const std::string& type, const std::string& contents = "") {
  return "<sensor name='eye' type='" + type +
         R"('><pose>0 0 0.3 0 0 0</pose><update_rate>25</update_rate><camera>
    <horizontal_fov>1</horizontal_fov><image><width>21</width><height>11</height></image>
    <clip><near>0.1</near><far>5</far></clip>)" +
         contents + "</camera></sensor>";
}

std::string facettes(const std::string& classes, const char* azimuth = "1 -1 21",
                     const char* elevation = "0.4 -0.4 9") {
  return "<sensor name='eye' type='custom'><pose>0 0 0.3 0 0 "
         "0</pose><robotcontrol:facette><robotcontrol:azimuth>" +
         std::string(azimuth) + "</robotcontrol:azimuth><robotcontrol:elevation>" + elevation +
         "</robotcontrol:elevation>" + classes + "</robotcontrol:facette></sensor>";
}

const std::string kWall = solidAt("wall", "2.1 0 0.5 0 0 0", "0.2 1 1");

TEST(ImageSensingTest, depthIsMeasuredAlongTheOpticalAxis) {
  const auto simulation = cartWith(camera("depth_camera"), "", kWall);
  ASSERT_TRUE(simulation);
  const auto depth = imageOf(*simulation, "cart/eye/depth");
  ASSERT_EQ(depth.size(), 21U * 11U);
  for (int x = 7; x < 14; ++x) EXPECT_NEAR(depth[static_cast<std::size_t>(5 * 21 + x)], 2, 1e-3) << x;
  EXPECT_TRUE(std::isinf(depth[0])) << "the sky";
  EXPECT_EQ(simulation->port("cart/eye/depth")->info.unit, "m");
}

TEST(ImageSensingTest, aColorAndDepthCameraHasBothPorts) {
  const auto simulation = cartWith(camera("rgbd_camera"), "", kWall);
  ASSERT_TRUE(simulation);
  EXPECT_EQ(simulation->port("cart/eye/image")->kind, Port::Kind::kCamera);
  EXPECT_NEAR(imageOf(*simulation, "cart/eye/depth")[5 * 21 + 10], 2, 1e-3);
}

TEST(ImageSensingTest, classesAreTheColorsOfThePalette) {
  const std::string palette =
      "<robotcontrol:palette><robotcontrol:color name='pink'>255 0 128</robotcontrol:color>"
      "<robotcontrol:color name='green'>0 200 0</robotcontrol:color></robotcontrol:palette>";
  const auto simulation = cartWith(camera("segmentation_camera"), "",
                                   palette + solidAt("wall", "2.1 0 0.5 0 0 0", "0.2 1 1",
                                                     "<robotcontrol:color>pink</robotcontrol:color>"));
  ASSERT_TRUE(simulation);
  const auto labels = imageOf(*simulation, "cart/eye/labels");
  const auto scene = simulation->renderScene();
  ASSERT_EQ(scene->labelNames, std::vector<std::string>{"pink"});
  EXPECT_EQ(labels[5 * 21 + 10], 1);
  EXPECT_EQ(labels[0], 0);
}

TEST(ImageSensingTest, facettesSeeWhatSingleRaysHit) {
  const auto simulation =
      cartWith(facettes("<robotcontrol:class>heat</robotcontrol:class>", "3 -3 61", "1.2 -1.2 33"), "",
               solidAt("stove", "1.5 0.4 0.3 0.2 0.3 0.5", "0.4 0.6 0.6",
                       "<robotcontrol:surface class='heat'><robotcontrol:emits>7</robotcontrol:emits>"
                       "</robotcontrol:surface>") +
                   "<robotcontrol:radiation name='heat'><robotcontrol:ambient>0.5"
                   "</robotcontrol:ambient></robotcontrol:radiation>");
  ASSERT_TRUE(simulation);
  const auto heat = imageOf(*simulation, "cart/eye/image");
  const RayBundle rays = bundleOf(simulation->imageSensors()[0].geometry);
  RayCaster caster(simulation->renderScene());
  caster.setPoses(simulation->bodyPoses());
  const std::vector<int> own{1};
  int hot = 0;
  for (const RayBundle::Packet& packet : rays.packets()) {
    for (std::size_t lane = 0; static_cast<int>(lane) < packet.count; ++lane) {
      const Eigen::Vector3d direction(packet.direction[0][lane], packet.direction[1][lane],
                                      packet.direction[2][lane]);
      const auto ray = static_cast<std::size_t>(packet.ray[lane]);
      const auto hit =
          caster.firstHit(simulation->bodyPoses()[1] * Eigen::Vector3d(0, 0, 0.3), direction, 1000, own);
      if (!hit) {
        EXPECT_EQ(heat[ray], 0.5F) << "nothing but what is everywhere";
      } else {
        EXPECT_TRUE(heat[ray] == 7 || heat[ray] == 0) << "the ground neither reflects nor emits";
        hot += heat[ray] == 7 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hot, 15);
}

TEST(ImageSensingTest, aBundleHitsWhatSingleRaysHitAmongManyBodies) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->meshes = {boxMesh({0.4F, 0.3F, 0.2F}), sphereMesh(0.25F)};
  std::vector<Pose3> poses{Pose3::Identity()};
  robotlink::Random random(3);
  for (int i = 0; i < 60; ++i) {
    scene->bodies.push_back("b" + std::to_string(i));
    scene->instances.push_back({i % 2, i + 1, Pose3::Identity(), {}, "b", true});
    scene->instances.push_back({1 - i % 2, i + 1, Pose3(Eigen::Translation3d(0, 0, 0.4)), {}, "b", true});
    poses.push_back(
        Eigen::Translation3d{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-2, 2)} *
        Pose3(Eigen::AngleAxisd(random.uniform(0, 6), Eigen::Vector3d::Random().normalized())));
  }
  RayCaster caster(scene);
  caster.setPoses(poses);
  ImageGeometry geometry;
  geometry.kind = ImageGeometry::Kind::kFacette;
  geometry.camera.width = 53;
  geometry.camera.height = 27;
  geometry.azimuthStart = -3.1;
  geometry.azimuthEnd = 3.1;
  geometry.elevationStart = 1.5;
  geometry.elevationEnd = -1.5;
  const RayBundle rays = bundleOf(geometry);
  std::vector<BundleHit> hits(rays.size());
  const Pose3 frame =
      Eigen::Translation3d(0.3, -0.2, 0.1) * Pose3(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()));
  caster.castBundle(rays, frame, 3, {5, 9}, hits);
  int found = 0;
  for (const RayBundle::Packet& packet : rays.packets()) {
    for (std::size_t lane = 0; static_cast<int>(lane) < packet.count; ++lane) {
      const Eigen::Vector3d direction(packet.direction[0][lane], packet.direction[1][lane],
                                      packet.direction[2][lane]);
      const std::vector<int> excluded{5, 6, 7, 8};
      const auto hit = caster.firstHit(frame.translation(), frame.linear() * direction, 3, excluded);
      const BundleHit& other = hits[static_cast<std::size_t>(packet.ray[lane])];
      ASSERT_EQ(other.instance >= 0, hit.has_value());
      ASSERT_NEAR(other.distance, hit ? hit->distance : 3, 1e-4);
      if (!hit) continue;
      ++found;
      EXPECT_EQ(scene->instances[static_cast<std::size_t>(other.instance)].body, hit->body);
    }
  }
  EXPECT_GT(found, 200);
}

TEST(ImageSensingTest, emittersLightUpSurfacesUnlessSomethingIsBetween) {
  const std::string surface =
      "<robotcontrol:surface "
      "class='heat'><robotcontrol:reflects>0.5</robotcontrol:reflects></robotcontrol:surface>";
  const std::string emitter =
      R"(<robotcontrol:emitter><robotcontrol:position>1 0.5 0.3</robotcontrol:position>
      <robotcontrol:attenuation>3</robotcontrol:attenuation>
      <robotcontrol:intensity class="heat">8</robotcontrol:intensity></robotcontrol:emitter>)";
  const std::string wall = solidAt("wall", "2.1 0 0.5 0 0 0", "0.2 1 1", surface);
  const auto valueWith = [&](const std::string& more) {
    const auto simulation =
        cartWith(facettes("<robotcontrol:class>heat</robotcontrol:class>", "0 0 1", "0 0 1") + emitter, "",
                 wall + more);
    return imageOf(*simulation, "cart/eye/image").at(0);
  };
  // 0.5 * 8 / (1 + 3 * 1.25 m^2), at an angle.
  EXPECT_NEAR(valueWith(""), 4 / 4.75 / std::sqrt(1.25), 1e-3);
  EXPECT_EQ(valueWith(solidAt("cube", "1.5 0.25 0.35 0 0 0", "0.1 0.1 0.1")), 0);
}

TEST(ImageSensingTest, lightOfColorsIsDerivedFromTheMaterialsWhereNothingIsSaid) {
  const std::string red = "<material><diffuse>0.784 0 0 1</diffuse></material>";
  const auto simulation = cartWith(
      facettes("<robotcontrol:class>Y</robotcontrol:class><robotcontrol:class>Cr</robotcontrol:class>"
               "<robotcontrol:class>R</robotcontrol:class>",
               "0 0 1", "0 0 1"),
      "",
      "<scene><ambient>0.5 0.5 0.5 1</ambient></scene>" + solidAt("wall", "2.1 0 0.5 0 0 0", "0.2 1 1", red));
  ASSERT_TRUE(simulation);
  const auto seen = imageOf(*simulation, "cart/eye/image");
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_NEAR(seen[0], 0.299F * 200 * 0.5F, 0.1);
  EXPECT_NEAR(seen[1], 128 + 0.5F * 200 * 0.5F, 0.1);
  EXPECT_NEAR(seen[2], 100, 0.1);
}

TEST(ImageSensingTest, aPinholeCameraSensesTheClassesThatItNames) {
  const auto simulation =
      cartWith(camera("camera", "<robotcontrol:class>heat</robotcontrol:class>"), "",
               solidAt("stove", "2.1 0 0.5 0 0 0", "0.2 1 1",
                       "<robotcontrol:surface class='heat'><robotcontrol:emits>7</robotcontrol:emits>"
                       "</robotcontrol:surface>"));
  ASSERT_TRUE(simulation);
  const auto image = imageOf(*simulation, "cart/eye/image");
  ASSERT_EQ(image.size(), 21U * 11U);
  EXPECT_EQ(image[5 * 21 + 10], 7);
  EXPECT_EQ(image[0], 0);
  EXPECT_TRUE(simulation->cameras().empty());
}

TEST(ImageSensingTest, depthHasTheNoiseThatIsChosenAndTheOracleHasNone) {
  const auto simulation = cartWith(camera("depth_camera"), "", kWall);
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->setSensorErrors("cart/eye/depth", {.noise = {{.stddev = 0.1}}}));
  const auto noisy = imageOf(*simulation, "cart/eye/depth");
  EXPECT_EQ(noisy, imageOf(*simulation, "cart/eye/depth")) << "the same, however often it is read";
  const auto exact = simulation->readTruth("cart/eye/depth");
  ASSERT_TRUE(exact);
  EXPECT_NEAR((*exact)[5 * 21 + 10], 2, 1e-3);
  EXPECT_GT(std::abs(noisy[5 * 21 + 10] - 2) + std::abs(noisy[5 * 21 + 11] - 2), 1e-3);
  EXPECT_TRUE(std::isinf(noisy[0]));
}

TEST(ImageSensingTest, theOracleKnowsWhatACameraSees) {
  const auto simulation = cartWith(camera("camera"), "", kWall);
  ASSERT_TRUE(simulation);
  const auto percepts = simulation->truePercepts(0);
  const auto wall = std::ranges::find(percepts, "wall", &TruePercept::model);
  ASSERT_NE(wall, percepts.end());
  EXPECT_NEAR(wall->modelInCamera.translation().x(), 2.1, 1e-9);
  // 1 m at 2 m: 21 / (2 tan 0.5) / 2 = 9.6 pixels.
  EXPECT_NEAR(wall->right - wall->left + 1, 9.6, 1);
  EXPECT_NEAR(wall->left + wall->right, 20, 1);
  EXPECT_GT(wall->pixels, 40);
}

}  // namespace
}  // namespace simcore
