// SPDX-License-Identifier: GPL-3.0-or-later
// Robots whose bodies are at the far end of a line, which is cut and found again, and whose programs run
// here.
#include "app/core/body/BodyFeed.h"

#include <gmock/gmock.h>

#include <future>
#include <sstream>

#include "app/core/ServedPlatform.h"
#include "app/core/body/BodyProgram.h"
#include "app/core/simulated/SimulationFeed.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Resources.h"
#include "tests/Eventually.h"
#include "tests/robotlink/foxglove/Relay.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotlink::websocket::test::Relay;
using testing::HasSubstr;

/// Prints until the port is known.
class PortLine : public std::stringbuf {
 public:
  std::uint16_t wait() { return port_.get_future().get(); }

 protected:
  int sync() override {
    const std::string text = str();
    const std::size_t address = text.find("ws://");
    if (isTold_ || address == std::string::npos || text.find('\n', address) == std::string::npos) return 0;
    isTold_ = true;
    port_.set_value(static_cast<std::uint16_t>(std::stoi(text.substr(text.find(':', address + 5) + 1))));
    return 0;
  }

 private:
  std::promise<std::uint16_t> port_;
  bool isTold_ = false;
};

RunOptions bodies(const std::string& scene, const std::shared_ptr<BodyInbox>& inbox) {
  RunOptions options = defaultSimulation();
  options.scene = robotlink::resource(scene);
  options.instead = BodyProgram::maker({.inbox = inbox});
  return options;
}

/// The bodies of a scene, offered at a port of this machine.
class OfferedBodies {
 public:
  explicit OfferedBodies(const std::string& scene)
      : served_(std::async(std::launch::async,
                           [this, scene] {
                             return serve(
                                 SimulationFeed::opening(bodies(scene, inbox_)),
                                 {.address = {"127.0.0.1", 0}, .bodies = inbox_}, recorder_,
                                 [this] { return isOver_.load(); }, out_);
                           })),
        port_(printed_.wait()) {}
  ~OfferedBodies() {
    isOver_ = true;
    EXPECT_TRUE(served_.get().empty());
  }
  std::uint16_t port() const { return port_; }

 private:
  const std::shared_ptr<BodyInbox> inbox_ = std::make_shared<BodyInbox>();
  PortLine printed_;
  std::ostream out_{&printed_};
  logplayer::Recorder recorder_{{}};
  std::atomic<bool> isOver_{false};
  std::future<robotlink::Errors> served_;
  std::uint16_t port_;
};

std::string urlOf(std::uint16_t port) {
  return "ws://127.0.0.1:" + std::to_string(port);
}

/// A program here for a body there, stepped by the test, and somebody at the body who watches it.
class Desk {
 public:
  Desk(BodyOptions options, std::uint16_t bodyPort) : watcher_(watching(bodyPort)) {
    options.patience = 30s;
    session_.addListener({[this](const robotlink::StreamMessage& message) { note(message); }, {}});
    auto feed = BodyFeed::create(std::move(options), session_, recorder_);
    EXPECT_TRUE(feed) << robotlink::describe(feed.error());
    if (!feed) return;
    feed_ = std::move(*feed);
    feed_->begin();
  }

  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      feed_->step();
      session_.tick();
      watcher_.tick();
      if (const auto arrived = watcher_.take(); arrived.state) state_ = arrived.state;
      return condition();
    });
  }
  template <typename T>
  const T* newest(const std::string& path) {
    return session_.store().latestAs<T>(path, robotlink::Instant::max());
  }
  void ask(robotcontrol::Request request) {
    request.set_robot(feed_->describe().robots.begin()->first);
    const auto done = feed_->fulfil(request);
    EXPECT_TRUE(done) << done.error().text;
  }
  /// Makes a package of the program visible.
  void show(const std::string& package) {
    robotcontrol::Request request;
    request.mutable_set_key()->set_name("package/" + package);
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    ask(request);
  }
  /// What somebody at the body sees.
  bool bodyStands() const { return state_ && state_->stands(); }
  bool bodyMoves() const { return state_ && !state_->stands(); }
  bool bodyIsStopped() const { return state_ && state_->stop_engaged(); }
  bool said(const std::string& text) const { return texts_.find(text) != std::string::npos; }
  BodyFeed& feed() { return *feed_; }

 private:
  static BodyLink::Options watching(std::uint16_t port) {
    BodyLink::Options options;
    options.connection.url = *robotlink::websocket::parseServerUrl(urlOf(port));
    return options;
  }
  void note(const robotlink::StreamMessage& message) {
    if (const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get()))
      texts_ += text->message() + "\n";
  }

  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  BodyLink watcher_;
  std::shared_ptr<const robotcontrol::BodyState> state_;
  std::string texts_;
  std::unique_ptr<BodyFeed> feed_;
};

/// How far the ERS-210 is from where it was seen first.
class Way {
 public:
  explicit Way(Desk& desk) : desk_(desk) {}
  double length() {
    const auto* world = desk_.newest<robotcontrol::OracleWorld>("red1/oracle/world");
    if (world == nullptr) return 0;
    const auto& position = world->robot_in_field();
    if (!begin_) begin_ = std::pair(position.x(), position.y());
    return std::hypot(position.x() - begin_->first, position.y() - begin_->second);
  }

 private:
  Desk& desk_;
  std::optional<std::pair<double, double>> begin_;
};

TEST(BodyFeed, anErs210WalksByAProgramHereAndStandsWhileTheLineIsCut) {
  OfferedBodies hall("scenes/field2002.sdf");
  Relay relay(hall.port(), {});
  Desk desk({.url = urlOf(relay.port())}, hall.port());
  desk.show("oracle/world");
  Way way(desk);
  ASSERT_TRUE(desk.soon([&] { return way.length() > 0.05; }));
  EXPECT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  EXPECT_TRUE(desk.said("It stands when no command comes in time for 0.5 s"));

  relay.set(Relay::State::kSilent);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyStands(); }));
  EXPECT_TRUE(desk.soon([&] { return desk.said("is out of reach"); }));
  EXPECT_GE(desk.feed().platform().counts().cuts, 1U);

  relay.set(Relay::State::kOpen);
  EXPECT_TRUE(desk.soon([&] { return desk.said("is within reach again"); }));
  EXPECT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  Way again(desk);
  EXPECT_TRUE(desk.soon([&] { return again.length() > 0.05; }));
}

TEST(BodyFeed, stopActsAtTheBodyAndIsReleasedThere) {
  OfferedBodies hall("scenes/field2002.sdf");
  Desk desk({.url = urlOf(hall.port())}, hall.port());
  ASSERT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  desk.feed().stopSwitch()->engage("red1", true);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyIsStopped() && desk.bodyStands(); }));
  EXPECT_TRUE(desk.feed().platform().stopEngaged());
  desk.feed().stopSwitch()->engage("red1", false);
  EXPECT_TRUE(desk.soon([&] { return !desk.bodyIsStopped() && desk.bodyMoves(); }));
  EXPECT_TRUE(desk.soon([&] { return !desk.feed().platform().stopEngaged(); }));
}

TEST(BodyFeed, stopThatIsPressedDuringACutActsAfterIt) {
  OfferedBodies hall("scenes/field2002.sdf");
  Relay relay(hall.port(), {});
  Desk desk({.url = urlOf(relay.port())}, hall.port());
  ASSERT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  relay.set(Relay::State::kCut);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyStands() && desk.said("is out of reach"); }));
  desk.feed().stopSwitch()->engage("red1", true);
  relay.set(Relay::State::kOpen);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyIsStopped(); }));
}

TEST(BodyFeed, aPioneerDrivesByAProgramHere) {
  OfferedBodies hall("scenes/pioneer.sdf");
  Desk desk({.url = urlOf(hall.port()), .solutions = {{"driving", "obey"}}}, hall.port());
  const std::string robot = desk.feed().describe().robots.begin()->first;
  desk.show("drive/state");
  const auto state = [&] { return desk.newest<robotcontrol::DriveState>(robot + "/drive/state"); };
  ASSERT_TRUE(desk.soon([&] { return state() != nullptr; }));
  robotcontrol::Request motors;
  motors.mutable_control_drive()->set_motors(true);
  desk.ask(motors);
  const double begin = state()->odometry().x();
  auto asked = std::chrono::steady_clock::now();
  EXPECT_TRUE(desk.soon([&] {
    // As somebody who holds a key.
    if (std::chrono::steady_clock::now() > asked) {
      asked += 100ms;
      robotcontrol::Request drive;
      auto& motion = *drive.mutable_motion()->mutable_motion();
      motion.set_kind(robotcontrol::MotionRequest::WALK);
      motion.mutable_walk()->set_x(0.3);
      desk.ask(drive);
    }
    return state()->odometry().x() > begin + 0.2;
  }));
}

TEST(BodyFeed, imagesComeAsJpegIfThatIsChosen) {
  OfferedBodies hall("scenes/field2002.sdf");
  Desk desk({.url = urlOf(hall.port()), .asJpeg = true}, hall.port());
  desk.show("camera/image");
  EXPECT_TRUE(
      desk.soon([&] { return desk.newest<google::protobuf::Message>("red1/camera/image") != nullptr; }));
  EXPECT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
}

TEST(BodyFeed, aSecondProgramIsToldWhoseBodyItIs) {
  OfferedBodies hall("scenes/field2002.sdf");
  Desk first({.url = urlOf(hall.port())}, hall.port());
  ASSERT_TRUE(first.soon([&] { return first.bodyMoves(); }));
  Desk second({.url = urlOf(hall.port())}, hall.port());
  EXPECT_TRUE(second.soon([&] {
    first.soon([] { return true; });
    return second.said("obeys the program of");
  }));
}

TEST(BodyFeed, whereNothingIsTheAddressIsNamed) {
  robotlink::Session session;
  logplayer::Recorder recorder({});
  const auto feed = BodyFeed::create({.url = "ws://127.0.0.1:1", .patience = 300ms}, session, recorder);
  ASSERT_FALSE(feed);
  EXPECT_THAT(feed.error().front().text, HasSubstr("no body was found at ws://127.0.0.1:1"));
}

}  // namespace
}  // namespace app
