// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that a scene moves without forces: its program walks as ever.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/TestFolder.h"
#include "tests/app/Requests.h"
#include "tests/app/SimulatedRuns.h"

using namespace app::test;
using app::SimulatedRun;
using robotlink::Pose2;

namespace {

/// The shipped field on which red1 moves without forces.
std::filesystem::path kinematicField(const TestFolder& folder) {
  std::ifstream shipped(robotlink::resource("scenes/field2002.sdf"));
  std::ostringstream text;
  text << shipped.rdbuf();
  std::string scene = text.str();
  const std::string name = "<name>red1</name>";
  const std::size_t at = scene.find(name);
  EXPECT_NE(at, std::string::npos);
  scene.insert(at + name.size(), "<robotcontrol:motion>kinematic</robotcontrol:motion>");
  const auto file = folder / "kinematic.sdf";
  std::ofstream(file) << scene;
  return file;
}

/// What the program of red1 reports.
struct ReportedWalk {
  Pose2 odometry;
  int jointStates = 0, bodySensors = 0;
  double acceleration = 0;
  bool everStoodOnNothing = false;
  SimulatedRun::Listeners listeners() {
    return {[this](const std::string& robot, const auto& queue) {
              if (robot != "red1") return;
              const robotcontrol::DebugQueue wire = toWire(*queue);
              for (const auto& message : wire.messages()) hear(message);
            },
            {}};
  }
  void hear(const robotcontrol::DebugMessage& message) {
    if (message.path() == "joints/states") ++jointStates;
    if (message.path() == "motion/status") {
      robotcontrol::MotionStatus status;
      status.ParseFromString(message.package().data());
      odometry = {status.odometry().x(), status.odometry().y(), status.odometry().heading()};
    }
    if (message.path() != "body/sensors") return;
    ++bodySensors;
    robotcontrol::BodySensors sensors;
    sensors.ParseFromString(message.package().data());
    acceleration = sensors.acceleration().z();
    for (const bool contact : sensors.paw_contacts()) everStoodOnNothing = everStoodOnNothing || !contact;
  }
};

void walk(SimulatedRun& run, double x, double rotation, double seconds) {
  robotcontrol::Request request;
  request.set_robot("red1");
  auto& motion = *request.mutable_motion()->mutable_motion();
  motion.set_kind(robotcontrol::MotionRequest::WALK);
  motion.mutable_walk()->set_x(x);
  motion.mutable_walk()->set_rotation(rotation);
  for (double time = 0; time < seconds; time += 0.1) {
    EXPECT_TRUE(run.request(request).has_value());
    play(run, 0.1);
  }
}

}  // namespace

TEST(KinematicWalk, theBodyMovesByTheProgramsOdometryAndTheProgramNoticesNothing) {
  const TestFolder folder;
  app::RunOptions options = simulationOptions();
  options.scene = kinematicField(folder);
  options.world.noise = false;
  ReportedWalk reported;
  const auto run = makeRun(options, reported.listeners());
  ASSERT_NE(run, nullptr);
  ASSERT_TRUE(run->world().simulation().placeModel("ball", {0, 1, 0}));
  ASSERT_TRUE(run->request(selectRequest("red1", "behavior", "obey")).has_value());
  for (const char* package : {"package/joints/states", "package/body/sensors", "package/motion/status"})
    ASSERT_TRUE(run->request(keyRequest("red1", package)).has_value());
  play(*run, 1);
  const auto place = [&] {
    return robotlink::groundPose(run->world().simulation().modelPose("red1").value());
  };
  const Pose2 before = place(), reportedBefore = reported.odometry;
  walk(*run, 0.1, 0.3, 3);
  const Pose2 moved = before.inverse() * place();
  const Pose2 wanted = reportedBefore.inverse() * reported.odometry;
  EXPECT_GT(wanted.translation().norm(), 0.2);
  // The gait's slip is 2 %, and commands are executed some milliseconds after they are reported.
  EXPECT_LT((moved.translation() - wanted.translation()).norm(), 0.02);
  EXPECT_NEAR(moved.heading, wanted.heading, 0.02);
  // The debug process has a frame each 40 ms.
  EXPECT_GT(reported.jointStates, 90);
  EXPECT_GT(reported.bodySensors, 90);
  EXPECT_NEAR(reported.acceleration, 9.81, 8);
  EXPECT_FALSE(reported.everStoodOnNothing) << "it would seem to be picked up";
}
