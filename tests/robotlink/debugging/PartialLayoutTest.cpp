// SPDX-License-Identifier: GPL-3.0-or-later
// What remains of a layout where something else, such as a log, takes the place of some tasks.
#include <gtest/gtest.h>

#include <algorithm>

#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Packages.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using robotlink::test::kToyLayout;

namespace {

using namespace std::chrono_literals;

/// Offers images and, as a log would, motion statuses; listens to the requests for the joints.
class LogLikePlatform final : public Platform {
 public:
  using Platform::Platform;
  ~LogLikePlatform() override { stop(); }
  void actuate() override {
    if (request_.isNew()) ++requests;
  }
  void engageStop(bool) override {}
  int requests = 0;

 protected:
  void execute() override {
    image_.send(std::make_shared<foxglove::RawImage>());
    joints_.send(jointStates());
    status_.send(std::make_shared<robotcontrol::MotionStatus>());
  }

 private:
  static std::shared_ptr<foxglove::JointStates> jointStates() {
    auto states = std::make_shared<foxglove::JointStates>();
    states->add_joints()->set_position(1);
    return states;
  }
  Sender<foxglove::RawImage> image_{*this, "camera/image", Blocking::kNo};
  Sender<foxglove::JointStates> joints_{*this, "joints/states", Blocking::kNo};
  Sender<robotcontrol::MotionStatus> status_{*this, "motion/status", Blocking::kNo};
  Receiver<robotcontrol::JointRequest> request_{*this, "joints/request", Blocking::kNo};
};

struct PartialRobot {
  Errors load(Layout layout, const ParameterSource& parameters = {}) {
    RobotSetup setup;
    setup.name = "red1";
    auto made = RobotProgram::create(setup, std::move(layout), platform, parameters);
    if (!made) return made.error();
    program = std::move(*made);
    program->debugProcess().setListener([this](const std::shared_ptr<const SharedDebugQueue>& queue) {
      const robotcontrol::DebugQueue wire = toWire(*queue);
      heard.insert(heard.end(), wire.messages().begin(), wire.messages().end());
    });
    for (Process* process : program->processes()) executor.add(*process);
    executor.add(platform);
    return {};
  }
  ~PartialRobot() { executor.clear(); }

  /// How often a process's package was sent.
  std::uint64_t sent(const std::string& package) const {
    for (const Process* process : program->processes()) {
      for (const AnySender* sender : process->senders()) {
        if (sender->package() == package) return sender->sent();
      }
    }
    return 0;
  }
  const Process& process(const std::string& name) const {
    const auto& all = program->processes();
    return **std::find_if(all.begin(), all.end(), [&](const Process* p) { return p->name() == name; });
  }

  ManualClock clock;
  LogLikePlatform platform{"platform", clock};
  LockstepExecutor executor{{.advance = [this] { clock.advance(8ms); }, .onStarved = {}, .onFailed = {}}};
  std::unique_ptr<RobotProgram> program;
  std::vector<robotcontrol::DebugMessage> heard;
};

Layout toyLayout() {
  auto layout = parseLayout(kToyLayout, "toy.yaml");
  return layout ? *layout : Layout{};
}

void removeTask(Layout& layout, const std::string& task) {
  for (Layout::Process& process : layout.processes) {
    std::erase_if(process.tasks, [&](const Layout::Task& entry) { return entry.task == task; });
  }
}

}  // namespace

TEST(PartialLayout, aWithheldPackageIsYieldedByNobodyElse) {
  PartialRobot robot;
  Layout layout = toyLayout();
  const Errors refused = robot.load(layout);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused.front().id, "layout.output-twice");
  layout.withheld = {"motion/status"};
  const Errors errors = robot.load(layout);
  ASSERT_TRUE(errors.empty()) << describe(errors);
  for (int i = 0; i < 10; ++i) robot.executor.step();
  EXPECT_GT(robot.sent("joints/request"), 5U);
  EXPECT_EQ(robot.sent("motion/status"), 0U);
  EXPECT_GT(robot.platform.requests, 5);
}

TEST(PartialLayout, aProcessRunsAtThePaceOfWhatItDoesNotRead) {
  Layout layout = toyLayout();
  removeTask(layout, "ball-percept");
  for (Layout::Process& process : layout.processes) {
    for (Layout::Task& task : process.tasks) {
      if (task.task == "ball-model") task.solution = "last";
    }
  }
  const PlatformPackages platform{{"camera/image", "joints/states", "percepts/ball"}, {}, {"remote/motion"}};
  const Errors errors = checkLayout(layout, registeredTasks(), platform);
  ASSERT_EQ(errors.size(), 1U) << describe(errors);
  EXPECT_EQ(errors.front().id, "layout.blocking-unused");
  for (Layout::Process& process : layout.processes) {
    for (Layout::Input& input : process.blocking) input.paceOnly = true;
  }
  EXPECT_TRUE(checkLayout(layout, registeredTasks(), platform).empty());
  const auto links = layoutLinks(layout, registeredTasks(), platform);
  EXPECT_NE(std::find(links.begin(), links.end(), LayoutLink{"camera/image", "", "cognition", true, false}),
            links.end());
}

TEST(PartialLayout, absentTasksAreShownWithTheirReasonAndCannotBeAsked) {
  PartialRobot robot;
  Layout layout = toyLayout();
  removeTask(layout, "motion");
  std::erase_if(layout.processes, [](const Layout::Process& p) { return !p.debug && p.tasks.empty(); });
  layout.absent.push_back(
      {"motion", "motion", "neither the robot nor another task provides joint angles (joints/states)"});
  const Errors errors = robot.load(layout);
  ASSERT_TRUE(errors.empty()) << describe(errors);
  robotcontrol::Request request;
  request.set_id(7);
  request.mutable_select_solution()->set_task("motion");
  request.mutable_select_solution()->set_solution("walk");
  robot.program->debugProcess().request(request);
  for (int i = 0; i < 10; ++i) robot.executor.step();

  const robotcontrol::SolutionTable* table = nullptr;
  const robotcontrol::RequestResult* result = nullptr;
  for (const auto& message : robot.heard) {
    if (message.path() == "tables/solutions") table = &message.solutions();
    if (message.has_result()) result = &message.result();
  }
  ASSERT_NE(table, nullptr);
  const auto& row = table->tasks(table->tasks_size() - 1);
  EXPECT_EQ(row.name(), "motion");
  EXPECT_EQ(row.process(), "motion");
  EXPECT_EQ(row.active(), "");
  ASSERT_EQ(row.solutions_size(), 1);
  EXPECT_EQ(row.solutions(0).unavailable(),
            "unavailable because neither the robot nor another task provides joint angles (joints/states)");
  EXPECT_GT(table->tasks_size(), 1);
  ASSERT_NE(result, nullptr);
  EXPECT_FALSE(result->accepted());
  EXPECT_EQ(result->reason(),
            "task motion does not run because neither the robot nor another task provides joint angles "
            "(joints/states)");
}

TEST(PartialLayout, recordedParametersCountMoreThanFilesAndUnknownOnesNothing) {
  robotcontrol::Velocity2 value;
  value.set_x(5);
  ParameterSource source;
  auto& recorded = source.recorded.emplace_back();
  recorded.set_task("ball-percept");
  recorded.set_solution("region");
  recorded.mutable_value()->set_type("robotcontrol.Velocity2");
  value.SerializeToString(recorded.mutable_value()->mutable_data());
  source.recorded.push_back(recorded);
  source.recorded.back().set_solution("gone");

  PartialRobot robot;
  Layout layout = toyLayout();
  layout.withheld = {"motion/status"};
  const Errors errors = robot.load(layout, source);
  ASSERT_TRUE(errors.empty()) << describe(errors);
  double radius = 0;
  for (AnySender* sender : robot.process("cognition").senders()) {
    if (sender->package() != "percepts/ball") continue;
    sender->addTap([&](const PackagePtr& package) {
      radius = dynamic_cast<const robotcontrol::BallPercept&>(*package).radius_in_image();
    });
  }
  for (int i = 0; i < 5; ++i) robot.executor.step();
  EXPECT_EQ(radius, 5);
}
