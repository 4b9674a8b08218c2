// SPDX-License-Identifier: GPL-3.0-or-later
// A toy robot whose processes are spread over two programs that are linked over DDS.
#include <gtest/gtest.h>

#include "robotlink/dds/ProgramNet.h"
#include "tests/Eventually.h"
#include "tests/robotlink/dds/TestNodes.h"
#include "tests/robotlink/debugging/ToyRobot.h"

namespace robotlink::test {
namespace {

/// One of the two programs. Both are stepped by the test, by one clock.
class ToyPart {
 public:
  ToyPart(const std::string& name, const ManualClock& clock)
      : net_(openTestNode(), {"red1", name}, clock, {}), platform_("toy", clock) {
    auto layout = parseLayout(std::string(kToyLayout) +
                                  "programs:\n  - {name: head, processes: [cognition]}\n"
                                  "  - {name: body, processes: [motion, debug]}\n",
                              "toy.yaml");
    RobotSetup setup;
    setup.name = "red1";
    auto made = RobotProgram::create(setup, std::move(*layout), platform_, {}, {name, &net_});
    if (!made) throw std::runtime_error(describe(made.error()));
    program_ = std::move(*made);
    for (Process* process : program_->processes()) executor_.add(*process);
    executor_.add(platform_);
  }
  ~ToyPart() { executor_.clear(); }
  ToyPart(const ToyPart&) = delete;
  ToyPart& operator=(const ToyPart&) = delete;

  RobotProgram& program() { return *program_; }
  const ToyPlatform& platform() const { return platform_; }
  void step() { program_->hasDebugProcess() ? executor_.step() : executor_.runProcesses(); }

 private:
  dds::ProgramNet net_;
  ToyPlatform platform_;
  std::unique_ptr<RobotProgram> program_;
  LockstepExecutor executor_{{}};
};

class SpreadRobotTest : public ::testing::Test {
 protected:
  SpreadRobotTest() {
    body_.program().debugProcess().setListener([this](const std::shared_ptr<const SharedDebugQueue>& queue) {
      heard_.insert(heard_.end(), queue->messages.begin(), queue->messages.end());
    });
  }
  void startHead() { head_ = std::make_unique<ToyPart>("head", clock_); }

  template <typename Condition>
  bool until(Condition condition) {
    return eventually([&] {
      clock_.advance(std::chrono::milliseconds(8));
      body_.step();
      if (head_) head_->step();
      return condition();
    });
  }
  template <typename T>
  const T* newest() const {
    for (auto message = heard_.rbegin(); message != heard_.rend(); ++message) {
      if (const T* content = message->as<T>()) return content;
    }
    return nullptr;
  }
  std::string active(const std::string& task) const {
    const auto* table = newest<robotcontrol::SolutionTable>();
    if (table == nullptr) return {};
    for (const auto& row : table->tasks()) {
      if (row.name() == task) return row.active();
    }
    return {};
  }
  std::string stateOf(const std::string& process) const {
    const auto* table = newest<robotcontrol::ProcessTable>();
    if (table == nullptr) return {};
    for (const auto& row : table->processes()) {
      if (row.name() == process) return row.state();
    }
    return {};
  }
  /// The reason why it was refused; "" if it was accepted.
  std::string select(const std::string& task, const std::string& solution) {
    robotcontrol::Request request;
    request.mutable_select_solution()->set_task(task);
    request.mutable_select_solution()->set_solution(solution);
    return refusalOf(std::move(request));
  }
  std::string refusalOf(robotcontrol::Request request) {
    request.set_id(++requests_);
    body_.program().debugProcess().request(request);
    const robotcontrol::RequestResult* result = nullptr;
    const bool answered = until([&] {
      result = newest<robotcontrol::RequestResult>();
      return result != nullptr && result->id() == requests_;
    });
    return answered ? result->reason() : "no answer";
  }

  ManualClock clock_;
  std::vector<SharedDebugMessage> heard_;
  std::uint64_t requests_ = 0;
  ToyPart body_{"body", clock_};
  std::unique_ptr<ToyPart> head_;
};

TEST_F(SpreadRobotTest, packagesAndTablesGoFromProgramToProgram) {
  startHead();
  EXPECT_TRUE(until([&] { return stateOf("cognition") == "running in program head"; }));
  EXPECT_TRUE(until([&] { return active("ball-model") == "last" && active("motion") == "walk"; }));
  // An image goes to the head, what it makes of it comes back as a motion, and goes to the platform.
  EXPECT_TRUE(until([&] {
    const auto& requests = body_.platform().requests();
    robotcontrol::JointRequest request;
    return !requests.empty() && request.ParseFromString(requests.back()) && request.positions(1) > 0;
  }));
  EXPECT_EQ("", select("behavior", "obey"));
  EXPECT_TRUE(until([&] { return active("behavior") == "obey"; }));
  EXPECT_NE("", select("behavior", "dance"));
}

TEST_F(SpreadRobotTest, aProgramThatDoesNotRunIsNamedAndGetsTheRequestsWhenItRunsAgain) {
  EXPECT_EQ("program head, which runs process cognition, does not run", select("behavior", "obey"));
  startHead();
  ASSERT_TRUE(until([&] { return stateOf("cognition") == "running in program head"; }));
  ASSERT_EQ("", select("behavior", "obey"));
  ASSERT_TRUE(until([&] { return active("behavior") == "obey"; }));
  head_.reset();
  EXPECT_TRUE(until([&] { return stateOf("cognition") == "stopped: program head does not run"; }));
  EXPECT_EQ("program head, which runs process cognition, does not run", select("ball-model", "throwing"));
  EXPECT_EQ("running", stateOf("motion"));
  heard_.clear();
  startHead();
  EXPECT_TRUE(until([&] { return active("behavior") == "obey"; }));
}

TEST_F(SpreadRobotTest, aProgramThatWouldTakeWhatTheUserSendsIsNamedIfItDoesNotRun) {
  robotcontrol::Request motion, goal;
  motion.mutable_motion();
  goal.mutable_set_goal()->set_cancelled(true);
  EXPECT_EQ("program head, which runs process cognition, does not run", refusalOf(motion));
  EXPECT_EQ("no task of this layout drives to goals", refusalOf(goal));
  startHead();
  EXPECT_TRUE(eventually([&] { return refusalOf(motion).empty(); }));
}

TEST_F(SpreadRobotTest, theRobotIsUnattendedWhileAProgramThatDecidesThroughOthersIsMissing) {
  const auto unattended = [&] { return !body_.program().missingProcess().empty(); };
  EXPECT_TRUE(unattended()) << "what the platform takes comes from here, but the head decides about it";
  for (int i = 0; i < 2; ++i) {
    startHead();
    EXPECT_TRUE(until([&] { return !unattended(); }));
    head_.reset();
    EXPECT_TRUE(until(unattended));
  }
}

TEST_F(SpreadRobotTest, theRobotIsUnattendedIfAProcessElsewhereThatDecidesHasStopped) {
  startHead();
  ASSERT_TRUE(until([&] { return body_.program().missingProcess().empty() && stateOf("cognition") != ""; }));
  select("ball-model", "throwing");
  EXPECT_TRUE(until([&] { return !body_.program().missingProcess().empty(); }));
}

TEST_F(SpreadRobotTest, theRobotIsUnattendedWhileAProcessElsewhereThatDecidesDoesNotReturn) {
  startHead();
  ASSERT_TRUE(until([&] { return body_.program().missingProcess().empty() && stateOf("cognition") != ""; }));
  head_->program().noteStuck("cognition", "ball-model (last)");
  EXPECT_TRUE(until([&] { return body_.program().missingProcess() == "cognition"; }));
  EXPECT_TRUE(until([&] { return stateOf("cognition") == "does not return from ball-model (last)"; }));
  EXPECT_EQ("process cognition of program head does not return from ball-model (last)",
            select("behavior", "obey"));
  head_->program().noteStuck("cognition", {});
  EXPECT_TRUE(until([&] { return body_.program().missingProcess().empty(); }));
}

TEST_F(SpreadRobotTest, theParametersOfAProgramComeWheneverItBegins) {
  for (int i = 0; i < 2; ++i) {
    heard_.clear();
    startHead();
    EXPECT_TRUE(until([&] { return newest<robotcontrol::ParameterValues>() != nullptr; }));
    const auto* values = newest<robotcontrol::ParameterValues>();
    ASSERT_NE(values, nullptr);
    EXPECT_FALSE(values->task().empty());
    EXPECT_FALSE(values->value().type().empty());
    head_.reset();
    ASSERT_TRUE(until([&] { return stateOf("cognition") == "stopped: program head does not run"; }));
  }
}

TEST_F(SpreadRobotTest, aProcessThatThrowsInAnotherProgramIsNamed) {
  startHead();
  ASSERT_TRUE(until([&] { return stateOf("cognition") == "running in program head"; }));
  select("ball-model", "throwing");
  EXPECT_TRUE(until([&] { return stateOf("cognition").ends_with("the ball has no covariance"); }));
  EXPECT_EQ("running", stateOf("motion"));
}

}  // namespace
}  // namespace robotlink::test
