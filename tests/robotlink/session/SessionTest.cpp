// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/Session.h"

#include <gmock/gmock.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/timestamp.pb.h>

#include <atomic>
#include <random>
#include <thread>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/robotlink/session/SessionMessages.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::DebugMessage;
using robotcontrol::DebugQueue;
using testing::ElementsAre;

TEST(Session, whatIsPushedIsInTheHistoryAfterTheTick) {
  Session session;
  session.push(plot("red1/camera/image", 2));
  EXPECT_EQ(session.store().find("red1/camera/image"), nullptr);
  session.tick();
  EXPECT_NE(session.store().latest("red1/camera/image", at(2)), nullptr);
  EXPECT_EQ(session.timeline().shown(), at(2));
}

TEST(Session, theTimelineFollowsTheNewestUntilAnInstantIsChosen) {
  Session session;
  session.push(plot("a", 1));
  session.tick();
  session.timeline().show(at(0.5));
  session.push(plot("a", 2));
  session.tick();
  EXPECT_EQ(session.timeline().shown(), at(0.5));
  EXPECT_EQ(session.timeline().newest(), at(2));
  session.timeline().goLive();
  EXPECT_EQ(session.timeline().shown(), at(2));
}

TEST(Session, allListenersFollowUntilTheyAreRemoved) {
  Session session;
  std::vector<std::string> heard;
  const auto listener = [&heard](const std::string& name) {
    return Session::Listener{
        [&heard, name](const StreamMessage& message) { heard.push_back(name + ": " + message.path); },
        [&heard, name](const robotcontrol::Request&) { heard.push_back(name + ": request"); },
        [&heard, name](const robotcontrol::RequestResult&) { heard.push_back(name + ": result"); }};
  };
  const auto first = session.addListener(listener("first"));
  session.addListener(listener("second"));
  session.push(plot("a", 1));
  session.tick();
  EXPECT_THAT(heard, ElementsAre("first: a", "second: a"));
  heard.clear();
  session.removeListener(first);
  session.request({});
  EXPECT_THAT(heard, ElementsAre("second: request"));
  session.tick();
  EXPECT_THAT(heard, ElementsAre("second: request", "second: result"));
}

TEST(Session, aLineIsCutWhereAGapLiesBetweenItsEnds) {
  const std::vector<LineGap> gaps{{at(2), at(5)}, {at(9)}};
  EXPECT_FALSE(isCut(gaps, at(1), at(2)));
  EXPECT_TRUE(isCut(gaps, at(2), at(5)));
  EXPECT_TRUE(isCut(gaps, at(1.5), at(6)));
  EXPECT_FALSE(isCut(gaps, at(5), at(6)));
  EXPECT_TRUE(isCut(gaps, at(8), at(12)));
}

TEST(Session, aQueuesMessagesBecomeStreamsWithoutBeingCopied) {
  Session session;
  const auto queue = queueOf("cognition");
  add(*queue, "log", 1).mutable_text()->set_message("hello");
  add(*queue, "drawings/image/ball-percept/circle", 1).mutable_image_drawing();
  add(*queue, "drawings/field/ball-model/position", 1).mutable_scene_drawing();
  add(*queue, "images/segmentation/classes", 1).mutable_image();
  add(*queue, "plots/ball-model/distance", 1).mutable_plot();
  add(*queue, "stopwatches/cognition", 1).mutable_stopwatches();
  add(*queue, "tables/keys", 1).mutable_keys();
  add(*queue, "tables/solutions", 1).mutable_solutions();
  add(*queue, "tables/processes", 1).mutable_processes();
  add(*queue, "parameters/ball-percept/scan-lines", 1).mutable_parameters();
  endFrame(*queue, 1, 42);
  const auto shared = fromWire(*queue);
  session.pushQueue("red1", shared);
  session.tick();
  EXPECT_EQ(session.store().streams("red1/").size(), 11U);
  const StreamMessage* text = session.store().latest("red1/log", at(1));
  ASSERT_NE(text, nullptr);
  EXPECT_EQ(text->value, shared->messages[0].content);
  EXPECT_EQ(text->process, "cognition");
  EXPECT_EQ(text->frame, 42U);
  EXPECT_EQ(session.store().find("red1/images/segmentation/classes")->type, "foxglove.RawImage");
  EXPECT_EQ(session.store().find("red1/frames/cognition")->type, "robotcontrol.FrameInfo");
  EXPECT_EQ(session.dropped(), 0U);
}

TEST(Session, eachMessageKnowsTheFrameThatEndsAfterIt) {
  Session session;
  const auto queue = queueOf("cognition");
  add(*queue, "plots/a", 1).mutable_plot();
  endFrame(*queue, 1, 5);
  add(*queue, "plots/a", 2).mutable_plot();
  endFrame(*queue, 2, 6);
  add(*queue, "plots/a", 3).mutable_plot();
  session.pushQueue("red1", fromWire(*queue));
  session.tick();
  std::vector<std::uint64_t> frames;
  for (const auto& message : session.store().find("red1/plots/a")->messages) frames.push_back(message.frame);
  EXPECT_THAT(frames, ElementsAre(5, 6, 0));
}

TEST(Session, copiesOfPackagesAreReadIntoTheirTypes) {
  Session session;
  robotcontrol::BallModel ball;
  ball.mutable_position_in_robot()->set_x(1.5);
  const auto queue = queueOf("cognition");
  auto& copy = *add(*queue, "models/ball", 1).mutable_package();
  copy.set_type("robotcontrol.BallModel");
  copy.set_data(ball.SerializeAsString());
  add(*queue, "strange", 1).mutable_package()->set_type("somebody.Elses");
  auto& damaged = *add(*queue, "damaged", 1).mutable_package();
  damaged.set_type("robotcontrol.BallModel");
  damaged.set_data("\xff\xff\xff");
  session.pushQueue("red1", fromWire(*queue));
  session.tick();
  const auto* model = session.store().latestAs<robotcontrol::BallModel>("red1/models/ball", at(1));
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->position_in_robot().x(), 1.5);
  EXPECT_EQ(session.store().find("red1/strange")->type, "robotcontrol.PackageCopy");
  EXPECT_EQ(session.store().find("red1/damaged")->type, "robotcontrol.PackageCopy");
}

TEST(Session, whenNobodyTicksWholeQueuesAreDroppedOldestFirstAndCounted) {
  Session session({}, {.messages = 10, .bytes = 1U << 20U});
  for (int i = 1; i <= 5; ++i) {
    const auto queue = queueOf("cognition");
    add(*queue, "plots/a", i).mutable_plot();
    add(*queue, "plots/b", i).mutable_plot();
    endFrame(*queue, i, static_cast<std::uint64_t>(i));
    session.pushQueue("red1", fromWire(*queue));
  }
  EXPECT_EQ(session.dropped(), 6U);
  session.tick();
  EXPECT_EQ(session.store().find("red1/plots/a")->messages.front().time, at(3));
  EXPECT_EQ(session.store().find("red1/plots/b")->messages.front().time, at(3));
}

TEST(Session, theInboxIsBoundedInBytesToo) {
  Session session({}, {.messages = 1000, .bytes = 10'000});
  for (int i = 1; i <= 20; ++i) session.push(plot("a", i, 1000));
  session.tick();
  EXPECT_LE(session.store().find("a")->messages.size(), 9U);
  EXPECT_EQ(session.store().find("a")->messages.back().time, at(20));
  EXPECT_EQ(session.dropped(), 20 - session.store().find("a")->messages.size());
}

TEST(Session, tablesAreNeverDropped) {
  Session session({}, {.messages = 10, .bytes = 1U << 20U});
  const auto queue = queueOf("cognition");
  add(*queue, "tables/keys", 1).mutable_keys()->add_keys()->set_name("ball-percept/circle");
  add(*queue, "tables/solutions", 1).mutable_solutions();
  add(*queue, "images/a", 1).mutable_image();
  auto shared = fromWire(*queue);
  const std::weak_ptr<const google::protobuf::Message> image = shared->messages.back().content;
  session.pushQueue("red1", std::exchange(shared, nullptr));
  for (int i = 2; i < 40; ++i) session.push(plot("a", i));
  session.tick();
  const auto* keys = session.store().latestAs<robotcontrol::KeyTable>("red1/tables/keys", at(40));
  ASSERT_NE(keys, nullptr);
  EXPECT_EQ(keys->keys(0).name(), "ball-percept/circle");
  EXPECT_NE(session.store().find("red1/tables/solutions"), nullptr);
  EXPECT_TRUE(image.expired()) << "what was dropped with them is not kept in memory";
}

TEST(Session, theSceneAndOtherLatchedMessagesAreNeverDropped) {
  Session session({}, {.messages = 4});
  session.push({"scene", at(1), std::make_shared<foxglove::SceneUpdate>()});
  session.push({"map", at(1), std::make_shared<robotcontrol::GroundMap>()});
  session.push({"red1/program", at(1), std::make_shared<robotcontrol::ProgramSetup>()});
  for (int i = 0; i < 20; ++i) session.push(plot("red1/plots/a", 2 + i));
  session.tick();
  for (const char* path : {"scene", "map", "red1/program"}) {
    EXPECT_NE(session.store().latest(path, at(30)), nullptr) << path;
  }
  EXPECT_EQ(session.dropped(), 16U) << "plots, and nothing else";
}

TEST(Session, whatTheRobotsQueuesDroppedIsCountedOverRestarts) {
  Session session;
  for (const std::uint64_t dropped : {3U, 10U, 2U}) {  // the process was restarted after the second
    const auto queue = queueOf("cognition");
    queue->set_dropped(dropped);
    session.pushQueue("red1", fromWire(*queue));
  }
  const auto other = queueOf("motion");
  other->set_dropped(100);
  session.pushQueue("red1", fromWire(*other));
  EXPECT_EQ(session.dropped(), 112U);
}

TEST(Session, aResultComesBackOnceAndOnlyInTheTick) {
  Session session;
  std::vector<std::uint64_t> asked;
  session.setRequestSink([&](const robotcontrol::Request& request) { asked.push_back(request.id()); });
  std::vector<std::string> answers;
  robotcontrol::Request request;
  request.mutable_stop()->set_engaged(true);
  const auto id = session.request(request, [&](const auto& result) { answers.push_back(result.reason()); });
  EXPECT_THAT(asked, ElementsAre(id));
  const auto queue = queueOf("debug");
  auto& result = *add(*queue, "results", 1).mutable_result();
  result.set_id(id);
  result.set_reason("because");
  session.pushQueue("red1", fromWire(*queue));
  session.pushResult(result);
  EXPECT_TRUE(answers.empty());
  session.tick();
  EXPECT_THAT(answers, ElementsAre("because"));
  session.pushResult(result);
  session.tick();
  EXPECT_EQ(answers.size(), 1U);
}

TEST(Session, whatASinkAnswersAtOnceIsNotLost) {
  Session session;
  session.setRequestSink([&](const robotcontrol::Request& request) {
    robotcontrol::RequestResult result;
    result.set_id(request.id());
    result.set_accepted(true);
    session.pushResult(result);
  });
  int accepted = 0;
  session.request({}, [&](const auto& result) {
    accepted += result.accepted() ? 1 : 0;
    session.request({}, [&](const auto&) { accepted += 10; });  // a handler may ask again
  });
  session.tick();
  EXPECT_EQ(accepted, 1);
  session.tick();
  EXPECT_EQ(accepted, 11);
}

TEST(Session, withoutASinkARequestIsRefusedWithAReason) {
  Session session;
  std::string reason;
  session.request({}, [&](const auto& result) { reason = result.reason(); });
  session.tick();
  EXPECT_THAT(reason, testing::HasSubstr("nothing that is open"));
}

TEST(Session, aRefusalThatNobodyWaitsForIsReportedToTheHandler) {
  Session session;
  session.setRequestSink([&](const robotcontrol::Request& request) {
    robotcontrol::RequestResult result;
    result.set_id(request.id());
    result.set_accepted(request.has_send_tables());
    result.set_reason("the process has failed");
    session.pushResult(result);
  });
  std::vector<std::string> reported;
  session.setRefusalHandler(
      [&](const std::string& what, const std::string& why) { reported.push_back(what + ": " + why); });
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name("a/b");
  session.request(request);
  session.request(request, [](const auto&) {});  // somebody waits
  request.mutable_send_tables();                 // is accepted
  session.request(request);
  request.clear_robot();
  request.mutable_control_simulation();
  session.request(request);
  EXPECT_TRUE(reported.empty()) << "only from the tick";
  session.tick();
  EXPECT_THAT(reported, ElementsAre("set key of red1: the process has failed",
                                    "control simulation: the process has failed"));
}

TEST(Session, theSelectedRobotIsAlwaysOneOfTheRobots) {
  Session session;
  EXPECT_EQ(session.selectedRobot(), "");
  session.setRobots({"red1", "blue1"});
  EXPECT_EQ(session.selectedRobot(), "red1");
  session.selectRobot("green1");
  EXPECT_EQ(session.selectedRobot(), "red1");
  session.selectRobot("blue1");
  session.setRobots({"blue2", "blue1"});
  EXPECT_EQ(session.selectedRobot(), "blue1");
  session.setRobots({"red7"});
  EXPECT_EQ(session.selectedRobot(), "red7");
  session.setRobots({});
  EXPECT_EQ(session.selectedRobot(), "");
}

TEST(Session, messagesThatMakeNoSenseAreDroppedAndCounted) {
  Session session;
  const auto queue = queueOf("cognition");
  add(*queue, "", 1).mutable_plot();
  add(*queue, std::string(100'000, 'x'), 1).mutable_plot();
  add(*queue, "nothing", 1);
  add(*queue, "plots/a", 1).mutable_plot();
  session.pushQueue("red1", fromWire(*queue));
  session.pushQueue("red1", nullptr);
  session.push({"no-value", at(1), nullptr});
  session.tick();
  EXPECT_EQ(session.dropped(), 3U);
  EXPECT_EQ(session.store().streams().size(), 1U);
}

TEST(Session, timesThatCannotBeAreReplacedByThoseOfTheNeighbors) {
  Session session;
  session.push(plot("red1/clock", 3));
  const auto queue = queueOf("cognition");
  add(*queue, "plots/far", 0).mutable_timestamp()->set_seconds(std::numeric_limits<std::int64_t>::max());
  add(*queue, "plots/valid", 4);
  add(*queue, "plots/nanos", 0).mutable_timestamp()->set_nanos(-5);
  queue->add_messages()->set_path("plots/none");
  for (auto& message : *queue->mutable_messages()) message.mutable_plot();
  session.pushQueue("red1", fromWire(*queue));
  session.tick();
  EXPECT_EQ(session.store().latest("red1/plots/far", at(10))->time, at(3));
  EXPECT_EQ(session.store().latest("red1/plots/valid", at(10))->time, at(4));
  EXPECT_EQ(session.store().latest("red1/plots/nanos", at(10))->time, at(4));
  EXPECT_EQ(session.store().latest("red1/plots/none", at(10))->time, at(4));
}

TEST(Session, aTimeStampThatDoesNotFitIsBroughtToOneThatDoes) {
  google::protobuf::Timestamp stamp;
  stamp.set_seconds(std::numeric_limits<std::int64_t>::max());
  stamp.set_nanos(std::numeric_limits<std::int32_t>::max());
  const Instant late = instant(stamp);
  stamp.set_seconds(std::numeric_limits<std::int64_t>::min());
  stamp.set_nanos(std::numeric_limits<std::int32_t>::min());
  EXPECT_GT(late - instant(stamp), Duration::zero()) << "their difference fits, too";
}

TEST(Session, garbageThatParsesNeverBreaksIt) {
  // Valid queues with bytes flipped, as a faulty or hostile link would deliver them.
  const google::protobuf::LogSilencer quiet;
  const auto original = queueOf("cognition");
  add(*original, "plots/a", 1).mutable_plot()->set_value(3);
  add(*original, "images/b", 1).mutable_image()->set_width(1U << 31U);
  add(*original, "models/ball", 1).mutable_package()->set_type("robotcontrol.BallModel");
  add(*original, "results", 1).mutable_result()->set_id(7);
  endFrame(*original, 1, 1);
  const std::string bytes = original->SerializeAsString();
  std::mt19937 random(1);
  Session session({.bytes = 1U << 20U, .streams = 50}, {.messages = 100, .bytes = 1U << 16U});
  int parsed = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string damaged = bytes;
    for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    const auto queue = std::make_shared<DebugQueue>();
    if (!queue->ParseFromString(damaged)) continue;
    ++parsed;
    session.pushQueue("red1", fromWire(*queue));
    if (round % 7 == 0) session.tick();
  }
  session.tick();
  EXPECT_GT(parsed, 1000);
  EXPECT_LE(session.store().streams().size(), 50U);
  EXPECT_LE(session.store().bytes(), (1U << 20U) + 50 * 1024U);
}

TEST(Session, severalThreadsPushWhileItTicks) {
  constexpr int kThreads = 4, kQueues = 200;
  Session session;
  std::atomic<int> running{kThreads};
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&session, &running, t] {
      const std::string robot = "red" + std::to_string(t);
      for (int i = 1; i <= kQueues; ++i) {
        const auto queue = queueOf("cognition");
        add(*queue, "plots/a", i * 0.01).mutable_plot();
        endFrame(*queue, i * 0.01, static_cast<std::uint64_t>(i));
        session.pushQueue(robot, fromWire(*queue));
        session.push(plot(robot + "/body/sensors", i * 0.01));
        robotcontrol::RequestResult result;
        result.set_id(static_cast<std::uint64_t>(i));
        session.pushResult(result);
      }
      --running;
    });
  }
  int answers = 0;
  while (running > 0) {
    session.tick();
    if (answers < 50) session.request({}, [&](const auto&) { ++answers; });
    (void)session.dropped();
  }
  for (auto& thread : threads) thread.join();
  session.tick();
  for (int t = 0; t < kThreads; ++t) {
    const std::string robot = "red" + std::to_string(t);
    EXPECT_EQ(session.store().find(robot + "/plots/a")->count, static_cast<std::uint64_t>(kQueues));
    EXPECT_EQ(session.store().find(robot + "/body/sensors")->count, static_cast<std::uint64_t>(kQueues));
  }
}
