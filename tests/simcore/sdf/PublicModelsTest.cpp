// SPDX-License-Identifier: GPL-3.0-or-later
// Small models with what files of public libraries contain: all open, rest, and say what is left out of them.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"

namespace simcore {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

fs::path models() {
  return fs::path(ROBOTCONTROL_SOURCE_DIR) / "tests/simcore/sdf/models";
}

std::shared_ptr<const Scene> opened(const std::string& name) {
  const auto scene = Scene::load(models() / name);
  EXPECT_TRUE(scene) << describe(scene.error());
  return scene ? *scene : nullptr;
}

const ModelInstance& modelOf(const Scene& scene, const std::string& name) {
  const auto& all = scene.contents().world.models;
  const auto found = std::ranges::find(all, name, &ModelInstance::name);
  EXPECT_NE(found, all.end()) << name;
  return found == all.end() ? all.front() : *found;
}

std::vector<std::string> leftOutOf(const std::string& name) {
  std::vector<std::string> result;
  if (const auto scene = opened(name)) {
    for (const LeftOut& one : scene->leftOut()) result.push_back(one.what);
  }
  return result;
}

class PublicModels : public testing::TestWithParam<std::string> {};

/// Two seconds suffice: what is unstable has left by then.
TEST_P(PublicModels, opensAndRests) {
  const auto scene = opened(GetParam());
  ASSERT_TRUE(scene);
  const auto simulation = Simulation::create(scene, {});
  ASSERT_TRUE(simulation) << simulation.error().describe();
  std::map<std::string, Pose3> start;
  for (const SceneModel& model : scene->models()) start[model.name] = *(*simulation)->modelPose(model.name);
  for (int i = 0; i < 500; ++i) (*simulation)->step();
  for (const auto& [name, pose] : start) {
    const Pose3 end = *(*simulation)->modelPose(name);
    EXPECT_LT((end.translation() - pose.translation()).norm(), 0.01) << name;
    EXPECT_LT(Eigen::AngleAxisd(pose.linear().transpose() * end.linear()).angle(), 0.02) << name;
  }
}

std::vector<std::string> allFiles() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(models())) {
    if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(OfTheFolder, PublicModels, testing::ValuesIn(allFiles()), [](const auto& each) {
  std::string name = each.param;
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

TEST(PublicModelsContents, meshesHaveTheirPartsColorsAndUnits) {
  const auto scene = opened("mesh_collada.sdf");
  ASSERT_TRUE(scene);
  const LinkDescription& link = modelOf(*scene, "mesh_collada").type->links.at(0);
  ASSERT_EQ(link.visuals.size(), 2U);
  EXPECT_EQ(link.visuals[0].color, (Rgb{255, 0, 0}));
  EXPECT_EQ(link.visuals[1].color, (Rgb{0, 0, 255}));
  // A moving body is solid as the box around both cubes of 0.2 m.
  ASSERT_EQ(link.collisions.size(), 1U);
  EXPECT_TRUE(link.collisions[0].shape.size.isApprox(Vector3(0.2, 0.2, 0.4), 1e-5));
  EXPECT_NEAR(link.collisions[0].poseInLink.translation().z(), 0.2, 1e-6);
}

TEST(PublicModelsContents, aSubmeshIsCenteredAndScaled) {
  const auto scene = opened("mesh_submesh.sdf");
  ASSERT_TRUE(scene);
  const LinkDescription& link = modelOf(*scene, "mesh_submesh").type->links.at(0);
  ASSERT_EQ(link.visuals.size(), 1U);
  EXPECT_EQ(link.visuals[0].color, (Rgb{0, 0, 255}));
  EXPECT_TRUE(link.collisions.at(0).shape.size.isApprox(Vector3(0.4, 0.4, 0.2), 1e-5));
  EXPECT_NEAR(link.collisions[0].poseInLink.translation().norm(), 0, 1e-6);
}

TEST(PublicModelsContents, aStaticMeshIsSolidAsItsTriangles) {
  const auto scene = opened("world_on_a_mesh.sdf");
  ASSERT_TRUE(scene);
  const Shape& shape = modelOf(*scene, "stage").type->links.at(0).collisions.at(0).shape;
  EXPECT_EQ(shape.kind, Shape::Kind::kMesh);
  EXPECT_EQ(shape.mesh->triangles.size(), 12U);
}

TEST(PublicModelsContents, modelsInModelsBecomeOneWithScopedNames) {
  const auto scene = opened("models_in_models.sdf");
  ASSERT_TRUE(scene);
  const ModelDescription& type = *modelOf(*scene, "models_in_models").type;
  std::vector<std::string> links, joints;
  for (const auto& link : type.links) links.push_back(link.name);
  for (const auto& joint : type.joints) joints.push_back(joint.name);
  EXPECT_THAT(links, ElementsAre("foot", "tower::lower", "tower::top::upper"));
  EXPECT_THAT(joints, UnorderedElementsAre("base", "tower::glue"));
  EXPECT_NEAR(type.links[2].poseInModel.translation().z(), 0.5, 1e-12);
}

TEST(PublicModelsContents, includedModelsInAModelAreJoined) {
  const auto scene = opened("includes_in_a_model.sdf");
  ASSERT_TRUE(scene);
  const ModelDescription& type = *modelOf(*scene, "includes_in_a_model").type;
  EXPECT_EQ(type.links.size(), 5U);
  ASSERT_EQ(type.joints.size(), 4U);
  EXPECT_TRUE(type.joints[0].axisInModel.isApprox(Vector3::UnitY(), 1e-6));
  EXPECT_EQ(type.joints[0].damping, 0.05);
}

TEST(PublicModelsContents, aPlacementFrameIsWhereThePoseIs) {
  const auto scene = opened("placement_frame.sdf");
  ASSERT_TRUE(scene);
  const ModelDescription& type = *modelOf(*scene, "placement_frame").type;
  EXPECT_TRUE(type.links.at(1).poseInModel.translation().isApprox(Vector3(0.1, 0, 0.12), 1e-9));
}

TEST(PublicModelsContents, framesOfTheWorldPlaceIncludedModels) {
  const auto scene = opened("world_of_frames.sdf");
  ASSERT_TRUE(scene);
  EXPECT_TRUE(modelOf(*scene, "can").poseInWorld.translation().isApprox(Vector3(0.3, 0, 1.2), 1e-9));
  EXPECT_TRUE(modelOf(*scene, "tin").poseInWorld.translation().isApprox(Vector3(0.3, 0.5, 1.2), 1e-9));
}

TEST(PublicModelsContents, aCycleIsClosedByItsLastJoint) {
  const auto scene = opened("joint_cycle.sdf");
  ASSERT_TRUE(scene);
  const auto& joints = modelOf(*scene, "joint_cycle").type->joints;
  ASSERT_EQ(joints.size(), 4U);
  EXPECT_EQ(std::ranges::count(joints, true, &JointDescription::closesCycle), 1);
  EXPECT_EQ(joints.back().name, "d");
}

TEST(PublicModelsContents, jointsHaveTheirKinds) {
  const auto kindOf = [](const std::string& name) {
    const auto scene = opened(name + ".sdf");
    return scene ? modelOf(*scene, name).type->joints.at(0).kind : JointDescription::Kind::kFixed;
  };
  EXPECT_EQ(kindOf("joint_prismatic"), JointDescription::Kind::kSlider);
  EXPECT_EQ(kindOf("joint_ball"), JointDescription::Kind::kBall);
  EXPECT_EQ(kindOf("joint_universal"), JointDescription::Kind::kUniversal);
  EXPECT_EQ(kindOf("joint_revolute"), JointDescription::Kind::kHinge);
}

TEST(PublicModelsContents, lightsHaveTheirKinds) {
  const auto scene = opened("world_of_lights.sdf");
  ASSERT_TRUE(scene);
  const auto& lamps = scene->contents().world.lamps;
  ASSERT_EQ(lamps.size(), 3U);
  EXPECT_EQ(lamps[0].kind, Lamp::Kind::kDirectional);
  EXPECT_NEAR(lamps[0].direction.norm(), 1, 1e-6);
  EXPECT_EQ(lamps[1].kind, Lamp::Kind::kSpot);
  EXPECT_FLOAT_EQ(lamps[1].outerAngle, 0.8F);
  EXPECT_EQ(lamps[2].kind, Lamp::Kind::kPoint);
}

TEST(PublicModelsContents, aLightIsIncludedLikeAModel) {
  const auto scene = opened("world_of_a_library.sdf");
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->contents().world.lamps.size(), 1U);
  EXPECT_EQ(scene->contents().world.lamps[0].kind, Lamp::Kind::kDirectional);
  EXPECT_NEAR(scene->contents().world.gravity.z(), -9.8, 1e-12);
}

TEST(PublicModelsContents, aUrdfIsAModel) {
  const auto scene = opened("gimbal.urdf");
  ASSERT_TRUE(scene);
  const ModelDescription& type = *modelOf(*scene, "gimbal").type;
  EXPECT_EQ(type.links.size(), 2U);
  ASSERT_EQ(type.joints.size(), 1U);
  EXPECT_EQ(type.joints[0].name, "pan");
}

TEST(PublicModelsContents, whatIsLeftOutIsNamed) {
  EXPECT_THAT(leftOutOf("box_of_1_2.sdf"), IsEmpty());
  EXPECT_THAT(leftOutOf("heightmap.sdf"), ElementsAre("<heightmap>"));
  EXPECT_THAT(leftOutOf("surface.sdf"),
              UnorderedElementsAre("<mu2> in <ode>", "<torsional> in <friction>", "<contact> in <surface>"));
  EXPECT_THAT(leftOutOf("scripts_and_plugins.sdf"),
              UnorderedElementsAre("<script> in <material>", "<plugin> in <model>"));
  EXPECT_THAT(leftOutOf("mesh_missing.sdf"), ElementsAre("mesh model://nowhere/lost.dae"));
  EXPECT_THAT(leftOutOf("no_mass.sdf"), ElementsAre("mass 0"));
  EXPECT_THAT(leftOutOf("odd_inertia.sdf"), ElementsAre("<inertia>"));
  EXPECT_THAT(leftOutOf("joint_unknown_types.sdf"), Contains("joint of type 'screw'"));
  EXPECT_THAT(leftOutOf("world_of_lights.sdf"), Contains("<include> of https://models.example.org/tree"));
  const auto sensors = leftOutOf("sensors.sdf");
  EXPECT_THAT(sensors, Contains("<gz_frame_id> in <sensor>"));
  EXPECT_THAT(sensors, Contains("sensor of type 'wireless_transmitter'"));
  EXPECT_THAT(sensors, Not(Contains(HasSubstr("magnetometer"))));
  const auto scene = opened("sensors.sdf");
  ASSERT_TRUE(scene);
  std::vector<std::string> names;
  for (const SensorDescription& sensor : modelOf(*scene, "sensors").type->sensors)
    names.push_back(sensor.name);
  EXPECT_THAT(names, ElementsAre("gps", "field", "color"));
}

TEST(PublicModelsContents, whatIsLeftOutHasItsPlace) {
  const auto scene = opened("surface.sdf");
  ASSERT_TRUE(scene);
  const auto& all = scene->leftOut();
  const auto found = std::ranges::find(all, "<contact> in <surface>", &LeftOut::what);
  ASSERT_NE(found, all.end());
  EXPECT_EQ(fs::path(found->where.file).filename(), "surface.sdf");
  EXPECT_EQ(found->where.line, 9);
  EXPECT_EQ(found->object, "surface/body/solid");
  EXPECT_THAT(found->why, HasSubstr("stiffness"));
}

}  // namespace
}  // namespace simcore
