// SPDX-License-Identifier: GPL-3.0-or-later
// What is said about scenes that have what this simulator has not, or that are wrong.
#include <gmock/gmock.h>

#include <algorithm>

#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A model with one link.
std::string bodyWith(const std::string& parts, const std::string& more = "") {
  return "<model name='m'><link name='l'>" + parts + "</link>" + more + "</model>";
}

std::string visualWith(const std::string& material,
                       const std::string& shape = "<box><size>1 1 1</size></box>") {
  return "<visual name='v'><geometry>" + shape + "</geometry><material>" + material + "</material></visual>";
}

std::string sensorOf(const std::string& type, const std::string& parts) {
  return "<sensor name='s' type='" + type + "'>" + parts + "</sensor>";
}

std::string cameraWith(const std::string& parts, const std::string& fov = "1") {
  return sensorOf("camera", "<camera><horizontal_fov>" + fov +
                                "</horizontal_fov><image><width>64</width><height>48</height></image>" +
                                parts + "</camera>");
}

/// Two links with a joint.
std::string jointed(const std::string& joint, const std::string& type = "revolute") {
  return bodyWith("", "<link name='k'/>\n<joint name='j' type='" + type +
                          "'><parent>l</parent><child>k</child>" + joint + "</joint>");
}

std::string axisWith(const std::string& limit) {
  return "<axis><xyz>0 0 1</xyz><limit>" + limit + "</limit></axis>";
}

class SceneMessages : public testing::Test {
 protected:
  /// What is left out of a world, one per line; its errors if it has some.
  std::string leftOutOf(const std::string& contents) const {
    const auto scene = Scene::load(folder_.write("world.sdf", worldAround(contents)));
    if (!scene) return "ERROR " + describe(scene.error());
    std::string text;
    for (const LeftOut& one : (*scene)->leftOut())
      text += std::to_string(one.where.line) + " " + one.object + ": " + one.what + ": " + one.why + "\n";
    return text;
  }
  std::string errorsOf(const std::string& contents) const { return folder_.errorsOf(worldAround(contents)); }

  const SceneFolder folder_;
};

TEST_F(SceneMessages, allThatIsNotReadIsTold) {
  EXPECT_THAT(leftOutOf(bodyWith(cameraWith("<lens><type>stereographic</type></lens>"))),
              HasSubstr("3 test/m/l/s: <lens> in <camera>: "));
  EXPECT_THAT(leftOutOf(bodyWith(cameraWith("<visibility_mask>3</visibility_mask>"))),
              HasSubstr("<visibility_mask> in <camera>"));
  EXPECT_THAT(leftOutOf(bodyWith(cameraWith("<segmentation_type>instance</segmentation_type>"))),
              HasSubstr("<segmentation_type> in <camera>: the simulator has nothing like it"));
  EXPECT_THAT(leftOutOf(bodyWith(cameraWith("<save enabled='true'><path>p</path></save>"))),
              HasSubstr("<save> in <camera>"));
  EXPECT_THAT(leftOutOf(bodyWith(cameraWith("<clip><near>0.5</near><far>9</far></clip>"))),
              HasSubstr("<clip> of a camera: color cameras see at any distance"));
  EXPECT_THAT(leftOutOf(bodyWith(sensorOf("imu", "<imu><angular_velocity/><linear_acceleration/></imu>"))),
              HasSubstr("<angular_velocity> beside <linear_acceleration> in <imu>"));
  EXPECT_THAT(leftOutOf("<light type='point' name='p'><attenuation><range>9</range><linear>0.5</linear>"
                        "</attenuation></light>"),
              AllOf(HasSubstr("<range> in <attenuation>"), HasSubstr("<linear> in <attenuation>")));
  EXPECT_THAT(leftOutOf("<light type='point' name='p'><cast_shadows>false</cast_shadows></light>"),
              HasSubstr("<cast_shadows> in <light>: all lights have shadows"));
  EXPECT_THAT(leftOutOf("<scene><ambient>0.1 0.2 0.3 1</ambient></scene>"),
              HasSubstr("the color of <ambient>"));
  EXPECT_THAT(leftOutOf(bodyWith(visualWith("<ambient>1 0 0 1</ambient>"))),
              HasSubstr("<ambient> in <material>"));
  EXPECT_THAT(leftOutOf(bodyWith(visualWith("<diffuse>1 0 0 0.5</diffuse>"))),
              HasSubstr("everything is opaque"));
  EXPECT_THAT(leftOutOf(jointed(axisWith("<stiffness>100</stiffness>"))),
              HasSubstr("<stiffness> in <limit>"));
  EXPECT_THAT(leftOutOf(jointed(axisWith("<lower>1</lower><upper>2</upper>"))),
              HasSubstr("it starts at 0, outside its stops"));
  EXPECT_THAT(leftOutOf(jointed(axisWith("<lower>-1</lower><upper>1</upper>"), "ball")),
              HasSubstr("<axis> of a ball joint"));
  EXPECT_THAT(leftOutOf(bodyWith(
                  "", "<static>false</static><model name='n'><static>true</static><link name='x'/></model>")),
              HasSubstr("<static> of a model in a model"));
}

TEST_F(SceneMessages, whatSaysWhatIsSoAnywayIsNotTold) {
  EXPECT_EQ(leftOutOf(bodyWith(cameraWith("<visibility_mask>4294967295</visibility_mask>"
                                          "<save enabled='false'><path>p</path></save>"
                                          "<clip><near>0.01</near><far>300</far></clip>"))),
            "");
  EXPECT_EQ(leftOutOf("<light type='directional' name='sun'><attenuation><range>1000</range><constant>0.9"
                      "</constant></attenuation></light>"),
            "");
  EXPECT_EQ(leftOutOf(jointed(axisWith("<stiffness>1e+8</stiffness><dissipation>1</dissipation>"))), "");
  EXPECT_EQ(leftOutOf(bodyWith(visualWith("<ambient>1 0 0 1</ambient><diffuse>1 0 0 1</diffuse>"))), "");
}

TEST_F(SceneMessages, sensorsOfOtherTypesAreLeftOut) {
  for (const char* type :
       {"thermal_camera", "wide_angle_camera", "boundingbox_camera", "air_speed", "none"}) {
    EXPECT_THAT(leftOutOf(bodyWith(sensorOf(type, "<camera/>"))),
                HasSubstr("3 test/m/l/s: sensor of type '" + std::string(type) + "': of sensors, camera, "));
  }
  EXPECT_THAT(leftOutOf(bodyWith(sensorOf("camra", ""))), HasSubstr("; is 'camera' meant?"));
  EXPECT_THAT(leftOutOf(bodyWith(sensorOf("contact", "<contact/>"))),
              AllOf(HasSubstr("its <contact> has no <collision>"), Not(HasSubstr("__default__"))));
  EXPECT_THAT(leftOutOf(bodyWith(visualWith("", "<mesh/>"))), HasSubstr("<mesh>: it has no <uri>"));
  EXPECT_THAT(leftOutOf(bodyWith(visualWith("", "<torus><radius>1</radius></torus>"))),
              HasSubstr("3 m/l/v: <torus>: only box, "));
}

TEST_F(SceneMessages, aStaticModelHasADistanceSensor) {
  EXPECT_EQ(leftOutOf(bodyWith(sensorOf("lidar",
                                        "<lidar><scan><horizontal><samples>1</samples></horizontal></scan>"
                                        "<range><min>0</min><max>2</max></range></lidar>"),
                               "<static>true</static>")),
            "");
}

TEST_F(SceneMessages, onlyOneWorldOfAFileIsRead) {
  const auto scene = Scene::load(folder_.write("two.sdf",
                                               "<sdf version='1.9'>\n<world name='a'/>\n<world "
                                               "name='b'/><model name='c'><link name='l'/></model></sdf>"));
  ASSERT_TRUE(scene) << describe(scene.error());
  ASSERT_EQ((*scene)->leftOut().size(), 2U);
  EXPECT_EQ((*scene)->leftOut()[0].where.line, 3);
  EXPECT_EQ((*scene)->leftOut()[0].why, "only one world or model per file is read, here <world name=\"a\">");
}

TEST_F(SceneMessages, errorsOfLibsdformatHaveTheirPlace) {
  EXPECT_THAT(errorsOf(jointed("<axis/>", "hinge")),
              HasSubstr("world.sdf:4: test/m/j: there is no <joint> of type 'hinge'; there are revolute, "));
  EXPECT_EQ(errorsOf(jointed("<axis><xyz>0 0 0</xyz></axis>")),
            "world.sdf:4: test/m/j: an axis must be a vector that is not 0 0 0");
  EXPECT_EQ(errorsOf("\n<light name='x' type='laser'/>"),
            "world.sdf:4: test/x: there is no <light> of type 'laser'; there are point, directional, spot");
  EXPECT_EQ(errorsOf("<model name=''><link name='l'/></model>"),
            "world.sdf:3: test: <model> needs the attribute 'name'");
  EXPECT_EQ(errorsOf(bodyWith("\n<sensor name='s'/>")),
            "world.sdf:4: test/m/l/s: <sensor> needs the attribute 'type'");
  EXPECT_EQ(errorsOf(bodyWith("\n<pose relative_to='nope'>0 0 0 0 0 0</pose>")),
            "world.sdf:4: test/m/l: there is no frame 'nope' here, which relative_to names");
  EXPECT_EQ(errorsOf(bodyWith("") + "\n<frame name='f' attached_to='mm'/>"),
            "world.sdf:4: test/f: there is no frame 'mm' here, which attached_to names; is 'm' meant?");
  EXPECT_EQ(errorsOf("<model name='m' canonical_link='x'><link name='l'/></model>"),
            "world.sdf:3: test/m: there is no frame 'x' here, which canonical_link names; is 'l' meant?");
}

TEST_F(SceneMessages, oneErrorDoesNotHideOthers) {
  const auto camera = [](const std::string& height) {
    return sensorOf("camera",
                    "<camera><horizontal_fov>7</horizontal_fov>\n<image><width>1</width><height>" + height +
                        "</height></image>\n<clip><near>5</near><far>1</far></clip><robotcontrol:exposure>7"
                        "</robotcontrol:exposure></camera>");
  };
  EXPECT_THAT(errorsOf(bodyWith(camera("-3") + camera("-3") + sensorOf("flux", ""))),
              AllOf(HasSubstr("<height> must be a whole number from 0 on, not '-3'"),
                    HasSubstr("the name 's' appears here twice")));
  EXPECT_THAT(
      leftOutOf(bodyWith(camera("3"))),
      AllOf(HasSubstr("sensor 's': an image's width must be"),
            HasSubstr("sensor 's': horizontal_fov must be"), HasSubstr("<robotcontrol:exposure>: "),
            HasSubstr("5 m/l/s: sensor 's': <near> of <clip> must be at least 0 and below its <far>")));
  EXPECT_EQ(errorsOf("\n<gravity>0 0 -2000</gravity>"),
            "world.sdf:4: test: gravity must be below 1000 m/s^2");
  EXPECT_EQ(errorsOf(bodyWith("<inertial><mass>-1</mass></inertial>")),
            "world.sdf:3: test/m/l: <mass> must be between 0 and 1e+09 kg, not -1");
  EXPECT_EQ(errorsOf(bodyWith(visualWith("<diffuse>5 0 -1 1</diffuse>"))),
            "world.sdf:3: test/m/l/v: the numbers of <diffuse> must be between 0 and 1, not '5 0 -1 1'");
}

TEST_F(SceneMessages, aSensorThatCannotBeHadIsLeftOutAlone) {
  EXPECT_EQ(leftOutOf(bodyWith("\n" + cameraWith("", "7"))),
            "4 m/l/s: sensor 's': horizontal_fov must be between 0.01 and 3, not 7\n");
  EXPECT_EQ(leftOutOf(bodyWith(sensorOf("gpu_lidar", ""))),
            "3 m/l/s: sensor 's': a lidar must say in <lidar> where it measures\n");
  EXPECT_EQ(leftOutOf(bodyWith(sensorOf("sonar", ""))),
            "3 m/l/s: sensor 's': a sonar must say in <sonar> where it measures\n");
  EXPECT_EQ(leftOutOf(bodyWith(sensorOf("camera", "<update_rate>1000</update_rate><camera/>"))),
            "3 m/l/s: update_rate above 250: the sensor has 250 Hz\n");
  EXPECT_EQ(
      leftOutOf(bodyWith(sensorOf("sonar",
                                  "<sonar><geometry>sphere</geometry><min>0</min><max>2</max>"
                                  "<radius>0.3</radius></sonar>"))),
      "3 m/l/s: <geometry> sphere of a sonar: it measures in a cone whose radius is that at its <max>\n");
}

TEST_F(SceneMessages, namesThatArePartsOfPathsHaveNoSlash) {
  EXPECT_EQ(errorsOf("<model name='a/b'><link name='l'/></model>"),
            "world.sdf:3: test/a/b: the name 'a/b' must not contain a slash, which separates the parts of a "
            "path: MODEL/SENSOR");
  EXPECT_THAT(
      errorsOf(bodyWith("<sensor name='x/y' type='imu'/>", "<link name='k/'/>")),
      AllOf(HasSubstr("the name 'x/y' must not contain a slash"), HasSubstr("the name 'k/' must not")));
  EXPECT_EQ(errorsOf("<model name='a b::c'><link name='l m'/></model>"), "");
  EXPECT_EQ(errorsOf(bodyWith(visualWith("<diffuse>1 0 0</diffuse>"))), "");
}

TEST_F(SceneMessages, ourOwnElementsAreCheckedAsAWhole) {
  const auto own = [&](const std::string& parts) { return errorsOf(bodyWith("", parts)); };
  EXPECT_EQ(own("<robotcontrol:ball>maybe</robotcontrol:ball>"),
            "world.sdf:3: test/m: <robotcontrol:ball> must be true or false, not 'maybe'");
  EXPECT_THAT(own("<robotcontrol:home teem='red'>0 0 0</robotcontrol:home>"),
              HasSubstr("<robotcontrol:home> has no attribute 'teem'; is 'team' meant?"));
  EXPECT_THAT(own("<robotcontrol:guided kind='free'/><robotcontrol:guided kind='omni'/>"),
              HasSubstr("there is another <robotcontrol:guided> in this <model>"));
  EXPECT_EQ(own("<robotcontrol:home>0 0 0</robotcontrol:home><robotcontrol:home>1 0 0</robotcontrol:home>"),
            "");
  EXPECT_EQ(errorsOf(bodyWith("<robotcontrol:emitter/>")),
            "world.sdf:3: m/l: an emitter needs a <robotcontrol:intensity class=\"...\">: what it emits");
  for (const char* type : {"ball", "fixed"}) {
    EXPECT_EQ(errorsOf(jointed("<robotcontrol:speed_sensor/>", type)),
              "world.sdf:4: m/j: only a revolute, continuous or prismatic joint can have a "
              "<robotcontrol:speed_sensor>");
  }
  const std::string servo =
      axisWith("<lower>0</lower><upper>1</upper><effort>9</effort><velocity>1</velocity>") +
      "<robotcontrol:servo/>";
  EXPECT_THAT(errorsOf(jointed(servo + "<robotcontrol:door><robotcontrol:open>0</robotcontrol:open>"
                                       "</robotcontrol:door>")),
              HasSubstr("<robotcontrol:open> is the position where the door is closed"));
}

TEST_F(SceneMessages, theNamespaceCountsAndNotItsPrefix) {
  const auto scene = Scene::load(
      folder_.write("world.sdf", "<sdf version='1.9' xmlns:rc='urn:robotcontrol:sdf'><world name='w'>" +
                                     bodyWith("", "<rc:ball>true</rc:ball>") + "</world></sdf>"));
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ((*scene)->balls(), std::vector<std::string>{"m"});
}

TEST_F(SceneMessages, aRoleIsGoalie) {
  folder_.writeModel("small", kSmallModel);
  EXPECT_EQ(
      errorsOf("<include><uri>model://small</uri><robotcontrol:role>emperor</robotcontrol:role></include>"),
      "world.sdf:3: 'small': the <robotcontrol:role> must be goalie, or be omitted, so that the team "
      "decides; not 'emperor'");
}

TEST_F(SceneMessages, aDriveCannotPushWhenItMovesKinematically) {
  EXPECT_THAT(errorsOf("<include><uri>model://p3at</uri><robotcontrol:motion objects='push'>kinematic"
                       "</robotcontrol:motion></include>"),
              HasSubstr("stops at objects when it moves kinematically"));
}

TEST_F(SceneMessages, aDistortionCanBeInverted) {
  const auto lens = [&](const std::string& k1) {
    return leftOutOf(bodyWith(cameraWith("<distortion><k1>" + k1 + "</k1></distortion>", "1.2")));
  };
  EXPECT_THAT(lens("-5"), HasSubstr("m/l/s: sensor 's': no lens has this <distortion>"));
  EXPECT_EQ(lens("-0.3"), "");
  EXPECT_EQ(lens("0.5"), "");
}

TEST_F(SceneMessages, theBallBringsItsColor) {
  EXPECT_EQ(errorsOf("<include><uri>model://ball</uri></include>"), "");
  const auto scene = Scene::load(folder_.write(
      "world.sdf",
      worldAround("<robotcontrol:palette><robotcontrol:color name='orange'>1 2 3</robotcontrol:color>"
                  "</robotcontrol:palette><include><uri>model://ball</uri></include>")));
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ((*scene)->contents().world.models.at(0).type->links.at(0).visuals.at(0).color, (Rgb{1, 2, 3}))
      << "the world's color goes before the model's";
}

TEST_F(SceneMessages, aUrdfIsToldAboutInItsOwnLines) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
  const auto robot = [&](const std::string& contents) {
    return folder_.write("r.urdf", "<robot name='r'>\n<link name='a'>" + inertial +
                                       "</link>\n<link name='b'>" + inertial + "</link>\n" + contents +
                                       "</robot>");
  };
  const auto joint = [](const std::string& type, const std::string& parts) {
    return "<joint name='j' type='" + type + "'><parent link='a'/><child link='b'/>" + parts + "</joint>\n";
  };
  for (const char* type : {"floating", "planar"}) {
    const auto scene = Scene::load(robot(joint(type, "<origin xyz='0 0 2'/>")));
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_EQ((*scene)->leftOut().size(), 1U);
    EXPECT_EQ((*scene)->leftOut()[0].what, "joint of type '" + std::string(type) + "'");
    EXPECT_EQ((*scene)->leftOut()[0].where.line, 4);
    const ModelDescription& type_ = *(*scene)->contents().world.models.back().type;
    EXPECT_THAT(type_.joints, IsEmpty());
    ASSERT_EQ(type_.links.size(), 2U);
    EXPECT_NEAR(std::abs(type_.links[1].poseInModel.translation().z()), 2, 1e-9);
  }
  const auto scene =
      Scene::load(robot(joint("continuous", "<mimic joint='x'/>\n<safety_controller/>") +
                        "<transmission name='t'/>\n<gazebo><plugin name='p' filename='p.so'/></gazebo>"));
  ASSERT_TRUE(scene) << describe(scene.error());
  std::vector<std::pair<std::string, int>> told;
  for (const LeftOut& one : (*scene)->leftOut()) told.emplace_back(one.what, one.where.line);
  EXPECT_THAT(told, testing::IsSupersetOf({std::pair<std::string, int>("<mimic> in <joint>", 4),
                                           {"<safety_controller> in <joint>", 5},
                                           {"<transmission> in <robot>", 6}}));
  const auto errorsOfRobot = [&](const std::string& contents) {
    const auto wrong = Scene::load(robot(contents));
    return wrong ? std::string() : describe(wrong.error());
  };
  EXPECT_THAT(
      errorsOfRobot(joint("revolute", "")),
      HasSubstr("r.urdf:4: r/j: a joint of type 'revolute' needs a <limit>; without stops its type is "));
  EXPECT_THAT(errorsOfRobot(joint("wobble", "")),
              HasSubstr("r.urdf:4: r/j: there is no joint of type 'wobble'"));
}

}  // namespace
}  // namespace simcore
