// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/RobotTables.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"

namespace robotlink {
namespace {

/// A table of processes, each with one task: "think: walking".
StreamMessage processes(const std::map<std::string, std::string>& tasks, const std::string& state) {
  auto table = std::make_shared<robotcontrol::ProcessTable>();
  for (const auto& [name, task] : tasks) {
    auto& process = *table->add_processes();
    process.set_name(name);
    process.set_state(state);
    process.add_tasks(task);
  }
  return {"red1/tables/processes", Instant(fromSeconds(1)), table};
}

StreamMessage solutions(const std::vector<std::string>& tasks, double time) {
  auto table = std::make_shared<robotcontrol::SolutionTable>();
  for (const std::string& task : tasks) table->add_tasks()->set_name(task);
  return {"red1/tables/solutions", Instant(fromSeconds(time)), table};
}

TEST(RobotTables, packagesAndThoseThatAreHeldAreThoseOfAllProcesses) {
  Session session;
  auto table = std::make_shared<robotcontrol::ProcessTable>();
  auto& process = *table->add_processes();
  process.add_receivers()->set_package("joints/states");
  process.add_receivers()->set_package("debug/requests/see");
  auto& sender = *process.add_senders();
  sender.set_package("models/ball");
  sender.set_held(true);
  session.push({"red1/tables/processes", Instant(fromSeconds(1)), table});
  session.tick();
  EXPECT_EQ(programPackages(session.store(), "red1", Instant::max()),
            (std::set<std::string>{"joints/states", "models/ball"}));
  EXPECT_EQ(heldPackages(session.store(), "red1", Instant::max()), std::set<std::string>{"models/ball"});
  EXPECT_TRUE(programPackages(session.store(), "red2", Instant::max()).empty());
}

TEST(RobotTables, tasksAreKnownWhenAllProcessesHaveReportedTheirs) {
  Session session;
  session.setRobots({"red1"});
  const auto isKnownWith = [&](StreamMessage message) {
    session.push(std::move(message));
    session.tick();
    return areTasksKnown(session);
  };
  EXPECT_FALSE(areTasksKnown(session));
  EXPECT_FALSE(isKnownWith(solutions({"walking"}, 1)));
  EXPECT_FALSE(isKnownWith(processes({{"act", "walking"}, {"see", "ball"}}, "running")));
  EXPECT_TRUE(isKnownWith(solutions({"walking", "ball"}, 2)));
}

TEST(RobotTables, whatWasReportedBeforeTheProgramRanDoesNotCountWhenItRuns) {
  Session session;
  session.setRobots({"red1"});
  auto running = std::make_shared<robotcontrol::SimulationStatus>();
  session.push(processes({{"see", "ball"}}, "running"));
  session.push(solutions({"ball"}, 1));
  session.tick();
  EXPECT_TRUE(areTasksKnown(session));
  running->set_running(true);
  session.push({"simulation", Instant(fromSeconds(1)), running});
  session.tick();
  EXPECT_FALSE(areTasksKnown(session));
  auto ran = processes({{"see", "ball"}}, "running");
  auto table = std::make_shared<robotcontrol::ProcessTable>(
      dynamic_cast<const robotcontrol::ProcessTable&>(*ran.value));
  table->mutable_processes(0)->set_frames(3);
  session.push({ran.path, Instant(fromSeconds(2)), table});
  session.tick();
  EXPECT_TRUE(areTasksKnown(session));
}

TEST(RobotTables, aProcessThatHasEndedReportsNothing) {
  Session session;
  session.setRobots({"red1"});
  session.push(processes({{"see", "ball"}}, "failed: no camera"));
  session.tick();
  EXPECT_TRUE(areTasksKnown(session));
}

TEST(RobotTables, theActiveSolutionIsThatOfTheRobotAsked) {
  Session session;
  auto table = std::make_shared<robotcontrol::SolutionTable>();
  table->add_tasks()->set_name("ball");
  table->mutable_tasks(0)->set_active("kalman");
  session.push({"red2/tables/solutions", Instant(fromSeconds(1)), table});
  session.tick();
  EXPECT_EQ(activeSolution(session.store(), "red2", "ball"), "kalman");
  EXPECT_EQ(activeSolution(session.store(), "red2", "walking"), "");
  EXPECT_EQ(activeSolution(session.store(), "red1", "ball"), "");
}

}  // namespace
}  // namespace robotlink
