// SPDX-License-Identifier: GPL-3.0-or-later
// A robot behind a narrow and bad WLAN, in real time: 1 Mbit/s, 200 ms of round trip, silence.
#include <gmock/gmock.h>

#include <random>
#include <thread>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "robotlink/foxglove/session/remote/SessionClient.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/robotlink/foxglove/Relay.h"

namespace robotlink::websocket::test {
namespace {

using namespace std::chrono_literals;
using robotcontrol::KeyMode;
using robotcontrol::KeyTable;
using robotcontrol::Request;
using robotcontrol::RequestResult;
using SteadyTime = std::chrono::steady_clock::time_point;

constexpr double kMegabit = 125'000;

/// What a JPEG of an ERS-210's image has, and the image itself.
constexpr std::size_t kJpegBytes = 8'000, kImageBytes = 50'000;

/// Only the size matters.
template <typename Image>
PackagePtr imageOf(std::size_t bytes) {
  auto image = std::make_shared<Image>();
  image->set_data(std::string(bytes, 'x'));
  return image;
}

/// A robot that publishes 25 images and ten texts a second, in a thread of its own: 10 Mbit/s, or 1.6 Mbit/s
/// as JPEG. Its time is real time.
class BusyRobot {
 public:
  /// With a certificate it is encrypted.
  explicit BusyRobot(const std::optional<Certificate>& certificate = {}) {
    auto& key = *keys_.add_keys();
    key.set_name("package/camera/image");
    key.set_stream("camera/image");
    session_.setRobots({"red1"});
    session_.setRequestSink([this](const Request& request) { fulfill(request); });
    server_.setImageEncoders(
        {{kJpegChannel, [](const auto&) { return imageOf<foxglove::CompressedImage>(kJpegBytes); }}});
    Listener::Options options;
    options.address.port = 0;
    options.certificate = certificate;
    // As with clients of other machines.
    options.compressesLoopback = true;
    listener_ = *Listener::open(server_.server(), options);
    thread_ = std::thread([this] { run(); });
  }
  ~BusyRobot() {
    isOver_ = true;
    thread_.join();
  }
  BusyRobot(const BusyRobot&) = delete;
  BusyRobot& operator=(const BusyRobot&) = delete;

  std::uint16_t port() const { return listener_->address().port; }
  Instant now() const { return clock_.now(); }
  /// When the newest request of a kind arrived.
  std::optional<SteadyTime> arrival(Request::WhatCase kind) {
    const std::lock_guard lock(mutex_);
    const auto found = arrivals_.find(kind);
    return found == arrivals_.end() ? std::nullopt : std::optional(found->second);
  }
  int texts() const { return texts_; }
  /// Since when it stands; nothing while it walks.
  std::optional<SteadyTime> stoodAt() {
    const std::lock_guard lock(mutex_);
    return stoodAt_;
  }

 private:
  void run() {
    for (int i = 0; !isOver_; ++i) {
      if (i % 4 == 0) publishImage();
      if (i % 10 == 0) publishText();
      if (i % 100 == 0) session_.push({"red1/tables/keys", now(), std::make_shared<KeyTable>(keys_)});
      session_.tick();
      server_.tick();
      std::this_thread::sleep_for(10ms);
    }
  }
  void publishImage() {
    session_.push({"red1/camera/image", now(), imageOf<foxglove::RawImage>(kImageBytes)});
  }
  void publishText() {
    auto text = std::make_shared<foxglove::Log>();
    text->set_name("robot/" + std::to_string(texts_++));
    session_.push({"red1/log", now(), text});
  }
  void fulfill(const Request& request) {
    if (request.has_set_key()) *keys_.mutable_keys(0)->mutable_mode() = request.set_key().mode();
    {
      const std::lock_guard lock(mutex_);
      const auto now = std::chrono::steady_clock::now();
      arrivals_[request.what_case()] = now;
      if (request.has_motion()) {
        const bool stands = request.motion().motion().kind() == robotcontrol::MotionRequest::STAND;
        stoodAt_ = stands ? std::optional(now) : std::nullopt;
      }
    }
    RequestResult result;
    result.set_id(request.id());
    result.set_accepted(true);
    session_.pushResult(result);
  }

  const SteadyClock clock_;
  KeyTable keys_;
  Session session_;
  SessionServer server_{session_};
  std::unique_ptr<Listener> listener_;
  std::mutex mutex_;
  std::map<Request::WhatCase, SteadyTime> arrivals_;
  /// Nothing while it walks.
  std::optional<SteadyTime> stoodAt_;
  std::atomic<int> texts_{0};
  std::atomic<bool> isOver_{false};
  std::thread thread_;
};

class BadLine : public testing::Test {
 protected:
  explicit BadLine(const std::optional<Certificate>& certificate = {}) : robot_(certificate) {
    SessionClient::Options options;
    options.connection.url = {certificate.has_value(), "127.0.0.1", relay_.port(), "/"};
    options.connection.knownServers = folder_.path() / "known";
    options.convert = [](const PackagePtr& package) {
      const bool isImage = dynamic_cast<const foxglove::CompressedImage*>(package.get()) != nullptr;
      return isImage ? imageOf<foxglove::RawImage>(kImageBytes) : package;
    };
    client_ = std::make_unique<SessionClient>(session_, options);
    session_.setRequestSink([this](const Request& request) { client_->request(request); });
  }
  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      client_->tick();
      session_.tick();
      return condition();
    });
  }
  void goOn(Duration time) {
    const auto end = std::chrono::steady_clock::now() + time;
    soon([&] { return std::chrono::steady_clock::now() > end; });
  }
  bool hasTables() {
    return soon([&] { return session_.store().find("red1/tables/keys") != nullptr; });
  }
  /// Returns how long the answer took.
  Duration ask(Request request) {
    request.set_robot("red1");
    bool isDone = false;
    std::string reason;
    const auto begin = std::chrono::steady_clock::now();
    session_.request(std::move(request), [&](const RequestResult& result) {
      isDone = true;
      reason = result.reason();
    });
    EXPECT_TRUE(soon([&] { return isDone; }));
    EXPECT_EQ(reason, "");
    return std::chrono::steady_clock::now() - begin;
  }
  Request keyRequest(KeyMode::Kind kind) {
    Request request;
    request.mutable_set_key()->set_name("package/camera/image");
    request.mutable_set_key()->mutable_mode()->set_kind(kind);
    return request;
  }
  void subscribeToImages(SessionClient::Images images = SessionClient::Images::kJpeg) {
    client_->setImages(images);
    ASSERT_TRUE(hasTables());
    ask(keyRequest(KeyMode::ALWAYS));
    ASSERT_TRUE(soon([&] { return session_.store().find("red1/camera/image") != nullptr; }));
  }
  Duration oldestImage() {
    goOn(2s);
    Duration oldest{0};
    const auto end = std::chrono::steady_clock::now() + 8s;
    soon([&] {
      oldest = std::max(oldest, ageOfImage());
      return std::chrono::steady_clock::now() > end;
    });
    RecordProperty("oldest_image_ms", static_cast<int>(oldest / 1ms));
    return oldest;
  }
  Duration ageOfImage() {
    const auto* image = session_.store().latest("red1/camera/image", Instant::max());
    return robot_.now() - image->time;
  }

  /// Steers it, with ten commands a second, until it walks; and for so much longer.
  void walkFor(Duration time) {
    std::optional<SteadyTime> commanded, walks;
    EXPECT_TRUE(soon([&] {
      const auto now = std::chrono::steady_clock::now();
      if (!commanded || now - *commanded > 100ms) {
        Request walk;
        walk.set_robot("red1");
        walk.mutable_motion()->mutable_motion()->set_kind(robotcontrol::MotionRequest::WALK);
        session_.request(std::move(walk), {});
        commanded = now;
      }
      if (!walks && robot_.arrival(Request::kMotion) && !robot_.stoodAt()) walks = now;
      return walks && now - *walks > time;
    }));
  }
  /// Three times 20 s of silence.
  void loseAndFindTheLine() {
    subscribeToImages();
    for (int i = 0; i < 3; ++i) {
      walkFor(1s);
      relay_.set(Relay::State::kSilent);
      const auto lost = std::chrono::steady_clock::now();
      goOn(20s);
      ASSERT_TRUE(robot_.stoodAt().has_value());
      const Duration stood = *robot_.stoodAt() - lost;
      RecordProperty("stood_ms_" + std::to_string(i), static_cast<int>(stood / 1ms));
      // Commands that arrived just before hold for half a second, and are on their way for 0.1 s.
      EXPECT_LT(stood, 1s);
      EXPECT_EQ(client_->state().phase, ConnectionState::Phase::kSilent);
      relay_.set(Relay::State::kOpen);
      const auto back = std::chrono::steady_clock::now();
      const auto sinceBack = [&] { return std::chrono::steady_clock::now() - back; };
      EXPECT_TRUE(soon([&] { return client_->state().isConnected(); }));
      const Duration connected = sinceBack();
      EXPECT_TRUE(soon([&] { return ageOfImage() < 1s; }));
      const Duration seen = sinceBack();
      RecordProperty("connected_ms_" + std::to_string(i), static_cast<int>(connected / 1ms));
      RecordProperty("image_ms_" + std::to_string(i), static_cast<int>(seen / 1ms));
      EXPECT_LT(seen, 2s);
      EXPECT_EQ(client_->gaps().size(), static_cast<std::size_t>(i) + 1);
    }
  }

  const TestFolder folder_;
  BusyRobot robot_;
  Relay relay_{robot_.port(), {100ms, kMegabit}};
  Session session_;
  std::unique_ptr<SessionClient> client_;
};

TEST_F(BadLine, imagesAreNeverOlderThanASecondAsJpeg) {
  subscribeToImages();
  EXPECT_LT(oldestImage(), 1s);
}

TEST_F(BadLine, imagesAreNeverOlderThanASecondThoughNobodyChoseJpeg) {
  subscribeToImages(SessionClient::Images::kAutomatic);
  ASSERT_TRUE(soon([&] {
    return client_->stateText().find("images as JPEG: the link is too slow") != std::string::npos;
  }));
  EXPECT_LT(oldestImage(), 1s);
  EXPECT_TRUE(soon([&] {
    const auto* texts = session_.store().find("red1/log");
    return std::ranges::any_of(texts->messages, [](const StreamMessage& message) {
      const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
      return text->message().starts_with("Images come as JPEG from now on: the link carries");
    });
  }));
}

TEST_F(BadLine, alsoRawImagesDoNotGrowOlder) {
  subscribeToImages(SessionClient::Images::kRaw);
  // One takes 0.4 s on this line, and is shown until the next one has come.
  EXPECT_LT(oldestImage(), 1700ms);
}

TEST_F(BadLine, keysAnswerWithinASecondAndStopArrivesWithin300MsDuringAColorTable) {
  subscribeToImages();
  goOn(2s);
  for (int i = 0; i < 5; ++i) {
    Request tables;
    tables.mutable_send_tables();
    const Duration taken = ask(tables);
    RecordProperty("answer_ms_" + std::to_string(i), static_cast<int>(taken / 1ms));
    EXPECT_LT(taken, 1s);
    goOn(137ms);
  }
  for (int i = 0; i < 3; ++i) {
    Request table;
    table.set_robot("red1");
    std::mt19937 random;
    std::string cells(262'144, ' ');
    for (char& cell : cells) cell = static_cast<char>(random());
    table.mutable_set_parameters()->mutable_value()->set_data(cells);
    session_.request(table, {});
    goOn(500ms);
    const auto pressed = std::chrono::steady_clock::now();
    Request stop;
    stop.set_robot("red1");
    stop.mutable_stop()->set_engaged(true);
    session_.request(stop, {});
    EXPECT_TRUE(soon([&] { return robot_.arrival(Request::kStop).value_or(SteadyTime()) > pressed; }));
    const Duration taken = *robot_.arrival(Request::kStop) - pressed;
    RecordProperty("stop_ms_" + std::to_string(i), static_cast<int>(taken / 1ms));
    EXPECT_LT(taken, 300ms);
    EXPECT_LT(robot_.arrival(Request::kSetParameters).value_or(SteadyTime()), pressed);
    EXPECT_TRUE(
        soon([&] { return robot_.arrival(Request::kSetParameters).value_or(SteadyTime()) > pressed; }));
  }
}

TEST_F(BadLine, nothingOfACompleteStreamIsLost) {
  subscribeToImages();
  goOn(5s);
  const int published = robot_.texts();
  EXPECT_TRUE(soon([&] {
    const auto* text = session_.store().latestAs<foxglove::Log>("red1/log", Instant::max());
    return text != nullptr && std::stoi(text->name().substr(6)) >= published - 1;
  }));
  const auto& texts = session_.store().find("red1/log")->messages;
  int expected = -1;
  for (const StreamMessage& message : texts) {
    const int number = std::stoi(dynamic_cast<const foxglove::Log&>(*message.value).name().substr(6));
    EXPECT_TRUE(expected < 0 || number == expected) << number << " instead of " << expected;
    expected = number + 1;
  }
}

TEST_F(BadLine, afterTwentySecondsOfSilenceImagesAreBackWithinTwoSecondsThreeTimes) {
  loseAndFindTheLine();
}

class EncryptedBadLine : public BadLine {
 protected:
  EncryptedBadLine() : BadLine(makeCertificate("red1").value()) {}
};

TEST_F(EncryptedBadLine, imagesAreNeverOlderThanASecondAsJpeg) {
  subscribeToImages();
  EXPECT_LT(oldestImage(), 1s);
}

TEST_F(EncryptedBadLine, afterTwentySecondsOfSilenceImagesAreBackWithinTwoSecondsThreeTimes) {
  loseAndFindTheLine();
}

}  // namespace
}  // namespace robotlink::websocket::test
