// SPDX-License-Identifier: GPL-3.0-or-later
// Small files that would take all memory or all time are errors.
#include "simcore/world/WorldSize.h"

#include <gmock/gmock.h>

#include "simcore/Simulation.h"
#include "simcore/ranging/MeasureAhead.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kBoxModel =
    "<link name='l'><collision name='c'><geometry><box><size>1 1 1</size></box></geometry></collision>"
    "</link></model>";

std::string numberedBox(int number, double height) {
  return "\n<model name='box" + std::to_string(number) + "'><pose>0 0 " + std::to_string(height) +
         " 0 0 0</pose>" + kBoxModel;
}

std::string boxes(int count, double distance) {
  std::string text;
  for (int i = 0; i < count; ++i) text += numberedBox(i, 1 + i * distance);
  return worldAround(text);
}

class WorldSizeTest : public testing::Test {
 protected:
  std::shared_ptr<const Scene> load(const std::string& world) const {
    const auto scene = Scene::load(folder_.write("world.sdf", world));
    if (!scene) ADD_FAILURE() << describe(scene.error());
    return scene.value_or(nullptr);
  }

  const SceneFolder folder_;
};

TEST_F(WorldSizeTest, linksJointsSensorsAndShapesAreParts) {
  folder_.writeModel("leg", kSmallModel);
  const auto scene = load(worldAround("<include><uri>model://leg</uri></include>"));
  ASSERT_TRUE(scene);
  const ModelDescription& leg = *scene->world().models.at(0).type;
  std::size_t shapes = 0;
  for (const LinkDescription& link : leg.links) shapes += link.collisions.size() + link.visuals.size();
  EXPECT_GT(shapes, 1U);
  EXPECT_EQ(partCount(leg), 2 + 1 + 1 + shapes);
  EXPECT_EQ(firstTooMany(scene->world(), partCount(leg)), nullptr);
  EXPECT_EQ(firstTooMany(scene->world(), partCount(leg) - 1), scene->world().models.data());
}

TEST_F(WorldSizeTest, modelsThatIncludeEachOtherManyTimesAreTooMany) {
  // 2^10 links in each model that is included.
  const auto named = [](int level) { return "level" + std::to_string(level); };
  for (int level = 0; level < 10; ++level) {
    std::string twice;
    for (const char* name : {"a", "b"})
      twice += "<include><name>" + std::string(name) + "</name><uri>model://" + named(level + 1) +
               "</uri></include>";
    folder_.writeModel(named(level), "<sdf version='1.9'><model name='m'>" + twice + "</model></sdf>");
  }
  folder_.writeModel(named(10), "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>");
  std::string many;
  for (int i = 0; i < 200; ++i)
    many += "\n<include><name>n" + std::to_string(i) + "</name><uri>model://level0</uri></include>";
  const std::string errors = folder_.errorsOf(worldAround(many));
  EXPECT_THAT(errors, HasSubstr("world.sdf:199: with 'n195' the scene has more than 200000 links, joints"));
}

TEST_F(WorldSizeTest, tooManySolidsInOnePlaceCannotBeSimulated) {
  const auto scene = load(boxes(150, 0.001));
  ASSERT_TRUE(scene);
  const auto simulation = Simulation::create(scene, {});
  ASSERT_FALSE(simulation);
  EXPECT_THAT(simulation.error().describe(), HasSubstr("and so do too many others"));
  EXPECT_THAT(simulation.error().describe(), HasSubstr("world.sdf:1"));
}

TEST_F(WorldSizeTest, asManySolidsSideBySideAreSimulated) {
  const auto scene = load(boxes(300, 1.1));
  ASSERT_TRUE(scene);
  EXPECT_TRUE(Simulation::create(scene, {}));
}

TEST_F(WorldSizeTest, anImageHasNoMoreNumbersThanTheLargestCameraHasPixels) {
  const auto facettes = [](int size, int classes) {
    std::string text =
        "<model name='eye'><link name='l'>\n<sensor name='s' type='custom'><robotcontrol:facette>";
    for (const char* angle : {"azimuth", "elevation"}) {
      text += "<robotcontrol:" + std::string(angle) + ">-1 1 " + std::to_string(size) +
              "</robotcontrol:" + angle + ">";
    }
    for (int i = 0; i < classes; ++i)
      text += "<robotcontrol:class>c" + std::to_string(i) + "</robotcontrol:class>";
    return worldAround(text + "</robotcontrol:facette></sensor></link></model>");
  };
  const auto leftOutOf = [&](int size, int classes) {
    const auto scene = Scene::load(folder_.write("world.sdf", facettes(size, classes)));
    EXPECT_TRUE(scene);
    return scene ? (*scene)->leftOut() : LeftOuts();
  };
  EXPECT_TRUE(leftOutOf(4096, 4).empty());
  const LeftOuts left = leftOutOf(4096, 5);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].what, "sensor 's'");
  EXPECT_THAT(left[0].why,
              HasSubstr("an image's width times its height times its classes must be between 0 and"));
}

TEST_F(WorldSizeTest, anImageTakesMemoryOnlyWhereItIsMeasured) {
  const std::vector<std::size_t> sizes{std::size_t{1} << 50U, 2};
  MeasureAhead<float> images(nullptr, sizes);
  std::vector<float> values(2);
  images.read(
      1, 7, [](std::size_t) { return true; },
      [](std::size_t, std::size_t sensor, std::span<float> measured) {
        std::ranges::fill(measured, static_cast<float>(sensor));
      },
      values);
  EXPECT_EQ(values, (std::vector<float>{1, 1}));
}

}  // namespace
}  // namespace simcore
