// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/History.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/Session.h"

using namespace robotlink;
using namespace std::chrono_literals;
using robotcontrol::KeyTable;
using robotcontrol::PlotValue;

namespace {

Instant moment(double time) {
  return Instant(fromSeconds(time));
}

StreamMessage reading(const std::string& path, double time, std::size_t bytes = 10'000) {
  auto message = std::make_shared<PlotValue>();
  message->set_value(time);
  StreamMessage result{path, moment(time), message};
  result.bytes = bytes;
  return result;
}

/// Keeps everything in memory, and serves a request when it is told to.
class FakeArchive final : public HistoryArchive {
 public:
  void add(std::vector<StreamMessage> messages, Stretch held) override {
    for (StreamMessage& message : messages) all_.push_back(std::move(message));
    until_ = held.to;
  }
  void forgetAfter(Instant) override { clear(); }
  void clear() override { all_.clear(); }
  void request(Instant at) override { requested_ = at; }
  std::optional<Part> take() override { return std::exchange(served_, std::nullopt); }
  std::optional<Stretch> stretch() const override {
    if (all_.empty()) return std::nullopt;
    return Stretch{all_.front().time, until_};
  }
  void setLimit(std::uint64_t) override {}
  std::uint64_t limit() const override { return 0; }
  std::vector<Stretch> holes() const override { return holes_; }
  bool hasRoom() const override { return hasRoom_; }
  bool isLosing() const override { return false; }
  std::uint64_t bytes() const override { return 0; }
  std::map<std::string, std::uint64_t> shares() const override { return {}; }
  std::optional<Error> takeProblem() override { return std::nullopt; }

  bool serve() {
    if (!requested_) return false;
    const Instant at = *std::exchange(requested_, std::nullopt);
    Part part{at, {std::max(at - 1s, all_.front().time), std::min(at + 1s, until_)}, {}};
    for (const Stretch& hole : holes_) {
      if (at >= hole.to) part.stretch.from = std::max(part.stretch.from, hole.to);
      if (at <= hole.from) part.stretch.to = std::min(part.stretch.to, hole.from);
    }
    std::map<std::string, StreamMessage> before;
    for (const StreamMessage& message : all_) {
      if (message.time <= part.stretch.from) before[message.path] = message;
    }
    for (const auto& [path, message] : before) part.messages.push_back(message);
    for (const StreamMessage& message : all_) {
      if (message.time > part.stretch.from && message.time <= part.stretch.to)
        part.messages.push_back(message);
    }
    std::ranges::stable_sort(part.messages, {}, &StreamMessage::time);
    served_ = part;
    return true;
  }
  /// Loses what is between two instants, but for what held at the second one.
  void lose(Stretch hole) {
    holes_.push_back(hole);
    std::map<std::string, Instant> newest;
    for (const StreamMessage& message : all_) {
      if (message.time <= hole.to) newest[message.path] = message.time;
    }
    std::erase_if(all_, [&](const StreamMessage& message) {
      return message.time > hole.from && message.time < newest[message.path];
    });
  }
  std::vector<StreamMessage> all_;
  bool hasRoom_ = true;

 private:
  std::vector<Stretch> holes_;
  Instant until_;
  std::optional<Instant> requested_;
  std::optional<Part> served_;
};

class HistoryTest : public testing::Test {
 protected:
  void runUntil(double end) {
    for (; time_ < end - 0.05; time_ += 0.1) {
      session_.push(reading("red1/a", time_));
      if (++count_ % 10 == 1) session_.push(reading("red1/slow", time_, 1'000));
    }
    session_.tick();
  }
  void archive() {
    auto archive = std::make_unique<FakeArchive>();
    archive_ = archive.get();
    session_.history().setArchive(std::move(archive));
  }
  /// What views see.
  double shown(const std::string& path) {
    const auto* value = session_.store().latestAs<PlotValue>(path, session_.timeline().shown());
    return value ? value->value() : -1;
  }

  // About ten seconds.
  Session session_{StreamStore::Limits{.bytes = 1'000'000}};
  History& history_ = session_.history();
  FakeArchive* archive_ = nullptr;
  double time_ = 0;
  int count_ = 0;
};

}  // namespace

TEST_F(HistoryTest, theRobotGoesOnWhileTheDisplayIsPaused) {
  runUntil(3);
  history_.pause();
  runUntil(5);
  EXPECT_FALSE(session_.timeline().live());
  EXPECT_NEAR(shown("red1/a"), 2.9, 0.01);
  EXPECT_NEAR(seconds(history_.behind()), 2, 0.01);
  history_.goLive();
  EXPECT_NEAR(shown("red1/a"), 4.9, 0.01);
  EXPECT_EQ(history_.behind(), Duration(0));
}

TEST_F(HistoryTest, whatIsLookedAtStaysHoweverLongTheRobotGoesOn) {
  runUntil(8);
  history_.show(moment(6.05));
  runUntil(60);
  EXPECT_NEAR(shown("red1/a"), 6.0, 0.01);
  EXPECT_NEAR(shown("red1/slow"), 6.0, 0.01);
  EXPECT_NE(session_.store().latest("red1/a", moment(2)), nullptr) << "what trails need is there, too";
  EXPECT_LT(session_.store().bytes(), 1'900'000U) << "the rest is bounded as ever";
  history_.goLive();
  EXPECT_LE(session_.store().bytes(), 1'000'000U);
  EXPECT_FALSE(session_.store().has(moment(6.05)));
}

TEST_F(HistoryTest, withoutAnArchiveTheNearestInstantThatIsLeftIsShown) {
  runUntil(60);
  history_.show(moment(3));
  EXPECT_GT(session_.timeline().shown(), moment(45));
  EXPECT_EQ(session_.timeline().shown(), session_.store().horizon());
  EXPECT_NEAR(shown("red1/slow"), seconds(session_.store().horizon().time_since_epoch()), 1.0)
      << "the state at that instant is complete";
  history_.show(moment(1000));
  EXPECT_EQ(session_.timeline().shown(), session_.timeline().newest());
  EXPECT_FALSE(session_.timeline().live());
}

TEST_F(HistoryTest, whatWasDroppedIsReadBeforeItIsShown) {
  archive();
  session_.push({"red1/tables/keys", moment(0), std::make_shared<KeyTable>()});
  runUntil(60);
  ASSERT_FALSE(session_.store().has(moment(20.05)));
  history_.show(moment(20.05));
  EXPECT_TRUE(history_.isReading());
  EXPECT_EQ(history_.chosen(), moment(20.05));
  session_.tick();
  EXPECT_NEAR(shown("red1/a"), 59.9, 0.01) << "until it is read, what was shown before stays";
  ASSERT_TRUE(archive_->serve());
  session_.tick();
  EXPECT_FALSE(history_.isReading());
  EXPECT_NEAR(shown("red1/a"), 20.0, 0.01);
  EXPECT_NEAR(shown("red1/slow"), 20.0, 0.01);
  EXPECT_NE(session_.store().latestAs<KeyTable>("red1/tables/keys", session_.timeline().shown()), nullptr);
  runUntil(90);
  EXPECT_NEAR(shown("red1/a"), 20.0, 0.01);
  const auto& messages = session_.store().find("red1/a")->messages;
  EXPECT_TRUE(std::ranges::is_sorted(messages, {}, &StreamMessage::time));
}

TEST_F(HistoryTest, everyMessageIsInMemoryOrInTheArchiveOnce) {
  archive();
  runUntil(30);
  history_.show(moment(29));
  runUntil(60);
  history_.goLive();
  std::vector<Instant> times;
  for (const auto& message : archive_->all_) {
    if (message.path == "red1/a") times.push_back(message.time);
  }
  for (const auto& message : session_.store().find("red1/a")->messages) times.push_back(message.time);
  ASSERT_EQ(times.size(), 600U);
  EXPECT_TRUE(std::ranges::is_sorted(times, std::ranges::less_equal{})) << "no time is there twice";
}

TEST_F(HistoryTest, stepsGoFromMessageToMessageAcrossWhatMustBeRead) {
  archive();
  runUntil(60);
  history_.show(moment(20.05));
  archive_->serve();
  session_.tick();
  ASSERT_TRUE(history_.step("red1/a", -1));
  EXPECT_NEAR(shown("red1/a"), 20.0, 0.001);
  EXPECT_EQ(session_.timeline().shown(), session_.store().latest("red1/a", moment(20.05))->time);
  const auto stepTo = [this](int count, double expected) {
    ASSERT_TRUE(history_.step("red1/a", count));
    for (int tick = 0; tick < 100 && history_.isReading(); ++tick) {
      archive_->serve();
      session_.tick();
    }
    EXPECT_NEAR(shown("red1/a"), expected, 0.001);
  };
  stepTo(-45, 15.5);
  stepTo(45, 20.0);
  stepTo(200, 40.0);
  stepTo(1000, 59.9);
  stepTo(-1000, 0.0);
  EXPECT_FALSE(history_.step("red1/none", 1));
}

TEST_F(HistoryTest, framesAreThoseOfTheProcessThatLooksAtImages) {
  for (int i = 0; i < 100; ++i) {
    session_.push(reading("red1/frames/motion", 0.01 * i));
    if (i % 4 == 0) session_.push(reading("red1/frames/cognition", 0.01 * i));
  }
  session_.tick();
  history_.pause();
  ASSERT_TRUE(history_.stepFrames("red1", -2));
  EXPECT_EQ(session_.timeline().shown(), moment(0.92));
  ASSERT_TRUE(history_.stepFrames("red1", 1));
  EXPECT_EQ(session_.timeline().shown(), moment(0.96));
  EXPECT_FALSE(history_.stepFrames("blue1", 1));
}

TEST_F(HistoryTest, whatIsKeptIsKnown) {
  runUntil(5);
  EXPECT_EQ(history_.kept(), (std::vector<Stretch>{{moment(0), session_.store().newest()}}));
  archive();
  runUntil(60);
  ASSERT_EQ(history_.kept().size(), 1U);
  EXPECT_EQ(history_.kept().front(), (Stretch{moment(0), session_.store().newest()}));
  archive_->all_.clear();
  EXPECT_EQ(history_.kept().front().from, session_.store().horizon());
}

TEST_F(HistoryTest, aResetOfThePlatformEndsThePause) {
  runUntil(5);
  history_.show(moment(4));
  session_.push(reading("red1/a", 0.1));
  session_.tick();
  EXPECT_TRUE(session_.timeline().live());
}

TEST_F(HistoryTest, withFewerBytesTheOldestGoes) {
  runUntil(9);
  session_.store().setBytes(200'000);
  EXPECT_LE(session_.store().bytes(), 200'000U);
  EXPECT_GT(session_.store().horizon(), moment(6.5));
}

TEST_F(HistoryTest, withFewerBytesTheOldestGoesToTheArchiveAsFarAsThatHasRoom) {
  constexpr std::size_t kMib = std::size_t{1} << 20U;
  archive();
  session_.store().setBytes(200 * kMib);
  for (int i = 0; i < 100; ++i) {
    session_.push(reading("red1/a", 0.1 * i, kMib));
    session_.tick();
  }
  session_.store().setBytes(20 * kMib);
  archive_->hasRoom_ = false;
  session_.tick();
  EXPECT_EQ(session_.store().bytes(), 100 * kMib);
  archive_->hasRoom_ = true;
  session_.tick();
  EXPECT_EQ(session_.store().bytes(), 84 * kMib);
  EXPECT_EQ(archive_->all_.size(), 16U);
  for (int i = 0; i < 10; ++i) session_.tick();
  EXPECT_EQ(session_.store().bytes(), 20 * kMib);
  EXPECT_EQ(archive_->all_.size(), 80U) << "nothing is lost";
  EXPECT_EQ(history_.kept(), (std::vector<Stretch>{{moment(0), session_.store().newest()}}));
}

TEST_F(HistoryTest, fewerBytesTakeEffectAtOnceWhenTheArchiveGoes) {
  archive();
  runUntil(9);
  session_.store().setBytes(200'000);
  EXPECT_GT(session_.store().bytes(), 800'000U);
  history_.setArchive(nullptr);
  session_.tick();
  EXPECT_LE(session_.store().bytes(), 200'000U);
}

TEST_F(HistoryTest, stepsGoAcrossAHoleInTheArchive) {
  archive();
  runUntil(60);
  archive_->lose({moment(10.05), moment(20.05)});
  const std::vector<Stretch> kept{{moment(0), moment(10.05)}, {moment(20.05), session_.store().newest()}};
  EXPECT_EQ(history_.kept(), kept);
  const auto read = [this] {
    for (int tick = 0; tick < 10 && history_.isReading(); ++tick) {
      archive_->serve();
      session_.tick();
    }
  };
  history_.show(moment(15));
  read();
  EXPECT_EQ(session_.timeline().shown(), moment(20.05)) << "the nearest instant behind the hole";
  EXPECT_NEAR(shown("red1/a"), 20.0, 0.001);
  session_.tick();
  EXPECT_FALSE(archive_->serve()) << "there is nothing more to be read before it";
  ASSERT_TRUE(history_.step("red1/a", -1));
  read();
  EXPECT_NEAR(seconds(session_.timeline().shown().time_since_epoch()), 10.0, 0.001);
  EXPECT_NEAR(shown("red1/a"), 10.0, 0.001);
  ASSERT_TRUE(history_.step("red1/a", 1));
  read();
  EXPECT_EQ(session_.timeline().shown(), moment(20.05));
  ASSERT_TRUE(history_.step("red1/a", -3));
  read();
  EXPECT_NEAR(shown("red1/a"), 9.8, 0.001);
  ASSERT_TRUE(history_.step("red1/a", 5));
  read();
  EXPECT_NEAR(shown("red1/a"), 20.2, 0.001) << "20.0 is the first one behind the hole";
}

TEST_F(HistoryTest, oneStepsToTheMessageAtWhichSomethingIsTrue) {
  runUntil(8);
  const auto isAt = [](double time) {
    return [time](Instant at) { return std::abs(seconds(at - moment(time))) < 0.01; };
  };
  history_.show(moment(7));
  history_.stepUntil({"red1/a", "red1/slow"}, false, isAt(2.5));
  EXPECT_FALSE(history_.isStepping());
  EXPECT_NEAR(shown("red1/a"), 2.5, 0.01);
  history_.stepUntil({"red1/a"}, true, isAt(6.1));
  EXPECT_NEAR(shown("red1/a"), 6.1, 0.01);
  EXPECT_FALSE(history_.isMissed());
  history_.stepUntil({"red1/a"}, true, isAt(100));
  EXPECT_TRUE(history_.isMissed());
  EXPECT_NEAR(shown("red1/a"), 6.1, 0.01) << "nothing was found, so that the same is shown";
  history_.stepUntil({"nowhere"}, true, isAt(7));
  EXPECT_TRUE(history_.isMissed());
}

TEST_F(HistoryTest, aLongSearchForAMessageGoesOnInLaterTicks) {
  for (int i = 0; i < 5000; ++i) session_.push(reading("red1/b", 1e-3 * i, 1));
  session_.tick();
  history_.pause();
  history_.stepUntil({"red1/b"}, false, [](Instant at) { return at <= moment(0.0105); });
  EXPECT_TRUE(history_.isStepping());
  EXPECT_NEAR(shown("red1/b"), 4.999, 1e-6);
  for (int i = 0; i < 3; ++i) session_.tick();
  EXPECT_FALSE(history_.isStepping());
  EXPECT_NEAR(shown("red1/b"), 0.010, 1e-6);
}

TEST_F(HistoryTest, theSearchForAMessageReadsWhatIsArchived) {
  archive();
  runUntil(60);
  history_.pause();
  history_.stepUntil({"red1/a"}, false, [](Instant at) { return at < moment(20.05); });
  for (int i = 0; i < 200 && history_.isStepping(); ++i) {
    archive_->serve();
    session_.tick();
  }
  EXPECT_FALSE(history_.isStepping());
  EXPECT_FALSE(history_.isMissed());
  EXPECT_NEAR(shown("red1/a"), 20.0, 0.01);
}
