// SPDX-License-Identifier: GPL-3.0-or-later
// A robot on wheels that is added by files alone, resources/robots/burger.yaml and what belongs to it: it
// drives and senses with the solutions for driving that another robot has, and speaks no protocol of that
// one.
#include <gmock/gmock.h>

#include "app/platforms/simulated/SimulatedRun.h"
#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/session/QueueMessages.h"
#include "simcore/Scene.h"
#include "tests/TestFolder.h"

using namespace app;
using robotcontrol::DriveState;

namespace {

/// What the robot told, by its package's name.
class HeardStreams {
 public:
  SimulatedRun::Listeners listeners() {
    return {[this](const std::string& robot, const auto& queue) {
              for (auto& message :
                   robotlink::messagesOf(robot, *queue, {}, robotlink::QueueReader::kViews).messages)
                reported_[message.path].push_back(message.value);
            },
            [this](const std::string&, const robotlink::Process&, const std::string& text) {
              troubles_ += text + "\n";
            }};
  }
  template <typename T>
  std::vector<std::shared_ptr<const T>> all(const std::string& path) {
    std::vector<std::shared_ptr<const T>> all;
    for (const auto& value : reported_[path]) {
      if (auto message = std::dynamic_pointer_cast<const T>(value)) all.push_back(std::move(message));
    }
    return all;
  }
  const std::string& troubles() const { return troubles_; }

 private:
  std::map<std::string, std::vector<std::shared_ptr<const google::protobuf::Message>>> reported_;
  std::string troubles_;
};

class WheelRobot : public testing::Test {
 protected:
  void SetUp() override {
    RunOptions options;
    options.scene = robotlink::resource("scenes/house.map");
    options.robots = simcore::RobotsToAdd{.model = "burger", .count = 1};
    options.solutions["driving"] = "wander";
    auto run = SimulatedRun::create(options, ears_.listeners());
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
    for (const char* package : {"drive/state", "range/laser"}) {
      robotcontrol::Request request;
      request.set_robot("burger1");
      request.mutable_set_key()->set_name(std::string("package/") + package);
      request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
      EXPECT_TRUE(run_->request(request));
    }
  }
  void play(double seconds) {
    const robotlink::Instant end = run_->world().clock().now() + robotlink::fromSeconds(seconds);
    while (run_->world().clock().now() < end) run_->step();
  }
  robotlink::Pose2 truePose() {
    return robotlink::groundPose(run_->world().simulation().modelPose("burger1").value());
  }
  std::vector<std::shared_ptr<const DriveState>> states() {
    return ears_.all<DriveState>("burger1/drive/state");
  }

  HeardStreams ears_;
  std::unique_ptr<SimulatedRun> run_;
};

}  // namespace

TEST_F(WheelRobot, itDrivesThroughAHouseWithoutTouchingAnything) {
  play(1);
  const robotlink::Pose2 start = truePose();
  const robotlink::Pose2 odometryAtStart{states().back()->odometry().x(), states().back()->odometry().y(),
                                         states().back()->odometry().heading()};
  double way = 0;
  robotlink::Pose2 last = start;
  for (int i = 0; i < 20; ++i) {
    play(1);
    way += (truePose().translation() - last.translation()).norm();
    last = truePose();
  }
  EXPECT_GT(way, 1.0);
  EXPECT_EQ(run_->world().simulation().obstacleContacts("burger1"), 0U);
  EXPECT_EQ(ears_.troubles(), "");
  const auto& end = states().back()->odometry();
  const robotlink::Pose2 byWheels =
      odometryAtStart.inverse() * robotlink::Pose2{end.x(), end.y(), end.heading()};
  const robotlink::Pose2 truly = start.inverse() * truePose();
  EXPECT_LT((byWheels.translation() - truly.translation()).norm(), 0.1 * way + 0.05);
}

TEST_F(WheelRobot, itKeepsToItsSpeedsAndReportsThemTenTimesASecond) {
  play(10);
  EXPECT_NEAR(static_cast<double>(states().size()), 100, 3);
  for (const auto& state : states()) {
    EXPECT_LT(std::abs(state->velocity().x()), 0.22 * 1.1);
    EXPECT_LT(std::abs(state->velocity().rotation()), 2.84 * 1.1);
    EXPECT_EQ(state->battery(), 0) << "it has none that it could tell of";
  }
}

TEST_F(WheelRobot, itsLaserIsFoundWhateverItIsCalledAndMeasuresFiveTimesASecond) {
  play(10);
  const auto scans = ears_.all<foxglove::LaserScan>("burger1/range/laser");
  EXPECT_NEAR(static_cast<double>(scans.size()), 50, 2);
  ASSERT_FALSE(scans.empty());
  for (const auto& scan : scans) {
    ASSERT_EQ(scan->ranges_size(), 360);
    for (const double range : scan->ranges()) EXPECT_LE(range, 3.5);
  }
  const auto& ranges = scans.back()->ranges();
  EXPECT_LT(*std::min_element(ranges.begin(), ranges.end()), 3.5) << "it sees a wall";
}

TEST_F(WheelRobot, itsNextProgramGoesOnToItsGoalButNotAfterAReset) {
  robotcontrol::Request request;
  request.set_robot("burger1");
  const auto choose = [&](const char* task, const char* solution) {
    request.mutable_select_solution()->set_task(task);
    request.mutable_select_solution()->set_solution(solution);
    ASSERT_TRUE(run_->request(request));
  };
  choose("driving", "follow-path");
  choose("path-planning", "direct");
  choose("self-localisation", "oracle");
  play(1);
  const robotlink::Pose2 start = truePose();
  const Eigen::Vector2d goal = start * Eigen::Vector2d(0.8, 0);
  request.mutable_set_goal()->mutable_pose_in_field()->set_x(goal.x());
  request.mutable_set_goal()->mutable_pose_in_field()->set_y(goal.y());
  request.mutable_set_goal()->set_any_heading(true);
  ASSERT_TRUE(run_->request(request));
  play(2);
  const auto way = [&] { return (truePose().translation() - start.translation()).norm(); };
  const double before = way();
  ASSERT_GT(before, 0.1);
  robotcontrol::HostProgram again;
  again.set_start_again(true);
  ASSERT_EQ(robotlink::describe(run_->hostProgram("burger1", again)), "");
  play(2);
  EXPECT_GT(way(), before + 0.1);
  ASSERT_EQ(robotlink::describe(run_->reset(1)), "");
  play(2);
  EXPECT_LT(way(), 0.05);
}

TEST(MapInCapitals, hasARobotAsAnyMap) {
  const TestFolder folder;
  std::filesystem::copy_file(robotlink::resource("scenes/house.map"), folder / "HOUSE.MAP");
  RunOptions options;
  options.scene = folder / "HOUSE.MAP";
  const auto run = SimulatedRun::create(options, {});
  ASSERT_TRUE(run) << robotlink::describe(run.error());
  EXPECT_EQ((*run)->world().simulation().scene().robots().size(), 1U);
}

TEST_F(WheelRobot, itStandsWhileStopIsEngaged) {
  play(5);
  robotcontrol::Request stop;
  stop.set_robot("burger1");
  stop.mutable_stop()->set_engaged(true);
  ASSERT_TRUE(run_->request(stop));
  play(1);
  const robotlink::Pose2 stopped = truePose();
  play(2);
  EXPECT_LT((truePose().translation() - stopped.translation()).norm(), 0.01);
  EXPECT_TRUE(states().back()->emergency_stop());
  stop.mutable_stop()->set_engaged(false);
  ASSERT_TRUE(run_->request(stop));
  play(6);
  EXPECT_GT((truePose().translation() - stopped.translation()).norm(), 0.1);
}

TEST_F(WheelRobot, itHasNoMicrocontrollerThatProgramsOutsideCouldTalkTo) {
  EXPECT_EQ(run_->world().pioneer("burger1"), nullptr);
  EXPECT_TRUE(run_->world().pioneers().empty());
  robotcontrol::Request request;
  request.set_robot("burger1");
  request.mutable_control_drive()->add_packets("x");
  const auto done = run_->request(request);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().id, "drive.no-controller");
}

TEST_F(WheelRobot, itKnowsNoSoccerFieldWhereThereIsNone) {
  EXPECT_EQ(run_->field()->name, "");
  EXPECT_TRUE(run_->field()->goals.empty());
}
