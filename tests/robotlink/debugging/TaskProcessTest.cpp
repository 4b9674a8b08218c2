// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/TaskProcess.h"

#include <gmock/gmock.h>
#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/packages/Conversions.h"
#include "tests/TestFolder.h"
#include "tests/robotlink/debugging/ToyRobot.h"
#include "tests/robotlink/process/TestProcess.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;
using robotcontrol::Request;
using ::testing::HasSubstr;

namespace {

robotcontrol::Velocity2 velocity(double x) {
  robotcontrol::Velocity2 result;
  result.set_x(x);
  return result;
}

Request parametersRequest(const std::string& solution, const google::protobuf::Message& value) {
  Request request;
  auto& details = *request.mutable_set_parameters();
  details.set_task("ball-percept");
  details.set_solution(solution);
  details.mutable_value()->set_type(value.GetDescriptor()->full_name());
  details.mutable_value()->set_data(value.SerializeAsString());
  return request;
}

/// The radius in the newest shown ball percept; the percept's package must be on.
robotcontrol::BallPercept lastBall(const ToyRobot& robot) {
  robotcontrol::BallPercept ball;
  const auto shown = robot.on("percepts/ball");
  if (!shown.empty()) ball.ParseFromString(shown.back()->package().data());
  return ball;
}

// ---- Solutions

TEST(TaskProcessTest, aSolutionIsSwitchedAtAFramesStartAndStartsAfresh) {
  ToyRobot robot;
  robot.setKey("package/percepts/ball", KeyMode::ALWAYS);
  robot.run(100);
  EXPECT_GT(lastBall(robot).confidence(), 10);  // its object counts its images
  EXPECT_TRUE(robot.select("ball-percept", "region").accepted());
  robot.run(5);
  EXPECT_LE(lastBall(robot).confidence(), 3);
  EXPECT_EQ(4, livingSolutions());
}

TEST(TaskProcessTest, theTableShowsWhatIsActiveAndWhatIsUnavailable) {
  ToyRobot robot;
  robot.run(20);
  EXPECT_EQ("go", robot.active("behavior"));
  EXPECT_TRUE(robot.select("behavior", "obey").accepted());
  robot.run(20);
  EXPECT_EQ("obey", robot.active("behavior"));
  const auto table = robot.on("tables/solutions").back()->solutions();
  ASSERT_EQ(4, table.tasks_size());
  EXPECT_EQ("ball-model", table.tasks(1).name());
  EXPECT_EQ("cognition", table.tasks(1).process());
  EXPECT_EQ("oracle", table.tasks(1).solutions(1).name());
  EXPECT_EQ(
      "unavailable because neither the robot nor another task provides the simulator's ground truth "
      "(oracle/world)",
      table.tasks(1).solutions(1).unavailable());
  EXPECT_EQ("", table.tasks(1).solutions(0).unavailable());
  ASSERT_EQ(1, table.tasks(1).solutions(1).required_inputs_size());
  EXPECT_EQ("oracle/world", table.tasks(1).solutions(1).required_inputs(0));
  EXPECT_EQ(0, table.tasks(1).solutions(1).optional_inputs_size());
  ASSERT_EQ(1, table.tasks(1).solutions(1).outputs_size());
  EXPECT_EQ("models/ball", table.tasks(1).solutions(1).outputs(0));
  EXPECT_TRUE(table.tasks(0).solutions(1).has_parameters());
  for (const auto& task : table.tasks()) {
    if (task.name() == "behavior") {
      EXPECT_EQ("go", task.default_solution()) << "what its layout says";
    }
    EXPECT_NE("", task.default_solution());
  }
}

TEST(TaskProcessTest, anUnavailableOrUnknownSolutionIsRefusedWithTheReason) {
  ToyRobot robot;
  EXPECT_EQ(
      "solution oracle of ball-model is unavailable because neither the robot nor another task provides the "
      "simulator's ground truth (oracle/world)",
      robot.select("ball-model", "oracle").reason());
  EXPECT_EQ("task ball-model has no solution 'kalman'", robot.select("ball-model", "kalman").reason());
  EXPECT_EQ("no process of this layout has 'cooking'", robot.select("cooking", "soup").reason());
  robot.run(20);
  EXPECT_EQ("last", robot.active("ball-model"));
}

TEST(TaskProcessTest, aSolutionThatCannotBeMadeIsRefusedAndTheOldOneGoesOn) {
  ToyRobot robot;
  EXPECT_EQ("solution broken of task ball-percept could not be made: no color table for red1",
            robot.select("ball-percept", "broken").reason());
  EXPECT_THAT(
      robot.select("ball-percept", "untidy").reason(),
      HasSubstr("ball-percept (untidy) uses the input models/pose, which its registration does not name"));
  robot.setKey("package/percepts/ball", KeyMode::ALWAYS);
  robot.run(20);
  EXPECT_TRUE(lastBall(robot).seen());
  EXPECT_EQ(4, livingSolutions());
}

TEST(TaskProcessTest, aDefaultSolutionThatCannotBeMadeRefusesTheLayout) {
  std::string layout = kToyLayout;
  layout.replace(layout.find("ball-percept: region"), 20, "ball-percept: broken");
  ToyRobot robot;
  const Errors errors = robot.load(layout);
  ASSERT_EQ(1U, errors.size());
  EXPECT_EQ("toy.yaml:7:9: solution broken of task ball-percept could not be made: no color table for red1",
            errors[0].describe());
}

// ---- Debug keys and packages

TEST(TaskProcessTest, aDrawingIsSentOnlyWhileItsKeyIsOn) {
  ToyRobot robot;
  robot.run(50);
  EXPECT_TRUE(robot.on("drawings/image/ball-percept/dot").empty());
  EXPECT_TRUE(robot.setKey("ball-percept/dot", KeyMode::N_TIMES, 3).accepted());
  robot.run(100);
  EXPECT_EQ(3U, robot.on("drawings/image/ball-percept/dot").size());
}

TEST(TaskProcessTest, keysOfInactiveSolutionsAreKnownAndAnExpiredKeyIsPublished) {
  ToyRobot robot;
  robot.setKey("ball-percept/dot", KeyMode::N_TIMES, 2);
  robot.run(100);
  const auto& table = robot.on("tables/keys").back()->keys();
  std::map<std::string, robotcontrol::KeyTable::Key> keys;
  for (const auto& key : table.keys()) keys[key.name()] = key;
  EXPECT_TRUE(keys.at("ball-percept/dot").in_use());
  EXPECT_EQ(KeyMode::OFF, keys.at("ball-percept/dot").mode().kind());
  EXPECT_EQ("ball-percept/region", keys.at("ball-percept/dot").solutions(0));
  EXPECT_FALSE(keys.at("ball-model/oracle").in_use());
  EXPECT_TRUE(keys.at("timing/tasks").in_use());
  EXPECT_TRUE(keys.count("package/percepts/ball") == 1 && keys.count("package/camera/image") == 1);
  EXPECT_EQ(table.keys_size(), static_cast<int>(keys.size())) << "each key once";
}

TEST(TaskProcessTest, anyPackageCanBeSeenOnRequest) {
  ToyRobot robot;
  EXPECT_TRUE(robot.setKey("package/models/ball", KeyMode::EVERY_N, 2).accepted());
  EXPECT_TRUE(robot.setKey("package/camera/image", KeyMode::N_TIMES, 1).accepted());
  EXPECT_TRUE(robot.setKey("package/joints/request", KeyMode::ALWAYS).accepted());
  robot.run(100);
  const auto models = robot.on("models/ball");
  ASSERT_GE(models.size(), 8U);
  EXPECT_EQ("robotcontrol.BallModel", models[0]->package().type());
  EXPECT_EQ(80'000'000,
            (models[1]->timestamp().nanos() - models[0]->timestamp().nanos() + 1'000'000'000) % 1'000'000'000)
      << "every second image";
  ASSERT_EQ(1U, robot.on("camera/image").size());
  EXPECT_TRUE(robot.on("camera/image")[0]->has_image());
  EXPECT_GT(robot.on("joints/request").size(), 90U);
}

TEST(TaskProcessTest, aPackageThatIsSentRarelyIsPublishedOnceWhenItsKeyIsSwitchedOn) {
  ToyRobot robot;
  auto motion = std::make_shared<robotcontrol::RemoteMotion>();
  motion->mutable_motion()->mutable_walk()->set_x(0.25);
  robot.program->debugProcess().offer(motion);
  robot.run(20);
  ASSERT_TRUE(robot.on(kRemoteMotion.name).empty());
  EXPECT_TRUE(robot.setKey(packageKey(kRemoteMotion.name), KeyMode::ALWAYS).accepted());
  robot.run(50);
  ASSERT_EQ(1U, robot.on(kRemoteMotion.name).size());
  // Modes that count wait for the next one.
  EXPECT_TRUE(robot.setKey(packageKey(kRemoteMotion.name), KeyMode::N_TIMES, 1).accepted());
  robot.run(50);
  EXPECT_EQ(1U, robot.on(kRemoteMotion.name).size());
}

TEST(TaskProcessTest, wrongKeysAreRefusedWithTheNearestName) {
  ToyRobot robot;
  EXPECT_EQ("there is no debug key 'ball-percept/dots'; did you mean 'ball-percept/dot'?",
            robot.setKey("ball-percept/dots", KeyMode::ALWAYS).reason());
  EXPECT_EQ("no process of this layout has 'package/weather'",
            robot.setKey("package/weather", KeyMode::ALWAYS).reason());
  EXPECT_EQ("this mode of a debug key needs a number above 0",
            robot.setKey("ball-percept/dot", KeyMode::EVERY_MS).reason());
}

TEST(TaskProcessTest, stopwatchesTimeEachTaskAndTheWholeFrame) {
  ToyRobot robot;
  robot.run(10);
  EXPECT_TRUE(robot.on("stopwatches/cognition").empty());
  robot.setKey("timing/tasks", KeyMode::ALWAYS);
  robot.run(50);
  const auto times = robot.on("stopwatches/cognition");
  ASSERT_FALSE(times.empty());
  const auto& entries = times.back()->stopwatches().entries();
  ASSERT_EQ(4, entries.size());
  EXPECT_EQ("ball-percept", entries[0].task());
  EXPECT_EQ("region", entries[0].solution());
  EXPECT_EQ("", entries[3].task());
  EXPECT_GE(entries[3].seconds(), entries[0].seconds() + entries[1].seconds() + entries[2].seconds());
  EXPECT_FALSE(robot.on("stopwatches/motion").empty());
}

TEST(TaskProcessTest, stopwatchesNameThePackagesThatLeadFromAnImageToACommand) {
  ToyRobot robot;
  robot.setKey("timing/tasks", KeyMode::ALWAYS);
  robot.run(50);
  const auto& seen = robot.on("stopwatches/cognition").back()->stopwatches();
  EXPECT_TRUE(seen.clock_stands());
  const auto image = std::find_if(seen.received().begin(), seen.received().end(),
                                  [](const auto& package) { return package.name() == "camera/image"; });
  ASSERT_NE(seen.received().end(), image);
  EXPECT_TRUE(image->of_platform());
  EXPECT_EQ(instant(seen.timestamp()), instant(image->timestamp()));
  const auto wanted = std::find_if(seen.sent().begin(), seen.sent().end(),
                                   [](const auto& package) { return package.name() == "behavior/motion"; });
  ASSERT_NE(seen.sent().end(), wanted);
  EXPECT_FALSE(wanted->of_platform());
  EXPECT_GT(wanted->seconds(), 0);
  // Motion works with what cognition has sent, in this frame or one before: it has the same timestamp.
  const auto& moved = robot.on("stopwatches/motion").back()->stopwatches();
  const auto obeyed = std::find_if(moved.received().begin(), moved.received().end(),
                                   [](const auto& package) { return package.name() == "behavior/motion"; });
  ASSERT_NE(moved.received().end(), obeyed);
  const auto frames = robot.on("stopwatches/cognition");
  EXPECT_TRUE(std::any_of(frames.begin(), frames.end(), [&](const auto& frame) {
    const auto& sent = frame->stopwatches().sent();
    return std::any_of(sent.begin(), sent.end(), [&](const auto& package) {
      return package.name() == "behavior/motion" &&
             instant(package.timestamp()) == instant(obeyed->timestamp());
    });
  }));
  ASSERT_FALSE(moved.sent().empty());
  EXPECT_EQ("joints/request", moved.sent(0).name());
  EXPECT_TRUE(moved.sent(0).of_platform());
}

// ---- Parameters

TEST(TaskProcessTest, parametersComeFromTheirFileAndCanBeSet) {
  const TestFolder folder;
  folder.write("ball-percept.region.textproto", "# meters\nx: 1000\n");
  ToyRobot robot(kToyLayout, folder.path());
  robot.setKey("package/percepts/ball", KeyMode::ALWAYS);
  robot.run(20);
  EXPECT_GT(lastBall(robot).radius_in_image(), 1000);
  EXPECT_TRUE(robot.ask(parametersRequest("region", velocity(5000))).accepted());
  robot.run(20);
  EXPECT_GT(lastBall(robot).radius_in_image(), 5000);
  EXPECT_TRUE(robot.select("ball-percept", "region").accepted());
  robot.run(20);
  EXPECT_GT(lastBall(robot).radius_in_image(), 5000) << "kept when the solution is switched";
}

TEST(TaskProcessTest, parametersArePublishedWithTheirDescription) {
  ToyRobot robot;
  Request request;
  request.mutable_get_parameters()->set_task("ball-percept");
  request.mutable_get_parameters()->set_solution("region");
  EXPECT_TRUE(robot.ask(request).accepted());
  const auto published = robot.on("parameters/ball-percept/region");
  ASSERT_EQ(1U, published.size());
  EXPECT_EQ("robotcontrol.Velocity2", published[0]->parameters().value().type());
  google::protobuf::FileDescriptorSet files;
  ASSERT_TRUE(files.ParseFromString(published[0]->parameters().descriptors()));
  EXPECT_EQ("robotcontrol/Sensing.proto", files.file(files.file_size() - 1).name());
  EXPECT_TRUE(robot.ask(parametersRequest("region", velocity(5000))).accepted());
  const auto later = robot.on("parameters/ball-percept/region").back()->parameters();
  EXPECT_EQ(published[0]->parameters().value().data(), later.defaults().data());
  EXPECT_NE(later.value().data(), later.defaults().data());
  request.mutable_get_parameters()->set_solution("broken");
  EXPECT_EQ("solution broken of ball-percept has no parameters", robot.ask(request).reason());
  request.mutable_get_parameters()->set_task("motion");
  request.mutable_get_parameters()->set_solution("");
  EXPECT_EQ("solution walk of motion has no parameters", robot.ask(request).reason());
  Request set = parametersRequest("", velocity(1));
  set.mutable_set_parameters()->set_task("motion");
  EXPECT_EQ("solution walk of motion has no parameters", robot.ask(set).reason());
}

TEST(TaskProcessTest, wrongParametersAreRefusedAndChangeNothing) {
  ToyRobot robot;
  EXPECT_EQ("its parameters are a robotcontrol.Velocity2, not a 'robotcontrol.Pose2'",
            robot.ask(parametersRequest("region", robotcontrol::Pose2())).reason());
  EXPECT_EQ(
      "'x' is not a finite number, or not a text in UTF-8",
      robot.ask(parametersRequest("region", velocity(std::numeric_limits<double>::infinity()))).reason());
  Request damaged = parametersRequest("region", velocity(1));
  damaged.mutable_set_parameters()->mutable_value()->mutable_data()->resize(5);
  EXPECT_EQ("the bytes are not a valid robotcontrol.Velocity2", robot.ask(damaged).reason());
  robot.setKey("package/percepts/ball", KeyMode::ALWAYS);
  robot.run(20);
  EXPECT_LT(lastBall(robot).radius_in_image(), 200);
}

TEST(TaskProcessTest, aWrongParameterFileRefusesTheLayoutWithItsPlace) {
  const TestFolder folder;
  folder.write("ball-percept.region.textproto", "x: 1\ny: fast\ncolor: 3\n");
  ToyRobot robot;
  robot.parameterFolder = folder.path();
  const Errors errors = robot.load(kToyLayout);
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ((FilePosition{(folder.path() / "ball-percept.region.textproto").string(), 2, 4}),
            errors[0].where);
  EXPECT_THAT(errors[0].text, HasSubstr("fast"));
}

TEST(TaskProcessTest, aParameterFileOfNoSolutionIsRefusedWithTheNearestName) {
  const TestFolder folder;
  folder.write("ball-percept.regoin.textproto", "x: 1");
  folder.write("cooking.soup.textproto", "of a task that is not here");
  ToyRobot robot;
  robot.parameterFolder = folder.path();
  const Errors errors = robot.load(kToyLayout);
  ASSERT_EQ(1U, errors.size());
  EXPECT_EQ((folder.path() / "ball-percept.regoin.textproto").string() +
                ": task ball-percept has no solution 'regoin'; did you mean 'region'?",
            errors[0].describe());
}

// ---- Queues

/// The sender or receiver of a package.
template <typename Ends>
auto* endOf(const Ends& ends, const std::string& package) {
  return *std::ranges::find_if(ends, [&](const auto* end) { return end->package() == package; });
}

/// A process that publishes something in each frame once it is asked to, and the debug process's ends of its
/// two links.
class QueueLinksTest : public testing::Test {
 protected:
  QueueLinksTest() {
    description_.name = "idle";
    description_.tasks.push_back({"motion", "walk", {}});
    description_.period = std::chrono::milliseconds(8);
    process_ = *TaskProcess::create({robot_, layout_, description_, {}, parameters_}, clock_);
    connectUnchecked(requests_, *endOf(process_->receivers(), "debug/requests/idle"));
    connectUnchecked(*endOf(process_->senders(), "debug/queue/idle"), queue_);
  }
  /// Confirms queues up to this one.
  void confirm(std::uint64_t queuesTaken) {
    auto package = std::make_shared<robotcontrol::RequestQueue>();
    package->set_queues_taken(queuesTaken);
    package->set_first_number(1);
    auto& show = *package->add_requests()->mutable_set_key();
    show.set_name("package/joints/request");
    show.mutable_mode()->set_kind(KeyMode::ALWAYS);
    requests_.send(std::move(package));
  }
  /// The number of the queue that a frame sends; 0: none.
  std::uint64_t sentInAFrame() {
    clock_.advance(std::chrono::milliseconds(8));
    EXPECT_TRUE(process_->tryBeginFrame());
    process_->runFrame();
    std::uint64_t number = 0;
    debug_.body = [&] { number = queue_.isNew() ? queueIn(queue_.value())->number : 0; };
    debug_.step();
    return number;
  }

  ManualClock clock_;
  const RobotSetup robot_{"red1", "red", {}, nullptr};
  const Layout layout_;
  const ParameterSource parameters_;
  Layout::Process description_;
  TestProcess debug_{"debug", clock_};
  Sender<robotcontrol::RequestQueue> requests_{debug_, "debug/requests/idle", Blocking::kNo};
  Receiver<robotcontrol::DebugQueue> queue_{debug_, "debug/queue/idle", Blocking::kNo};
  std::unique_ptr<TaskProcess> process_;
};

TEST_F(QueueLinksTest, theNextQueueWaitsUntilTheLastOneIsConfirmed) {
  EXPECT_EQ(sentInAFrame(), 1U);
  confirm(0);
  EXPECT_EQ(sentInAFrame(), 0U);
  confirm(1);
  EXPECT_EQ(sentInAFrame(), 2U);
  EXPECT_EQ(sentInAFrame(), 0U);
}

TEST_F(QueueLinksTest, whoConfirmsEveryQueueConfirmsNoneThatIsStillToBeSent) {
  EXPECT_EQ(sentInAFrame(), 1U);
  confirm(std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(sentInAFrame(), 2U);
  EXPECT_EQ(sentInAFrame(), 0U) << "queue 2 may still be on its way";
  confirm(1);
  EXPECT_EQ(sentInAFrame(), 0U);
  confirm(2);
  EXPECT_EQ(sentInAFrame(), 3U);
}

}  // namespace
