// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/RequestPreview.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;
using robotcontrol::Request;

namespace {

Request select(const char* task, const char* solution) {
  Request request;
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  return request;
}

Request getParameters(const char* task, const char* solution) {
  Request request;
  request.mutable_get_parameters()->set_task(task);
  request.mutable_get_parameters()->set_solution(solution);
  return request;
}

Request setParameters(const char* task, const char* solution, double x,
                      const char* type = "robotcontrol.Velocity2") {
  Request request;
  auto& details = *request.mutable_set_parameters();
  details.set_task(task);
  details.set_solution(solution);
  robotcontrol::Velocity2 value;
  value.set_x(x);
  details.mutable_value()->set_type(type);
  details.mutable_value()->set_data(value.SerializeAsString());
  return request;
}

Request setKey(const char* key, KeyMode::Kind kind, unsigned n = 0) {
  Request request;
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(kind);
  request.mutable_set_key()->mutable_mode()->set_n(n);
  return request;
}

Request colorTable(std::string cells) {
  Request request;
  request.mutable_set_color_table()->mutable_table()->set_cells(std::move(cells));
  return request;
}

/// Every kind of request, with answers of every kind.
std::vector<Request> manyRequests() {
  std::vector<Request> all{select("behavior", "obey"),
                           select("behavior", "dance"),
                           select("ball-percept", "broken"),
                           select("ball-percept", "untidy"),
                           select("ball-model", "oracle"),
                           select("flying", "high"),
                           getParameters("ball-percept", "region"),
                           getParameters("ball-percept", ""),
                           getParameters("motion", "walk"),
                           getParameters("motion", ""),
                           setParameters("motion", "", 7),
                           getParameters("ball-percept", "x"),
                           setParameters("ball-percept", "region", 7),
                           setParameters("ball-percept", "", 8),
                           setParameters("ball-percept", "region", 7, "robotcontrol.Pose2"),
                           setParameters("motion", "walk", 7),
                           setKey("ball-percept/dot", KeyMode::ALWAYS),
                           setKey("ball-percept/dott", KeyMode::ALWAYS),
                           setKey("ball-percept/dot", KeyMode::EVERY_N),
                           setKey("package/models/ball", KeyMode::N_TIMES, 3),
                           setKey("package/nothing", KeyMode::ALWAYS),
                           setKey("package/oracle/classes", KeyMode::ALWAYS),
                           colorTable("ten cells."),
                           colorTable("")};
  Request request;
  request.mutable_send_tables();
  all.push_back(request);
  request.mutable_record_packages()->add_packages("models/ball");
  all.push_back(request);
  request.mutable_motion();
  all.push_back(request);
  request.mutable_set_goal();
  all.push_back(request);
  request.mutable_stop();
  all.push_back(request);
  return all;
}

/// The content of the last message of a path.
template <typename T>
const T* last(const SharedDebugQueue& queue, const std::string& path) {
  const T* found = nullptr;
  for (const SharedDebugMessage& message : queue.messages) {
    if (message.path == path) found = message.as<T>();
  }
  return found;
}

}  // namespace

TEST(RequestPreview, givesTheAnswersThatTheProgramGivesWhenItRuns) {
  ToyRobot robot;
  robot.run(20);
  for (const Request& request : manyRequests()) {
    RequestPreview preview(*robot.program);
    const bool accepted = preview.answer(request);
    const auto queue = preview.takeQueue(robot.clock.now());
    ASSERT_NE(queue, nullptr);
    const auto real = robot.ask(request);
    EXPECT_EQ(accepted, real.accepted()) << request.ShortDebugString();
    const auto& foretold = *last<robotcontrol::RequestResult>(*queue, "results");
    EXPECT_EQ(foretold.reason(), real.reason()) << request.ShortDebugString();
    EXPECT_EQ(foretold.checksum(), real.checksum()) << request.ShortDebugString();
    for (const auto& message : queue->messages) EXPECT_TRUE(message.time.has_value());
  }
}

TEST(RequestPreview, eachRequestSeesWhatThoseBeforeItChange) {
  ToyRobot robot;
  RequestPreview preview(*robot.program);
  EXPECT_TRUE(preview.answer(setParameters("ball-percept", "region", 7)));
  EXPECT_TRUE(preview.answer(getParameters("ball-percept", "region")));
  EXPECT_TRUE(preview.answer(select("behavior", "obey")));
  EXPECT_TRUE(preview.answer(setKey("ball-percept/dot", KeyMode::EVERY_N, 4)));
  const auto queue = preview.takeQueue(robot.clock.now());
  robotcontrol::Velocity2 value;
  value.ParseFromString(
      last<robotcontrol::ParameterValues>(*queue, "parameters/ball-percept/region")->value().data());
  EXPECT_EQ(value.x(), 7);
  const auto& solutions = *last<robotcontrol::SolutionTable>(*queue, "tables/solutions");
  ASSERT_EQ(solutions.tasks_size(), 4);
  EXPECT_EQ(solutions.tasks(2).active(), "obey");
  EXPECT_EQ(solutions.tasks(2).default_solution(), "go");
  for (const auto& key : last<robotcontrol::KeyTable>(*queue, "tables/keys")->keys()) {
    const bool chosen = key.name() == "ball-percept/dot";
    EXPECT_EQ(key.mode().kind(), chosen ? KeyMode::EVERY_N : KeyMode::OFF) << key.name();
  }
  EXPECT_EQ(last<robotcontrol::ProcessTable>(*queue, "tables/processes")->processes_size(), 4)
      << "platform and processes";
  EXPECT_EQ(preview.takeQueue(robot.clock.now()), nullptr) << "it was taken";
}

TEST(RequestPreview, aPackageThatIsAskedForIsPublishedAtOnce) {
  ToyRobot robot;
  const auto published = [&](const char* key, KeyMode::Kind mode) {
    RequestPreview preview(*robot.program);
    EXPECT_TRUE(preview.answer(setKey(key, mode)));
    const auto queue = preview.takeQueue(robot.clock.now());
    return std::ranges::count_if(queue->messages, [](const auto& message) {
      return message.path == "models/ball" && message.content;
    });
  };
  EXPECT_EQ(published("package/models/ball", KeyMode::ALWAYS), 0) << "there is none yet";
  robot.run(20);
  EXPECT_EQ(published("package/models/ball", KeyMode::ALWAYS), 1);
  EXPECT_EQ(published("package/models/ball", KeyMode::OFF), 0);
  EXPECT_EQ(published("ball-percept/dot", KeyMode::ALWAYS), 0);
}

TEST(RequestPreview, changesNothingOfWhatTheProgramDoesAndPublishes) {
  ToyRobot looked, other;
  for (ToyRobot* robot : {&looked, &other}) {
    robot->run(20);
    for (const Request& request : manyRequests()) robot->program->debugProcess().request(request);
  }
  const int before = livingSolutions();
  RequestPreview preview(*looked.program);
  for (const Request& request : manyRequests()) preview.answer(request);
  EXPECT_NE(preview.takeQueue(looked.clock.now()), nullptr);
  EXPECT_EQ(livingSolutions(), before) << "what was made to see whether it can be is gone";
  for (ToyRobot* robot : {&looked, &other}) robot->run(50);
  EXPECT_EQ(looked.platform.requests(), other.platform.requests());
  ASSERT_EQ(looked.heard.size(), other.heard.size());
  for (std::size_t i = 0; i < looked.heard.size(); ++i) {
    EXPECT_EQ(looked.heard[i].SerializeAsString(), other.heard[i].SerializeAsString()) << i;
  }
}

TEST(RequestPreview, aProcessThatHasFailedRefusesWithItsReason) {
  ToyRobot robot;
  ASSERT_TRUE(robot.select("ball-model", "throwing").accepted());
  robot.run(20);
  RequestPreview preview(*robot.program);
  EXPECT_EQ(preview.add(select("behavior", "obey")), robot.select("behavior", "obey").reason());
  EXPECT_NE(preview.add(select("behavior", "obey")).find("no covariance"), std::string::npos);
}

TEST(RequestPreview, aPackageOfThePlatformIsPublishedAlthoughNoTaskReadsIt) {
  ToyRobot robot;
  const auto published = [&] {
    RequestPreview preview(*robot.program);
    EXPECT_TRUE(preview.answer(setKey("package/oracle/classes", KeyMode::ALWAYS)));
    const auto queue = preview.takeQueue(robot.clock.now());
    return last<foxglove::RawImage>(*queue, "oracle/classes") != nullptr;
  };
  EXPECT_FALSE(published()) << "it is only made for those who receive it";
  ASSERT_TRUE(robot.setKey("package/oracle/classes", KeyMode::ALWAYS).accepted());
  robot.run(20);
  ASSERT_TRUE(robot.setKey("package/oracle/classes", KeyMode::OFF).accepted());
  EXPECT_TRUE(published());
}
