// SPDX-License-Identifier: GPL-3.0-or-later
// A session at one end, its robots in another session at the other end, and a line between them.
#include "robotlink/foxglove/session/remote/SessionClient.h"

#include <gmock/gmock.h>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "tests/Eventually.h"
#include "tests/robotlink/foxglove/Relay.h"

namespace robotlink::websocket::test {
namespace {

using namespace std::chrono_literals;
using robotcontrol::KeyMode;
using robotcontrol::KeyTable;
using robotcontrol::Request;
using robotcontrol::RequestResult;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A robot's session that is offered at a port. Requests are kept, and accepted unless `refusal` says why
/// not; keys are set.
class FarSession {
 public:
  FarSession() { start(); }
  void start(std::uint16_t port = 0) {
    listener_.reset();
    server_.reset();
    session = std::make_unique<Session>();
    session->setRobots(robots);
    session->setRequestSink([this](const Request& request) { fulfill(request); });
    server_ = std::make_unique<SessionServer>(*session);
    server_->setImageEncoders({{kJpegChannel, encoderOf(0)}, {kPngChannel, encoderOf(100)}});
    Listener::Options options;
    options.address.port = port;
    options.greetingDelay = Duration::zero();
    auto listener = Listener::open(server_->server(), options);
    ASSERT_TRUE(listener) << listener.error().text;
    listener_ = *std::move(listener);
  }
  /// As if an image could be made of its width.
  static ImageEncoder encoderOf(std::uint32_t added) {
    return [added](const google::protobuf::Message& image) {
      auto encoded = std::make_shared<foxglove::CompressedImage>();
      encoded->set_format(std::to_string(dynamic_cast<const foxglove::RawImage&>(image).width() + added));
      return encoded;
    };
  }
  void stop() { listener_.reset(); }
  std::uint16_t port() const { return listener_->address().port; }
  void tick() {
    session->tick();
    server_->tick();
  }
  template <typename Message>
  void publish(const std::string& path, Instant time, const Message& message = {}) {
    session->push({path, time, std::make_shared<Message>(message)});
  }
  void publishKeys(Instant time) { publish("red1/tables/keys", time, keys); }
  const KeyMode& mode(int key) const { return keys.keys(key).mode(); }

  std::vector<std::string> robots{"red1"};
  std::unique_ptr<Session> session;
  std::vector<Request> requests;
  std::string refusal;
  bool answers = true;
  KeyTable keys;

 private:
  void fulfill(const Request& request) {
    requests.push_back(request);
    for (auto& key : *keys.mutable_keys()) {
      if (request.has_set_key() && key.name() == request.set_key().name())
        *key.mutable_mode() = request.set_key().mode();
    }
    if (request.has_set_key()) publishKeys(session->store().newest());
    if (!answers) return;
    RequestResult result;
    result.set_id(request.id());
    result.set_accepted(refusal.empty());
    result.set_reason(refusal);
    session->pushResult(result);
  }
  std::unique_ptr<SessionServer> server_;
  std::unique_ptr<Listener> listener_;
};

class SessionClientTest : public testing::Test {
 protected:
  SessionClientTest() {
    const auto addKey = [&](const std::string& name, const std::string& stream) {
      far_.keys.add_keys()->set_name(name);
      far_.keys.mutable_keys()->rbegin()->set_stream(stream);
    };
    addKey("package/camera/image", "camera/image");
    addKey("package/models/ball", "models/ball");
    options_.connection.times.retryTime = 10ms;
  }
  void connect(std::uint16_t port = 0) {
    options_.connection.url = {false, "127.0.0.1", port == 0 ? far_.port() : port, "/"};
    client_ = std::make_unique<SessionClient>(session_, options_);
    session_.setRequestSink([this](const Request& request) { client_->request(request); });
  }
  void tick() {
    far_.tick();
    client_->tick();
    session_.tick();
  }
  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      tick();
      return condition();
    });
  }
  template <typename Message>
  const Message* newest(const std::string& path) {
    return session_.store().latestAs<Message>(path, Instant::max());
  }
  bool hasRobot() {
    return soon([&] { return !client_->robots().empty(); });
  }
  bool hasKeys() {
    far_.publishKeys(Instant(1s));
    return soon([&] { return newest<KeyTable>("red1/tables/keys") != nullptr && isSubscribed("red1/log"); });
  }
  bool isSubscribed(const std::string& topic) {
    const auto streams = client_->streams();
    return std::ranges::any_of(streams,
                               [&](const auto& one) { return one.topic == topic && one.isSubscribed; });
  }
  /// Publishes until the other end has something newer; the first messages of a stream find no subscriber.
  template <typename Message>
  bool arrives(const std::string& path, Instant time, const Message& message, const std::string& as = {}) {
    return soon([&] {
      far_.publish(path, time, message);
      const auto* found = session_.store().latest(as.empty() ? path : as, Instant::max());
      return found != nullptr && found->value->SerializeAsString() == message.SerializeAsString();
    });
  }
  Request keyRequest(const std::string& name, KeyMode::Kind kind) {
    Request request;
    request.set_robot("red1");
    request.mutable_set_key()->set_name(name);
    request.mutable_set_key()->mutable_mode()->set_kind(kind);
    return request;
  }
  /// Makes a request, and returns its result: "accepted", or why not.
  std::string ask(Request request) {
    std::string outcome;
    session_.request(std::move(request), [&](const RequestResult& result) {
      outcome = result.accepted() ? "accepted" : result.reason();
    });
    EXPECT_TRUE(soon([&] { return !outcome.empty(); }));
    return outcome;
  }
  foxglove::RawImage image(std::uint32_t width) {
    foxglove::RawImage made;
    made.set_width(width);
    return made;
  }
  foxglove::Log text(const std::string& words) {
    foxglove::Log made;
    made.set_name("cognition/ball");
    made.set_message(words);
    return made;
  }

  FarSession far_;
  Session session_;
  SessionClient::Options options_;
  std::unique_ptr<SessionClient> client_;
};

TEST_F(SessionClientTest, robotsAndTheirStreamsAreThoseOfTheServer) {
  connect();
  EXPECT_TRUE(hasRobot());
  EXPECT_THAT(client_->robots(), ElementsAre("red1"));
  EXPECT_TRUE(hasKeys());
  EXPECT_TRUE(arrives("red1/log", Instant(2s), text("hello")));
  EXPECT_TRUE(arrives("scene", Instant(2s), image(1)));
  const StreamMessage* message = session_.store().latest("red1/log", Instant::max());
  EXPECT_EQ(message->time, Instant(2s));
  EXPECT_EQ(message->process, "cognition");
  EXPECT_TRUE(client_->state().isConnected());
  EXPECT_THAT(client_->stateText(), HasSubstr("connected"));
}

TEST_F(SessionClientTest, aKeyIsOnAtTheRobotWhileItIsOnHere) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  far_.publish("red1/camera/image", Instant(1s), image(1));
  EXPECT_EQ(ask(keyRequest("package/camera/image", KeyMode::ALWAYS)), "accepted");
  EXPECT_TRUE(soon([&] { return far_.mode(0).kind() == KeyMode::ALWAYS; }));
  EXPECT_TRUE(arrives("red1/camera/image", Instant(2s), image(7)));
  EXPECT_TRUE(
      soon([&] { return newest<KeyTable>("red1/tables/keys")->keys(0).mode().kind() == KeyMode::ALWAYS; }));
  EXPECT_EQ(ask(keyRequest("package/camera/image", KeyMode::OFF)), "accepted");
  EXPECT_TRUE(soon([&] { return far_.mode(0).kind() == KeyMode::OFF; }));
  EXPECT_EQ(ask(keyRequest("package/models/ball", KeyMode::N_TIMES)), "accepted");
  EXPECT_EQ(far_.mode(1).kind(), KeyMode::N_TIMES);
}

TEST_F(SessionClientTest, imagesAreTheSameStreamWhenTheyAreSentAsJpeg) {
  options_.convert = [&](const PackagePtr& package) -> PackagePtr {
    const auto* encoded = dynamic_cast<const foxglove::CompressedImage*>(package.get());
    if (encoded == nullptr) return package;
    return std::make_shared<foxglove::RawImage>(
        image(1000 + static_cast<std::uint32_t>(std::stoi(encoded->format()))));
  };
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  far_.publish("red1/camera/image", Instant(1s), image(1));
  ask(keyRequest("package/camera/image", KeyMode::ALWAYS));
  const auto shows = [&](std::uint32_t sent, std::uint32_t shown) {
    return soon([&] {
      far_.publish("red1/camera/image", Instant(2s), image(sent));
      const auto* newest = this->newest<foxglove::RawImage>("red1/camera/image");
      return newest != nullptr && newest->width() == shown;
    });
  };
  EXPECT_TRUE(shows(7, 7));
  client_->setImages(SessionClient::Images::kJpeg);
  EXPECT_TRUE(shows(8, 1008));
  EXPECT_FALSE(isSubscribed("red1/camera/image"));
  EXPECT_EQ(session_.store().find("red1/camera/image/jpeg"), nullptr);
  EXPECT_EQ(far_.mode(0).kind(), KeyMode::ALWAYS);
  client_->setImages(SessionClient::Images::kPng);
  EXPECT_TRUE(shows(10, 1110));
  EXPECT_FALSE(isSubscribed("red1/camera/image"));
  client_->setImages(SessionClient::Images::kRaw);
  EXPECT_TRUE(shows(9, 9));
}

TEST_F(SessionClientTest, imagesComeAtAChosenRateAndWhatIsLeftOutIsCounted) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  // One a day.
  client_->setImageRate(1e-5);
  far_.publish("red1/camera/image", Instant(1s), image(1));
  ask(keyRequest("package/camera/image", KeyMode::ALWAYS));
  const auto stream = [&] {
    const auto all = client_->streams();
    return *std::ranges::find(all, std::string("red1/camera/image"), &SessionClient::Stream::topic);
  };
  ASSERT_TRUE(soon([&] { return isSubscribed("red1/camera/image"); }));
  std::uint32_t width = 1;
  const auto until = [&](const auto& condition) {
    return soon([&] {
      ++width;
      far_.publish("red1/camera/image", Instant(1s) + width * 1ms, image(width));
      return condition(stream());
    });
  };
  EXPECT_TRUE(until([](const auto& counted) { return counted.thinned.value_or(0) > 10; }));
  EXPECT_EQ(stream().messages, 1U);
  client_->setImageRate(0);
  EXPECT_TRUE(until([](const auto& counted) { return counted.messages > 10; }));
}

TEST_F(SessionClientTest, aModeOfAKeyIsChosenUntilTheConnectionEndsAndAgainAfterACut) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  Request every = keyRequest("package/camera/image", KeyMode::EVERY_N);
  every.mutable_set_key()->mutable_mode()->set_n(3);
  EXPECT_EQ(ask(every), "accepted");
  EXPECT_TRUE(soon([&] { return far_.mode(0).kind() == KeyMode::EVERY_N; }));
  const std::uint16_t port = far_.port();
  far_.stop();
  EXPECT_TRUE(soon([&] { return !client_->state().isConnected(); }));
  far_.start(port);
  ASSERT_TRUE(soon([&] { return client_->state().isConnected(); }));
  EXPECT_TRUE(hasKeys() && soon([&] { return far_.mode(0).n() == 3; }));
  client_.reset();
  EXPECT_TRUE(eventually([&] {
    far_.tick();
    return far_.mode(0).kind() == KeyMode::OFF;
  }));
}

TEST_F(SessionClientTest, twoSessionsDoNotKeepAKeyOnForEachOther) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  far_.publish("red1/camera/image", Instant(1s), image(1));
  Session other;
  SessionClient second(other, options_);
  const auto otherTable = [&] {
    second.tick();
    other.tick();
    return other.store().latestAs<KeyTable>("red1/tables/keys", Instant::max());
  };
  EXPECT_EQ(ask(keyRequest("package/camera/image", KeyMode::ALWAYS)), "accepted");
  EXPECT_TRUE(soon([&] { return far_.mode(0).kind() == KeyMode::ALWAYS; }));
  EXPECT_TRUE(soon([&] { return otherTable() != nullptr; }));
  EXPECT_TRUE(soon([&] { return otherTable()->keys(0).mode().kind() == KeyMode::OFF; }));
  client_.reset();
  EXPECT_TRUE(eventually([&] {
    far_.tick();
    otherTable();
    return far_.mode(0).kind() == KeyMode::OFF;
  }));
}

TEST_F(SessionClientTest, requestsAreAcceptedOrRefusedByTheRobot) {
  connect();
  ASSERT_TRUE(hasRobot());
  Request request;
  request.set_robot("red1");
  request.mutable_select_solution()->set_task("ball");
  request.mutable_select_solution()->set_solution("fast");
  EXPECT_EQ(ask(request), "accepted");
  EXPECT_EQ(far_.requests.back().select_solution().solution(), "fast");
  far_.refusal = "there is no such solution";
  EXPECT_EQ(ask(request), "there is no such solution");
  Request pause;
  pause.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::PAUSE);
  EXPECT_TRUE(client_->takes(pause));
  far_.refusal = {};
  EXPECT_EQ(ask(pause), "accepted");
}

TEST_F(SessionClientTest, aRequestDuringACutIsRefusedWithASentence) {
  connect();
  ASSERT_TRUE(hasRobot());
  far_.stop();
  Request request;
  request.set_robot("red1");
  request.mutable_stop()->set_engaged(true);
  std::string outcome;
  session_.request(request, [&](const RequestResult& result) { outcome = result.reason(); });
  EXPECT_TRUE(eventually([&] {
    client_->tick();
    session_.tick();
    return !outcome.empty();
  }));
  EXPECT_THAT(outcome, AnyOf(HasSubstr("no connection"), HasSubstr("connection was lost")));
}

TEST_F(SessionClientTest, afterACutTheHistoryIsThereAndTheGapIsKnown) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  far_.publish("red1/models/ball", Instant(1s), robotcontrol::BallModel());
  ask(keyRequest("package/models/ball", KeyMode::ALWAYS));
  EXPECT_TRUE(arrives("red1/log", Instant(2s), text("before")));
  const std::uint16_t port = far_.port();
  far_.stop();
  EXPECT_TRUE(eventually([&] {
    client_->tick();
    session_.tick();
    return !client_->gaps().empty();
  }));
  EXPECT_THAT(client_->robots(), ElementsAre("red1"));
  // The robot was restarted, and its clock, too.
  far_.keys.mutable_keys(1)->clear_mode();
  far_.start(port);
  far_.publishKeys(Instant(0s));
  far_.publish("red1/models/ball", Instant(0s), robotcontrol::BallModel());
  EXPECT_TRUE(soon([&] { return far_.mode(1).kind() == KeyMode::ALWAYS; }));
  EXPECT_TRUE(arrives("red1/log", Instant(1s), text("after")));
  EXPECT_EQ(dynamic_cast<const foxglove::Log&>(*session_.store().find("red1/log")->messages.front().value)
                .message(),
            "before");
  ASSERT_EQ(client_->gaps().size(), 1U);
  const auto& gap = client_->gaps()[0];
  EXPECT_GE(gap.from, Instant(2s));
  EXPECT_GT(gap.to.value_or(Instant()), gap.from);
  EXPECT_FALSE(gap.reason.empty());
}

TEST_F(SessionClientTest, robotsOfTheSameNameAreTold) {
  options_.isTaken = [](const std::string& name) { return name == "red1"; };
  options_.leadingTime = [] { return std::optional(Instant(100s)); };
  connect();
  EXPECT_TRUE(hasRobot());
  EXPECT_THAT(client_->robots(), ElementsAre("red1-2"));
  far_.publish("transforms", Instant(2s), text("x"));
  EXPECT_TRUE(arrives("red1/log", Instant(2s), text("hello"), "red1-2/log"));
  // It follows the time of others, and the world is theirs.
  EXPECT_EQ(session_.store().newest(), Instant(100s));
  EXPECT_EQ(session_.store().find("transforms"), nullptr);
  Request request;
  request.set_robot("red1-2");
  request.mutable_send_tables();
  EXPECT_EQ(ask(request), "accepted");
  EXPECT_EQ(far_.requests.back().robot(), "red1");
  Request pause;
  pause.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::PAUSE);
  EXPECT_FALSE(client_->takes(pause));
}

TEST_F(SessionClientTest, whenTheSessionIsRestartedTablesAreThereAgain) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  session_.restart();
  EXPECT_TRUE(soon([&] { return newest<KeyTable>("red1/tables/keys") != nullptr; }));
}

TEST_F(SessionClientTest, aResetOfARobotThatLeadsCutsTheHistoryAsOfAHostedOne) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  EXPECT_TRUE(arrives("red1/log", Instant(9s), text("old")));
  EXPECT_TRUE(arrives("red1/log", Instant(0s), text("new")));
  EXPECT_EQ(session_.store().newest(), Instant(0s));
}

TEST_F(SessionClientTest, aResetInTheFirstSecondIsKnownByTheStreamsOfTheWorld) {
  connect();
  ASSERT_TRUE(hasRobot() && hasKeys());
  foxglove::FrameTransforms transforms;
  transforms.add_transforms()->set_child_frame_id("before");
  EXPECT_TRUE(arrives("transforms", Instant(1900ms), transforms));
  transforms.mutable_transforms(0)->set_child_frame_id("after");
  EXPECT_TRUE(arrives("transforms", Instant(1008ms), transforms));
  EXPECT_EQ(session_.store().newest(), Instant(1008ms));
}

TEST_F(SessionClientTest, oneSessionSteersAndBothKnowWho) {
  connect();
  ASSERT_TRUE(hasKeys());
  Session otherSession;
  SessionClient other(otherSession, options_);
  std::string objection = "none";
  const auto steers = [&](Session& session) {
    const auto* status =
        session.store().latestAs<robotcontrol::SteeringStatus>("red1/steering", Instant::max());
    return status != nullptr && status->own();
  };
  const auto bothTick = [&](auto condition) {
    return soon([&] {
      other.tick();
      otherSession.tick();
      return condition();
    });
  };
  ASSERT_TRUE(bothTick([&] { return !other.robots().empty(); }));
  client_->steer("red1", false, [](const Result<void>&) {});
  EXPECT_TRUE(bothTick([&] { return steers(session_) && !steers(otherSession); }));
  other.steer("red1", false, [](const Result<void>&) {});
  EXPECT_TRUE(bothTick([&] { return !steers(session_) && steers(otherSession); }));
  // A robot that it does not have.
  other.steer("blue1", false, [&](const Result<void>& done) { objection = done ? "" : done.error().text; });
  EXPECT_THAT(objection, HasSubstr("blue1"));
}

}  // namespace
}  // namespace robotlink::websocket::test
