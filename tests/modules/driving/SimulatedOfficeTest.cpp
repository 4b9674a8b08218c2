// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program of a Pioneer on a simulated one, with forces, slip and odometry that errs, in the map of
// a real office.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "modules/navigation/ReachableSpace.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/QueueMessages.h"
#include "simcore/Simulation.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

constexpr const char* kOfficeRobot = "p3at1";
const std::filesystem::path kOffice = ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos/office.map";

class SimulatedOffice {
 public:
  SimulatedOffice(const std::string& layout, std::map<std::string, std::string> solutions,
                  std::uint64_t seed) {
    const std::string resources = ROBOTCONTROL_SOURCE_DIR "/resources";
    setenv("ROBOTCONTROL_RESOURCES", resources.c_str(), 1);
    app::RunOptions options;
    options.scene = kOffice;
    options.layout = resources + "/layouts/" + layout + ".yaml";
    options.world.seed = seed;
    options.solutions = std::move(solutions);
    app::SimulatedRun::Listeners listeners;
    listeners.queue = [this](const std::string& robot, auto queue) {
      for (const auto& message :
           robotlink::messagesOf(robot, *queue, {}, robotlink::QueueReader::kViews).messages)
        if (auto pose = std::dynamic_pointer_cast<const robotcontrol::RobotPose>(message.value))
          believed_ = *pose;
    };
    listeners.trouble = [](const std::string&, const auto&, const std::string& text) {
      ADD_FAILURE() << text;
    };
    auto run = app::SimulatedRun::create(std::move(options), std::move(listeners));
    if (!run) throw std::runtime_error(robotlink::describe(run.error()));
    run_ = *std::move(run);
    robotcontrol::Request show;
    show.set_robot(kOfficeRobot);
    show.mutable_set_key()->set_name("package/models/pose");
    show.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    EXPECT_TRUE(run_->request(show));
  }
  void run(double seconds) {
    const robotlink::Instant end = run_->world().clock().now() + robotlink::fromSeconds(seconds);
    while (run_->world().clock().now() < end) run_->step();
  }
  Pose2 truth() const { return robotlink::groundPose(*run_->world().simulation().modelPose(kOfficeRobot)); }
  double error() const {
    return (robotlink::pose2(believed_.robot_in_field()).translation() - truth().translation()).norm();
  }
  const robotcontrol::RobotPose& believed() const { return believed_; }
  void place(const Pose2& pose) { EXPECT_TRUE(run_->world().simulation().placeModel(kOfficeRobot, pose)); }
  void send(const Pose2& goal) {
    robotcontrol::Request request;
    request.set_robot(kOfficeRobot);
    robotlink::assign(*request.mutable_set_goal()->mutable_pose_in_field(), goal);
    EXPECT_TRUE(run_->request(request));
  }
  std::shared_ptr<const robotlink::GroundMap> map() const { return run_->map(); }

 private:
  std::unique_ptr<app::SimulatedRun> run_;
  robotcontrol::RobotPose believed_;
};

TEST(SimulatedOffice, aMinuteOfWanderingTellsWhereTheRobotIs) {
  if (!std::filesystem::exists(kOffice)) GTEST_SKIP() << "needs " << kOffice;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SimulatedOffice office("pioneer", {{"driving", "wander"}}, seed);
    const DistanceMap distances(*office.map(), {});
    robotlink::Random random(seed);
    office.place(ReachableSpace(distances, *office.map(), 0.6).draw(random));
    office.run(0.6);
    EXPECT_GT(office.believed().position_deviation(), 1) << seed;
    office.run(60);
    found += office.error() < 0.3 && office.believed().position_deviation() < 0.3 ? 1 : 0;
  }
  EXPECT_GE(found, 8);
}

class SimulatedOfficeGoalTest : public testing::TestWithParam<const char*> {};

TEST_P(SimulatedOfficeGoalTest, theRobotDrivesWhereItIsSent) {
  if (!std::filesystem::exists(kOffice)) GTEST_SKIP() << "needs " << kOffice;
  SimulatedOffice office(GetParam(), {}, 1);
  office.run(2);
  const Vector2 start = office.truth().translation();
  office.run(2);
  EXPECT_LT((office.truth().translation() - start).norm(), 0.02) << "it stands until it is sent";
  office.send({15.5, 11, 1.57});
  office.run(120);
  EXPECT_LT((office.truth().translation() - Vector2(15.5, 11)).norm(), 0.25);
  EXPECT_NEAR(1.57, office.truth().heading, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Layouts, SimulatedOfficeGoalTest, testing::Values("pioneer", "pioneer-parallel"),
                         [](const auto& layout) {
                           return std::string(layout.param) == "pioneer" ? "pioneer" : "parallel";
                         });

}  // namespace
}  // namespace modules
