// SPDX-License-Identifier: GPL-3.0-or-later
// What a platform that is served publishes while nobody reads it.
#include <gtest/gtest.h>

#include <map>

#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Geometry.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"
#include "tests/app/served/ServedTest.h"

namespace app {
namespace {

using Demand = PlatformFeed::Demand;
namespace streams = robotlink::streams;

/// A simulation that is stepped by hand, and how many messages of each stream come into its session.
class SimulationDemandTest : public testing::Test {
 protected:
  SimulationDemandTest() {
    session_.addListener({[this](const robotlink::StreamMessage& message) { ++counts_[message.path]; }, {}});
    auto feed = SimulationFeed::create(defaultSimulation(), session_, recorder_);
    EXPECT_TRUE(feed) << robotlink::describe(feed.error());
    feed_ = std::move(*feed);
    feed_->begin();
  }
  ~SimulationDemandTest() override { feed_->end(); }
  /// The numbers of messages in so many steps.
  std::map<std::string, int> step(int steps) {
    session_.tick();
    counts_.clear();
    for (int i = 0; i < steps; ++i) feed_->step();
    session_.tick();
    return counts_;
  }

  std::map<std::string, int> counts_;
  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  std::unique_ptr<SimulationFeed> feed_;
};

TEST_F(SimulationDemandTest, whatNobodyReadsIsNotPublished) {
  step(10);
  feed_->setDemand({false, false});
  auto counts = step(100);
  for (const std::string path : {streams::kTransforms, streams::kSimulation, streams::kRecording})
    EXPECT_EQ(counts[path], 0) << path;
  EXPECT_EQ(counts["red1/frames/cognition"], 0);
  feed_->setDemand({true, false});
  counts = step(100);
  EXPECT_EQ(counts[streams::kTransforms], 0);
  EXPECT_EQ(counts[streams::kSimulation], 100);
  EXPECT_GT(counts["red1/frames/cognition"], 0);
}

TEST_F(SimulationDemandTest, whoBeginsToReadGetsThePresentStateAlsoInAPause) {
  feed_->setDemand({false, false});
  step(100);
  feed_->setDemand({true, true});
  session_.tick();
  for (const char* path : {streams::kTransforms, streams::kSimulation}) {
    const auto* newest = session_.store().latest(path, robotlink::Instant::max());
    ASSERT_NE(newest, nullptr) << path;
    EXPECT_EQ(newest->time, robotlink::Instant(100 * SimulatedWorld::kStep)) << path;
  }
}

/// A platform that has transforms, and remembers what is read of it.
class DemandedFeed : public PlatformFeed {
 public:
  struct Noted {
    std::mutex mutex;
    Demand demand;
  };

  DemandedFeed(robotlink::Session& session, std::shared_ptr<Noted> noted)
      : session_(session), noted_(std::move(noted)) {}
  void begin() override {}
  std::optional<robotlink::PacedThread::Clock::time_point> due() override { return next_; }
  /// As other platforms do, it publishes again and again: a session forgets what came before its platform.
  void step() override {
    next_ = robotlink::PacedThread::Clock::now() + std::chrono::milliseconds(10);
    session_.push({streams::kTransforms, robotlink::Instant(std::chrono::seconds(1)),
                   std::make_shared<foxglove::FrameTransforms>()});
  }
  robotlink::Errors setLayout(const std::filesystem::path&) override { return {}; }
  LoadedPlatform describe() const override { return {}; }
  void publishStatus() override {}
  void setDemand(const Demand& demand) override {
    const std::lock_guard lock(noted_->mutex);
    noted_->demand = demand;
  }

 protected:
  robotlink::Result<void> requestRobot(const robotcontrol::Request&) override { return {}; }

 private:
  robotlink::Session& session_;
  robotlink::PacedThread::Clock::time_point next_ = robotlink::PacedThread::Clock::now();
  const std::shared_ptr<Noted> noted_;
};

class ServedDemandTest : public test::ServedTest {
 protected:
  explicit ServedDemandTest(
      std::shared_ptr<DemandedFeed::Noted> noted = std::make_shared<DemandedFeed::Noted>())
      : ServedTest({"demanded",
                    {},
                    [noted](const PlatformContext& context) -> PlatformOpening::Made {
                      return std::make_unique<DemandedFeed>(context.session, noted);
                    }}),
        noted_(std::move(noted)) {}
  bool becomes(const Demand& demand) {
    return eventually([&] {
      const std::lock_guard lock(noted_->mutex);
      return noted_->demand == demand;
    });
  }

  const std::shared_ptr<DemandedFeed::Noted> noted_;
};

TEST_F(ServedDemandTest, isThatOfTheClients) {
  while (!channels_.contains(streams::kTransforms)) hear();
  EXPECT_TRUE(becomes({true, false}));
  client_->send(robotlink::websocket::Subscribe{{{1, channels_[streams::kTransforms]}}});
  EXPECT_TRUE(becomes({true, true}));
  client_->cut();
  EXPECT_TRUE(becomes({false, false}));
}

}  // namespace
}  // namespace app
