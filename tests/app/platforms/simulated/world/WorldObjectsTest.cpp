// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/WorldObjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "app/platforms/simulated/scenetext/SceneFileText.h"
#include "robotcontrol/World.pb.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotcontrol::WorldObject;

const char* const kLift =
    R"(<sdf version="1.9" xmlns:robotcontrol="urn:robotcontrol:sdf"><world name="lift">
<light name="sun" type="directional"><pose>0 0 5 0 0 0.5</pose><direction>0 0 -1</direction></light>
<model name="lift"><pose>0 0 0.1 0 0 0</pose>
<link name="mast"><inertial><mass>5</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>
<collision name="c"><geometry><cylinder><radius>0.1</radius><length>0.2</length></cylinder></geometry></collision>
<sensor name="way" type="custom"><robotcontrol:odometry/></sensor><sensor name="imu" type="imu"/>
<sensor name="scan" type="gpu_lidar"><lidar><scan><horizontal><samples>3</samples><min_angle>-1</min_angle>
<max_angle>1</max_angle></horizontal></scan><range><min>0.1</min><max>5</max></range></lidar></sensor>
<sensor name="eye" type="camera"><camera><horizontal_fov>1</horizontal_fov>
<image><width>8</width><height>8</height></image></camera></sensor></link>
<link name="fork"><inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>
<collision name="c"><geometry><box><size>0.1 0.2 0.3</size></box></geometry></collision></link>
<link name="hand"><inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial></link>
<joint name="rail" type="prismatic"><parent>mast</parent><child>fork</child>
<axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>0.5</upper><velocity>0.2</velocity><effort>50</effort></limit></axis>
<robotcontrol:servo/></joint>
<link name="lid"><inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial></link>
<joint name="flap" type="revolute"><parent>mast</parent><child>lid</child>
<axis><xyz>0 1 0</xyz><dynamics><damping>0.1</damping><friction>0.2</friction></dynamics></axis></joint>
<joint name="wrist" type="revolute"><parent>fork</parent><child>hand</child>
<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper><velocity>2</velocity><effort>3</effort></limit></axis>
<robotcontrol:servo/></joint></model>
</world></sdf>)";

class WorldObjectsTest : public testing::Test {
 protected:
  void SetUp() override { read(kLift); }
  void read(const std::string& text) {
    const auto scene = simcore::Scene::load(folder_.write("lift.sdf", text));
    ASSERT_TRUE(scene.has_value()) << robotlink::describe(scene.error());
    const auto simulation = simcore::Simulation::create(*scene, {});
    ASSERT_TRUE(simulation.has_value());
    objects_ = worldObjects(**simulation);
  }
  const WorldObject& object(const std::string& path) const {
    static const WorldObject kNone;
    const auto found = std::ranges::find(objects_->objects(), path, &WorldObject::path);
    EXPECT_NE(found, objects_->objects().end()) << path;
    return found == objects_->objects().end() ? kNone : *found;
  }
  /// "0.2 m/s", the first number of a property with its unit; empty if there is no such property.
  std::string number(const std::string& path, const std::string& name) const {
    for (const auto& property : object(path).properties()) {
      if (property.name() != name || property.values().empty()) continue;
      std::ostringstream text;
      text << property.values(0) << ' ' << property.unit();
      return text.str();
    }
    return {};
  }

  /// The numbers of a property.
  std::string numbers(const std::string& path, const std::string& name) const {
    std::ostringstream text;
    for (const auto& property : object(path).properties()) {
      for (int i = 0; property.name() == name && i < property.values_size(); ++i)
        text << (i == 0 ? "" : " ") << property.values(i);
    }
    return text.str();
  }
  /// The same after it was written into the file and the scene was read again.
  std::string written(const std::string& path, const std::string& name, const std::string& value) {
    const auto& properties = object(path).properties();
    const auto found = std::ranges::find(properties, name, &robotcontrol::WorldProperty::name);
    if (found == properties.end()) return "there is no " + name;
    const auto text =
        withElement(kLift, found->file(), {found->element().begin(), found->element().end()}, value);
    if (!text) return text.error().describe();
    read(*text);
    return numbers(path, name);
  }

  const TestFolder folder_;
  std::shared_ptr<const robotcontrol::WorldObjects> objects_;
};

TEST_F(WorldObjectsTest, servosOfSlidersHaveSpeedsAndForces) {
  for (const char* path : {"lift/joint:rail", "lift/rail/request"}) {
    EXPECT_EQ(number(path, "maximum_speed"), "0.2 m/s") << path;
    EXPECT_EQ(number(path, "maximum_force"), "50 N") << path;
    EXPECT_EQ(number(path, "maximum_torque"), "") << path;
  }
  EXPECT_EQ(number("lift/joint:rail", "upper_limit"), "0.5 m");
}

TEST_F(WorldObjectsTest, sensorsOfJointsHaveTheRangeOfTheirJoint) {
  EXPECT_EQ(object("lift/wrist/position").port().minimum(), -1);
  EXPECT_EQ(object("lift/wrist/position").port().maximum(), 1);
  EXPECT_EQ(object("lift/rail/position").port().maximum(), 0.5);
  EXPECT_EQ(number("lift/wrist/position", "maximum"), "") << "it has a single number";
}

TEST_F(WorldObjectsTest, onlyWhatHasARangeHasOne) {
  EXPECT_EQ(object("lift/imu").port().maximum(), 0) << "of the acceleration nothing is known";
  EXPECT_EQ(object("lift/imu").port().unit(), "m/s^2");
  const auto& properties = object("lift/way").properties();
  const auto maximum = std::ranges::find(properties, "maximum", &robotcontrol::WorldProperty::name);
  ASSERT_NE(maximum, properties.end());
  EXPECT_EQ(maximum->values(0), 0) << "it may be anywhere";
  EXPECT_NEAR(maximum->values(2), 3.14159, 1e-5);
}

TEST_F(WorldObjectsTest, servosOfHingesHaveTorques) {
  for (const char* path : {"lift/joint:wrist", "lift/wrist/request"}) {
    EXPECT_EQ(number(path, "maximum_speed"), "2 rad/s") << path;
    EXPECT_EQ(number(path, "maximum_torque"), "3 N m") << path;
    EXPECT_EQ(number(path, "maximum_force"), "") << path;
  }
}

TEST_F(WorldObjectsTest, linksLieBelowTheJointThatMovesThem) {
  EXPECT_EQ(object("lift/link:mast").parent(), "lift");
  EXPECT_EQ(object("lift/joint:rail").parent(), "lift/link:mast");
  EXPECT_EQ(object("lift/link:fork").parent(), "lift/joint:rail");
  EXPECT_EQ(object("lift/link:hand").parent(), "lift/joint:wrist");
  EXPECT_EQ(object("lift/rail/request").parent(), "lift/joint:rail");
}

TEST_F(WorldObjectsTest, theMassOfAModelIsThatOfAllItsLinks) {
  EXPECT_EQ(number("lift", "mass"), "8 kg");
  EXPECT_EQ(number("lift/link:fork", "mass"), "1 kg");
}

TEST_F(WorldObjectsTest, inertiaDampingAndMotorsCanBeChangedInTheFile) {
  const auto place = [this](const std::string& path, const std::string& name) {
    for (const auto& property : object(path).properties()) {
      std::string steps = std::to_string(property.values_size());
      for (const std::string& step : property.element()) steps += " " + step;
      if (property.name() == name) return steps;
    }
    return std::string();
  };
  EXPECT_EQ(place("lift/link:fork", "inertia"),
            "6 instance[lift] link[fork] inertial inertia ixx,iyy,izz,ixy,ixz,iyz");
  EXPECT_EQ(number("lift/link:fork", "inertia"), "0.01 kg m^2");
  EXPECT_EQ(place("lift/link:fork", "linear_damping"), "1 instance[lift] link[fork] velocity_decay linear");
  EXPECT_EQ(place("lift/joint:rail", "maximum_speed"), "1 instance[lift] joint[rail] axis limit velocity");
  EXPECT_EQ(place("lift/joint:rail", "maximum_force"), "1 instance[lift] joint[rail] axis limit effort");
  EXPECT_EQ(place("lift/joint:rail", "damping"), "") << "it has a servo";
  EXPECT_EQ(place("lift/joint:flap", "damping"), "1 instance[lift] joint[flap] axis dynamics damping");
  EXPECT_EQ(number("lift/joint:flap", "friction"), "0.2 N m");
}

TEST_F(WorldObjectsTest, propertiesOfLampsAreFoundInTheFile) {
  const WorldObject& sun = object("light:sun");
  EXPECT_EQ(number("light:sun", "direction"), "0 ");
  ASSERT_FALSE(sun.properties().empty());
  EXPECT_EQ(sun.properties(0).file(), (folder_ / "lift.sdf").string());
  EXPECT_EQ(sun.properties(0).element(0), "light[sun]");
}

TEST_F(WorldObjectsTest, whereLampsAreAndWhatSensorsSeeIsWrittenIntoTheFile) {
  EXPECT_EQ(numbers("light:sun", "initial_pose"), "0 0 5 0 0 0.5");
  EXPECT_EQ(written("light:sun", "initial_pose", "1 2 3 0.1 0 0.2"), "1 2 3 0.1 0 0.2");
  EXPECT_EQ(numbers("lift/scan", "range"), "0.1 5");
  EXPECT_EQ(written("lift/scan", "range", "0.2 8"), "0.2 8");
  EXPECT_EQ(written("lift/scan", "angles", "-0.5 1.5"), "-0.5 1.5");
  EXPECT_EQ(numbers("lift/eye/image", "opening_angles"), "1 1");
  EXPECT_EQ(written("lift/eye/image", "opening_angles", "0.8 0.6"), "0.8 0.6");
}

}  // namespace
}  // namespace app
