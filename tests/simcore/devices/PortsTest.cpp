// SPDX-License-Identifier: GPL-3.0-or-later
// What of a world can be read and commanded, and how the parts behind it are numbered.
#include "simcore/devices/Ports.h"

#include <gmock/gmock.h>

#include <utility>

namespace simcore {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

JointDescription jointTo(int child, int parent = 0,
                         JointDescription::Kind jointKind = JointDescription::Kind::kHinge) {
  JointDescription joint;
  joint.name = "joint" + std::to_string(child);
  joint.kind = jointKind;
  joint.parent = parent;
  joint.child = child;
  joint.lower = -0.5;
  joint.upper = 1.5;
  return joint;
}

JointDescription motorTo(int child, MotorControl::Kind control,
                         JointDescription::Kind jointKind = JointDescription::Kind::kHinge) {
  JointDescription joint = jointTo(child, 0, jointKind);
  joint.servo = true;
  joint.control.kind = control;
  joint.maximumSpeed = 3;
  joint.maximumTorque = 7;
  return joint;
}

SensorDescription sensorOf(SensorDescription::Kind sensorKind, const std::string& name, int onLink = 0) {
  SensorDescription sensor;
  sensor.kind = sensorKind;
  sensor.name = name;
  sensor.link = onLink;
  sensor.rate = 10;
  return sensor;
}

/// A model with this number of links.
ModelDescription modelOf(int links) {
  ModelDescription model;
  model.links.resize(static_cast<std::size_t>(links));
  return model;
}

ModelInstance instanceOf(const std::string& name, ModelDescription model) {
  ModelInstance instance;
  instance.name = name;
  instance.type = std::make_shared<const ModelDescription>(std::move(model));
  return instance;
}

/// What ports point to lives as long as the caller keeps the models.
Ports portsOfModels(std::vector<ModelInstance> models) {
  WorldDescription world;
  world.models = std::move(models);
  return Ports::of(world);
}

template <typename Device>
std::vector<std::string> pathsOf(const std::vector<Device>& devices) {
  std::vector<std::string> paths;
  for (const Device& device : devices) paths.push_back(device.info.path);
  return paths;
}

const SensorSource& sourceOf(const Ports& ports, const std::string& path) {
  for (std::size_t i = 0; i < ports.sensors.size(); ++i) {
    if (ports.sensors[i].info.path == path) return ports.sources[i];
  }
  ADD_FAILURE() << "there is no sensor " << path;
  static const SensorSource kNone;
  return kNone;
}

TEST(PortsTest, anEmptyWorldHasNone) {
  const Ports ports = portsOfModels({});
  EXPECT_THAT(ports.sensors, IsEmpty());
  EXPECT_THAT(ports.servos, IsEmpty());
  EXPECT_THAT(ports.guides, IsEmpty());
}

TEST(PortsTest, positionsOfJointsComeBeforeSensorsAndModelsInTheirOrder) {
  ModelDescription arm = modelOf(3);
  arm.joints = {jointTo(1), jointTo(2, 1, JointDescription::Kind::kSlider)};
  arm.joints[0].speedSensor.emplace();
  arm.joints[1].loadSensor.emplace();
  arm.sensors = {sensorOf(SensorDescription::Kind::kGyroscope, "gyro")};
  const Ports ports = portsOfModels({instanceOf("b", arm), instanceOf("a", arm)});
  EXPECT_THAT(
      pathsOf(ports.sensors),
      ElementsAre("b/joint1/position", "b/joint1/speed", "b/joint2/position", "b/joint2/load", "b/gyro",
                  "a/joint1/position", "a/joint1/speed", "a/joint2/position", "a/joint2/load", "a/gyro"));
  EXPECT_EQ(ports.sensors[1].info.unit, "rad/s");
  EXPECT_EQ(ports.sensors[2].info.unit, "m");
  EXPECT_EQ(ports.sensors[3].info.unit, "N") << "a slide exerts a force";
  EXPECT_EQ(ports.sensors[9].info.robot, "a");
  EXPECT_THAT(ports.sensors[4].info.shape, ElementsAre(3));
  EXPECT_EQ(ports.sensors[4].values.size(), 3U);
}

TEST(PortsTest, bodiesAndHingesAreNumberedThroughAllModelsThatMove) {
  ModelDescription arm = modelOf(3);
  arm.joints = {jointTo(1, 0, JointDescription::Kind::kFixed), jointTo(2, 1)};
  arm.sensors = {sensorOf(SensorDescription::Kind::kAccelerometer, "shake", 2),
                 sensorOf(SensorDescription::Kind::kCamera, "eye", 1)};
  ModelDescription wall = modelOf(5);
  wall.isStatic = true;
  wall.joints = {jointTo(1)};
  const Ports ports =
      portsOfModels({instanceOf("first", arm), instanceOf("wall", wall), instanceOf("next", arm)});
  EXPECT_EQ(sourceOf(ports, "first/shake").body, 2U);
  EXPECT_EQ(sourceOf(ports, "next/shake").body, 5U) << "a wall has no body";
  EXPECT_EQ(sourceOf(ports, "first/joint2/position").hinge, 0U) << "a fixed joint is no hinge";
  EXPECT_EQ(sourceOf(ports, "next/joint2/position").hinge, 1U);
  EXPECT_EQ(sourceOf(ports, "next/shake").model, 2);
  // Drawn bodies begin with the world.
  ASSERT_EQ(ports.cameras.size(), 2U);
  EXPECT_EQ(ports.cameras[0].body, 2);
  EXPECT_EQ(ports.cameras[1].body, 5);
}

TEST(PortsTest, aModelThatNeverMovesHasOnlySensorsThatLookAroundAndTheyAreThoseOfTheWorld) {
  ModelDescription tower = modelOf(1);
  tower.isStatic = true;
  tower.links[0].poseInModel = Pose3(Eigen::Translation3d(0, 0, 2));
  tower.sensors = {sensorOf(SensorDescription::Kind::kCamera, "eye"),
                   sensorOf(SensorDescription::Kind::kLaser, "laser"),
                   sensorOf(SensorDescription::Kind::kAccelerometer, "shake")};
  tower.sensors[0].poseInLink = Pose3(Eigen::Translation3d(0, 0, 0.5));
  ModelInstance instance = instanceOf("tower", tower);
  instance.poseInWorld = Pose3(Eigen::Translation3d(7, 0, 0));
  const Ports ports = portsOfModels({instance});
  EXPECT_THAT(ports.sensors, IsEmpty());
  ASSERT_EQ(ports.cameras.size(), 1U);
  EXPECT_EQ(ports.cameras[0].body, 0);
  EXPECT_TRUE(ports.cameras[0].cameraInBody.translation().isApprox(Vector3(7, 0, 2.5)));
  ASSERT_EQ(ports.ranges.size(), 1U);
  EXPECT_EQ(ports.rangeOwners[0].first, ports.rangeOwners[0].last) << "it sees its own tower";
}

TEST(PortsTest, aCommandHasTheNameUnitAndLimitsOfItsMotor) {
  using Kind = MotorControl::Kind;
  constexpr auto kSlider = JointDescription::Kind::kSlider;
  ModelDescription arm = modelOf(7);
  arm.joints = {motorTo(1, Kind::kPosition),
                motorTo(2, Kind::kVelocity),
                motorTo(3, Kind::kTorque),
                motorTo(4, Kind::kPosition, kSlider),
                motorTo(5, Kind::kVelocity, kSlider),
                motorTo(6, Kind::kTorque, kSlider)};
  arm.joints[0].initialAngle = 0.25;
  arm.joints[1].initialAngle = 0.25;
  const Ports ports = portsOfModels({instanceOf("arm", arm)});
  EXPECT_THAT(pathsOf(ports.servos),
              ElementsAre("arm/joint1/request", "arm/joint2/speed_request", "arm/joint3/torque_request",
                          "arm/joint4/request", "arm/joint5/speed_request", "arm/joint6/force_request"));
  const std::vector<std::string> units = {"rad", "rad/s", "N m", "m", "m/s", "N"};
  const double limits[] = {1.5, 3, 7, 1.5, 3, 7};
  for (std::size_t i = 0; i < units.size(); ++i) {
    EXPECT_EQ(ports.servos[i].info.unit, units[i]) << i;
    EXPECT_EQ(ports.servos[i].maximum, limits[i]) << i;
    EXPECT_EQ(ports.servos[i].info.maximum, limits[i]) << i;
    EXPECT_EQ(ports.servos[i].info.minimum, i % 3 == 0 ? -0.5 : -limits[i]) << i;
  }
  EXPECT_EQ(ports.servoStates[0].target, 0.25) << "a servo holds what it starts with";
  EXPECT_EQ(ports.servoStates[1].target, 0) << "a speed has nothing to do with the angle";
}

TEST(PortsTest, aServoMovesTheLinksBelowItsJointButNotThoseOnTheOtherSideOfACycle) {
  ModelDescription arm = modelOf(5);
  // 0 - 1 - 2 - 3, and 4 beside them; the last joint closes a cycle.
  arm.joints = {motorTo(1, MotorControl::Kind::kPosition), jointTo(2, 1), jointTo(3, 2), jointTo(4, 0),
                jointTo(4, 3)};
  arm.joints.back().closesCycle = true;
  const Ports ports = portsOfModels({instanceOf("box", modelOf(2)), instanceOf("arm", arm)});
  ASSERT_EQ(ports.servoBodies.size(), 1U);
  EXPECT_THAT(ports.servoBodies[0], ElementsAre(3U, 4U, 5U));
  EXPECT_THAT(ports.servoModels, ElementsAre(1));
}

TEST(PortsTest, aForceSensorFindsItsHingeBehindJointsThatHaveNone) {
  ModelDescription arm = modelOf(4);
  arm.joints = {jointTo(1), jointTo(2, 1, JointDescription::Kind::kBall), jointTo(3, 2)};
  arm.sensors = {sensorOf(SensorDescription::Kind::kForceTorque, "wrist", 3)};
  arm.sensors[0].joint = 2;
  arm.sensors[0].towardsParent = true;
  const Ports ports = portsOfModels({instanceOf("a", arm), instanceOf("b", arm)});
  EXPECT_EQ(sourceOf(ports, "a/wrist").hinge, 1U);
  EXPECT_EQ(sourceOf(ports, "b/wrist").hinge, 3U);
  EXPECT_EQ(sourceOf(ports, "b/wrist").sign, -1);
}

TEST(PortsTest, aDoorFindsTheSensorOfItsOwnModelThatOpensIt) {
  const auto doorWith = [](const std::string& sensor) {
    ModelDescription gate = modelOf(2);
    gate.joints = {motorTo(1, MotorControl::Kind::kPosition)};
    gate.joints[0].door = DoorDescription{.sensor = sensor};
    gate.sensors = {sensorOf(SensorDescription::Kind::kSonar, "sonar"),
                    sensorOf(SensorDescription::Kind::kSwitch, "mat"),
                    sensorOf(SensorDescription::Kind::kDistance, "beam")};
    const Ports ports = portsOfModels({instanceOf("other", gate), instanceOf("gate", gate)});
    EXPECT_EQ(ports.doors[1].info.path, "gate/joint1/door");
    EXPECT_EQ(ports.doors[1].servo, 1U);
    return std::pair(ports.doors[1].sensor, ports);
  };
  const auto [mat, withMat] = doorWith("mat");
  EXPECT_EQ(mat.kind, DoorSensor::Kind::kNumber);
  EXPECT_EQ(withMat.sensors[mat.index].info.path, "gate/mat");
  EXPECT_TRUE(mat.isContact);
  EXPECT_FALSE(doorWith("beam").first.isContact);
  const auto [sonar, withSonar] = doorWith("sonar");
  EXPECT_EQ(sonar.kind, DoorSensor::Kind::kRange);
  EXPECT_EQ(withSonar.ranges[sonar.index].info.path, "gate/sonar");
  EXPECT_EQ(doorWith("").first.kind, DoorSensor::Kind::kNone);
  EXPECT_EQ(doorWith("mouse").first.kind, DoorSensor::Kind::kNone);
}

TEST(PortsTest, aGuideTakesWhatItsKindOfMotionNeeds) {
  using Kind = GuidedMotion::Kind;
  const auto guideOf = [](Kind kind) {
    ModelDescription model = modelOf(1);
    model.guided.emplace().kind = kind;
    model.guided->maximumSpeed = 0.5;
    model.guided->maximumRate = 2;
    return portsOfModels({instanceOf("m", model)}).guides.at(0).info;
  };
  EXPECT_THAT(guideOf(Kind::kFree).shape, ElementsAre(6));
  EXPECT_THAT(guideOf(Kind::kOmni).shape, ElementsAre(3));
  EXPECT_THAT(guideOf(Kind::kDifferential).shape, ElementsAre(2));
  EXPECT_EQ(guideOf(Kind::kSkid).unit, "m/s");
  EXPECT_EQ(guideOf(Kind::kAckermann).unit, "m/s, rad");
  EXPECT_EQ(guideOf(Kind::kAckermann).path, "m/motion");
  EXPECT_EQ(guideOf(Kind::kFree).maximum, 2) << "the larger of speed and rate";
  EXPECT_EQ(guideOf(Kind::kFree).minimum, -2);
  EXPECT_EQ(guideOf(Kind::kDifferential).maximum, 0.5) << "both are speeds";
  EXPECT_EQ(guideOf(Kind::kAckermann).maximum, 0.6) << "the steering angle";
}

TEST(PortsTest, sensorsSayBetweenWhichValuesTheyRead) {
  using Kind = SensorDescription::Kind;
  ModelDescription arm = modelOf(4);
  arm.joints = {motorTo(1, MotorControl::Kind::kPosition), jointTo(2)};
  arm.joints[0].speedSensor.emplace();
  arm.joints[0].loadSensor.emplace();
  arm.joints[1].lower = -JointDescription::kFullTurn;
  arm.joints[1].upper = JointDescription::kFullTurn;
  arm.sensors = {sensorOf(Kind::kSwitch, "foot"), sensorOf(Kind::kBattery, "battery"),
                 sensorOf(Kind::kMagnetometer, "compass")};
  arm.sensors[1].battery.fullVoltage = 13;
  const Ports ports = portsOfModels({instanceOf("arm", arm)});
  const auto rangeOf = [&](const std::string& path) {
    const auto found =
        std::ranges::find(ports.sensors, path, [](const Sensor& each) { return each.info.path; });
    EXPECT_NE(found, ports.sensors.end()) << path;
    return std::pair(found->info.minimum, found->info.maximum);
  };
  EXPECT_EQ(rangeOf("arm/joint1/position"), std::pair(-0.5, 1.5));
  EXPECT_EQ(rangeOf("arm/joint1/speed"), std::pair(-3.0, 3.0));
  EXPECT_EQ(rangeOf("arm/joint1/load"), std::pair(-7.0, 7.0));
  EXPECT_EQ(rangeOf("arm/joint2/position"), std::pair(0.0, 0.0)) << "it turns freely";
  EXPECT_EQ(rangeOf("arm/foot"), std::pair(0.0, 1.0));
  EXPECT_EQ(rangeOf("arm/battery"), std::pair(0.0, 13.0));
  EXPECT_EQ(rangeOf("arm/compass"), std::pair(0.0, 0.0)) << "not known";
}

TEST(PortsTest, aVehicleIsCommandedByTorquesOnlyWhileForcesMoveIt) {
  ModelDescription car = modelOf(2);
  car.joints = {jointTo(1)};
  car.joints[0].wheel = true;
  car.guided.emplace().kind = GuidedMotion::Kind::kAckermann;
  car.vehicle.emplace().byTorque = true;
  car.vehicle->wheels.resize(1);
  car.vehicle->wheels[0].driven = true;
  car.vehicle->wheels[0].maximumForce = 20;
  car.vehicle->wheels[0].radius = 0.3;
  ModelInstance kinematic = instanceOf("kinematic", car);
  kinematic.motion = MotionMode::kKinematic;
  const Ports ports = portsOfModels({instanceOf("pushed", car), kinematic});
  ASSERT_EQ(ports.guides.size(), 2U);
  EXPECT_EQ(ports.guides[0].info.unit, "N m, rad");
  EXPECT_EQ(ports.guides[0].info.maximum, 6) << "of the wheel, N m";
  EXPECT_EQ(ports.guideMeans[0].kind, GuideMeans::Kind::kWheels);
  EXPECT_EQ(ports.guides[1].info.unit, "m/s, rad");
  EXPECT_EQ(ports.guideMeans[1].kind, GuideMeans::Kind::kFollows);
  EXPECT_EQ(ports.guideMeans[1].firstWheel, 1U) << "wheels are numbered through all models";
  EXPECT_EQ(sourceOf(ports, "kinematic/joint1/position").hinge, 1U);
  EXPECT_EQ(sourceOf(ports, "kinematic/joint1/position").kind, SensorSource::Kind::kWheelAngle);
}

TEST(PortsTest, aRobotThatWalksIsGuidedOnlyWithoutForces) {
  ModelDescription robot = modelOf(1);
  robot.walk.emplace().name = "gait";
  ModelInstance walks = instanceOf("walks", robot);
  walks.motion = MotionMode::kStopping;
  ModelInstance isPushed = instanceOf("pushed", robot);
  isPushed.motion = MotionMode::kPhysics;
  const Ports ports = portsOfModels({isPushed, walks});
  EXPECT_THAT(pathsOf(ports.guides), ElementsAre("walks/gait"));
  EXPECT_THAT(ports.guides[0].info.shape, ElementsAre(3));
  EXPECT_NE(ports.guideMeans[0].walk, nullptr);
  EXPECT_THAT(ports.guideModels, ElementsAre(1));
}

TEST(PortsTest, aSensorThatIsNamedHasTheSameRandomNumbersWhateverElseIsInTheScene) {
  ModelDescription robot = modelOf(1);
  robot.sensors = {sensorOf(SensorDescription::Kind::kNavSat, "gps"),
                   sensorOf(SensorDescription::Kind::kBattery, "battery")};
  const Ports alone = portsOfModels({instanceOf("red1", robot)});
  const Ports both = portsOfModels({instanceOf("red0", robot), instanceOf("red1", robot)});
  const auto streamOf = [](const Ports& ports, const char* path) {
    return std::pair(sourceOf(ports, path).stream.domain, sourceOf(ports, path).stream.index);
  };
  EXPECT_EQ(streamOf(alone, "red1/gps"), streamOf(both, "red1/gps"));
  EXPECT_NE(streamOf(both, "red0/gps"), streamOf(both, "red1/gps"));
  EXPECT_NE(streamOf(both, "red1/battery"), streamOf(both, "red1/gps"));
}

TEST(PortsTest, imagesHaveAChannelForEachClassThatTheySense) {
  ModelDescription insect = modelOf(1);
  insect.sensors = {sensorOf(SensorDescription::Kind::kImage, "eye"),
                    sensorOf(SensorDescription::Kind::kImage, "depth"),
                    sensorOf(SensorDescription::Kind::kCamera, "camera")};
  insect.sensors[0].image.kind = ImageGeometry::Kind::kFacette;
  insect.sensors[0].image.classes = {"light", "smell"};
  insect.sensors[0].image.camera.width = 8;
  insect.sensors[0].image.camera.height = 4;
  insect.sensors[1].image.nearest = 0.2;
  insect.sensors[1].image.farthest = 5;
  insect.sensors[1].rate = 0;
  insect.sensors[2].width = 32;
  insect.sensors[2].height = 24;
  const Ports ports = portsOfModels({instanceOf("bee", insect)});
  EXPECT_THAT(pathsOf(ports.images), ElementsAre("bee/eye/image", "bee/depth/depth"));
  EXPECT_THAT(ports.images[0].info.shape, ElementsAre(4, 8, 2));
  EXPECT_EQ(ports.images[0].info.type, "facettes");
  EXPECT_EQ(ports.images[1].info.maximum, 5);
  EXPECT_EQ(ports.images[1].period, robotlink::Duration{}) << "on demand";
  EXPECT_EQ(ports.images[0].period, robotlink::fromSeconds(0.1));
  EXPECT_THAT(ports.cameras[0].info.shape, ElementsAre(24, 32, 3));
}

TEST(PortsTest, aLaserHasAReadingForEachDirectionAndASonarHasOne) {
  ModelDescription robot = modelOf(1);
  robot.sensors = {sensorOf(SensorDescription::Kind::kLaser, "laser"),
                   sensorOf(SensorDescription::Kind::kSonar, "sonar")};
  for (SensorDescription& sensor : robot.sensors) sensor.range.readings = 181;
  robot.sensors[0].maximum = 8;
  const Ports ports = portsOfModels({instanceOf("box", modelOf(2)), instanceOf("r", robot)});
  EXPECT_THAT(ports.ranges[0].info.shape, ElementsAre(181));
  EXPECT_THAT(ports.ranges[1].info.shape, IsEmpty());
  EXPECT_EQ(ports.ranges[1].readings, 1);
  EXPECT_EQ(ports.ranges[0].info.maximum, 8);
  // Its own bodies, which it does not see, as they are drawn.
  EXPECT_EQ(ports.rangeOwners[0].first, 3);
  EXPECT_EQ(ports.rangeOwners[0].last, 4);
}

TEST(PortsTest, odometryIsThatOfTheDriveOfItsOwnModel) {
  ModelDescription robot = modelOf(1);
  robot.sensors = {sensorOf(SensorDescription::Kind::kOdometry, "odometry")};
  ModelDescription driven = robot;
  driven.drive.emplace().track = 0.7;
  driven.drive->maximumSpeed = 1.5;
  const Ports ports =
      portsOfModels({instanceOf("first", driven), instanceOf("pushed", robot), instanceOf("second", driven)});
  EXPECT_EQ(sourceOf(ports, "first/odometry").drive, 0);
  EXPECT_EQ(sourceOf(ports, "pushed/odometry").drive, -1);
  EXPECT_EQ(sourceOf(ports, "second/odometry").drive, 1);
  EXPECT_EQ(sourceOf(ports, "second/odometry").track, 0.7);
  EXPECT_THAT(ports.driveModels, ElementsAre(0, 2));
  EXPECT_EQ(ports.drives[1].info.minimum, -1.5);
}

}  // namespace
}  // namespace simcore
