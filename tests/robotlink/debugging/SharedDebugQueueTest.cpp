// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/SharedDebugQueue.h"

#include <gtest/gtest.h>

#include <set>

#include "foxglove/Scene.pb.h"
#include "robotlink/debugging/DebugContext.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/QueueMessages.h"
#include "robotlink/session/Session.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;

namespace {

const ImageKey kPictureKey{"shared-queue-test/picture", "An image"};

KeyMode always() {
  KeyMode mode;
  mode.set_kind(KeyMode::ALWAYS);
  return mode;
}

/// A toy robot whose queues go to a session, and all that its processes send.
struct SharedWorld {
  SharedWorld() {
    robot.program->debugProcess().setListener([this](auto queue) { session.pushQueue("red1", queue); });
    listenTo(robot.platform);
    for (const Process* process : robot.program->processes()) listenTo(*process);
  }
  void listenTo(const Process& process) {
    for (AnySender* sender : process.senders())
      sender->addTap([this](const PackagePtr& package) { sent.insert(package); });
  }
  void show(const std::string& package) {
    robotcontrol::Request request;
    request.mutable_set_key()->set_name("package/" + package);
    *request.mutable_set_key()->mutable_mode() = always();
    robot.program->debugProcess().request(request);
  }
  std::vector<PackagePtr> shown(const std::string& package) {
    session.tick();
    std::vector<PackagePtr> values;
    if (const auto* stream = session.store().find("red1/" + package)) {
      for (const StreamMessage& message : stream->messages) values.push_back(message.value);
    }
    return values;
  }

  std::set<PackagePtr> sent;
  Session session;
  ToyRobot robot;
};

/// One message of each kind.
std::shared_ptr<SharedDebugQueue> queueOfAllKinds() {
  const auto queue = std::make_shared<SharedDebugQueue>();
  queue->process = "cognition";
  queue->dropped = 3;
  queue->number = 7;
  queue->requestsDone = 2;
  queue->requestDone = 41;
  queue->add<foxglove::Log>("log", Instant(std::chrono::milliseconds(-1))).set_message("hello");
  queue->add<foxglove::ImageAnnotations>("drawings/image/a", Instant());
  queue->add<foxglove::SceneUpdate>("drawings/field/a", Instant());
  queue->add<foxglove::RawImage>("images/a", Instant(std::chrono::hours(500'000))).set_data("pixels");
  queue->add<robotcontrol::PlotValue>("plots/a").set_value(4);
  queue->add<robotcontrol::RequestResult>("results", Instant()).set_id(5);
  queue->add<robotcontrol::BallModel>("models/ball", Instant()).set_known(true);
  queue->messages.back().onlyRecorded = true;
  queue->add<robotcontrol::FrameInfo>("frames/cognition", Instant()).set_number(9);
  return queue;
}

void expectSame(const SharedDebugQueue& a, const SharedDebugQueue& b) {
  EXPECT_EQ(a.process, b.process);
  EXPECT_EQ(a.dropped, b.dropped);
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.requestsDone, b.requestsDone);
  EXPECT_EQ(a.requestDone, b.requestDone);
  ASSERT_EQ(a.messages.size(), b.messages.size());
  for (std::size_t i = 0; i < a.messages.size(); ++i) {
    const SharedDebugMessage &one = a.messages[i], &other = b.messages[i];
    EXPECT_EQ(one.path, other.path);
    EXPECT_EQ(one.time, other.time) << one.path;
    EXPECT_EQ(one.onlyRecorded, other.onlyRecorded) << one.path;
    ASSERT_EQ(one.content->GetDescriptor(), other.content->GetDescriptor()) << one.path;
    EXPECT_EQ(one.content->SerializeAsString(), other.content->SerializeAsString()) << one.path;
  }
}

}  // namespace

TEST(SharedDebugQueue, aPackageThatAKeyShowsIsTheVeryObjectThatWasSentUntilItIsInTheSession) {
  SharedWorld world;
  // An image and a package of a task, and an image that the platform makes on request.
  for (const char* package : {"camera/image", "models/ball", "oracle/classes"}) world.show(package);
  world.robot.run(60);
  for (const char* package : {"camera/image", "models/ball", "oracle/classes"}) {
    const auto shown = world.shown(package);
    ASSERT_GT(shown.size(), 3U) << package;
    for (const PackagePtr& value : shown) EXPECT_TRUE(world.sent.contains(value)) << package;
  }
}

TEST(SharedDebugQueue, anImageOfAKeyIsCopiedOnceWhenItIsPublished) {
  const ManualClock clock;
  DebugContext debug("cognition", clock, {});
  Session session;
  debug.image(kPictureKey, Image(8, 2, PixelFormat::kMono8).view());
  debug.endFrame();
  const auto queue = debug.takeQueue();
  const PackagePtr published = queue->messages.front().content;
  session.pushQueue("red1", queue);
  session.tick();
  EXPECT_EQ(session.store().latest("red1/images/shared-queue-test/picture", clock.now())->value, published);
}

TEST(SharedDebugQueue, aMessageThatIsKeptDoesNotKeepTheOthersAlive) {
  Session session({.age = std::chrono::seconds(2)});
  auto queue = std::make_shared<SharedDebugQueue>();
  queue->add<foxglove::Log>("log", Instant()).set_message("kept, as it is the last one");
  queue->add<foxglove::RawImage>("images/a", Instant());
  const std::weak_ptr<const google::protobuf::Message> text = queue->messages[0].content,
                                                       image = queue->messages[1].content;
  session.pushQueue("red1", queue);
  queue.reset();
  for (int i = 1; i <= 50; ++i) {
    queue = std::make_shared<SharedDebugQueue>();
    queue->add<foxglove::RawImage>("images/a", Instant(std::chrono::milliseconds(100 * i)));
    session.pushQueue("red1", queue);
  }
  session.tick();
  EXPECT_FALSE(text.expired());
  EXPECT_TRUE(image.expired());
}

TEST(SharedDebugQueue, survivesItsWayOverAWire) {
  const auto queue = queueOfAllKinds();
  const robotcontrol::DebugQueue wire = toWire(*queue);
  EXPECT_EQ(wire.messages(0).text().message(), "hello");
  EXPECT_EQ(wire.messages(3).image().data(), "pixels");
  EXPECT_EQ(wire.messages(6).package().type(), "robotcontrol.BallModel");
  robotcontrol::DebugQueue received;
  ASSERT_TRUE(received.ParseFromString(wire.SerializeAsString()));
  expectSame(*fromWire(received), *queue);
}

TEST(SharedDebugQueue, isAnOrdinaryPackageThatBecomesBytesOnALinkOnly) {
  const std::shared_ptr<const SharedDebugQueue> queue = queueOfAllKinds();
  const PackagePtr package = packageOf(queue);
  EXPECT_EQ(package->GetDescriptor(), robotcontrol::DebugQueue::descriptor());
  EXPECT_EQ(static_cast<const robotcontrol::DebugQueue&>(*package).number(), 7U);
  EXPECT_EQ(queueIn(package), queue) << "inside a program it is passed on";
  const PackagePtr written = wireForm(package);
  EXPECT_EQ(written->SerializeAsString(), toWire(*queue).SerializeAsString());
  expectSame(*queueIn(written), *queue);
  EXPECT_EQ(wireForm(written), written);
  EXPECT_EQ(queueIn(std::make_shared<foxglove::Log>()), nullptr);
}

TEST(SharedDebugQueue, whatCannotBeReadFromAWireIsLeftOut) {
  robotcontrol::DebugQueue wire;
  wire.add_messages()->set_path("nothing");
  auto& late = *wire.add_messages();
  late.mutable_timestamp()->set_seconds(std::numeric_limits<std::int64_t>::max());
  late.mutable_package()->set_type("robotcontrol.BallModel");
  late.mutable_package()->set_data("\xff\xff\xff");
  const auto queue = fromWire(wire);
  ASSERT_EQ(queue->messages.size(), 2U);
  EXPECT_EQ(queue->messages[0].content, nullptr);
  EXPECT_FALSE(queue->messages[1].time.has_value());
  ASSERT_NE(queue->messages[1].as<robotcontrol::PackageCopy>(), nullptr);
  EXPECT_EQ(queue->messages[1].as<robotcontrol::PackageCopy>()->data(), "\xff\xff\xff");
}

// What the session and the recorder get, in paths, times, frames and bytes.
TEST(SharedDebugQueue, aProgramsQueuesReadTheSameAsIfTheyHadComeOverAWire) {
  ToyRobot robot;
  robot.program->recordPackages({"percepts/ball", "motion/status"});
  robot.program->setKeys({{"package/camera/image", always()}, {"package/models/ball", always()}});
  std::size_t compared = 0;
  robot.program->debugProcess().setListener([&](const auto& queue) {
    const auto read = fromWire(toWire(*queue));
    for (const QueueReader reader : {QueueReader::kViews, QueueReader::kRecorder}) {
      const auto here = messagesOf("red1", *queue, {}, reader).messages;
      const auto there = messagesOf("red1", *read, {}, reader).messages;
      ASSERT_EQ(here.size(), there.size());
      for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_EQ(here[i].path, there[i].path);
        EXPECT_EQ(here[i].time, there[i].time);
        EXPECT_EQ(here[i].process, there[i].process);
        EXPECT_EQ(here[i].frame, there[i].frame);
        EXPECT_EQ(here[i].value->GetDescriptor(), there[i].value->GetDescriptor());
        EXPECT_EQ(here[i].value->SerializeAsString(), there[i].value->SerializeAsString());
      }
      compared += here.size();
    }
  });
  robot.run(60);
  EXPECT_GT(compared, 200U);
}
