// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/LogPlatform.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/process/LockstepExecutor.h"

using namespace logplayer;
using namespace std::chrono_literals;
using robotcontrol::BallModel;
using robotlink::Blocking;

namespace {

/// Writes down which package it sees in each frame.
class Watcher final : public robotlink::Process {
 public:
  using Process::Process;
  ~Watcher() override { stop(); }
  robotlink::Receiver<BallModel> ball{*this, "models/ball", Blocking::kNo};
  robotlink::Receiver<BallModel> image{*this, "camera/image", Blocking::kYes};
  std::vector<double> seen;

 protected:
  void execute() override { seen.push_back(ball.get() != nullptr ? ball.get()->standard_deviation() : -1); }
};

std::shared_ptr<const BallModel> ballOf(double deviation) {
  auto model = std::make_shared<BallModel>();
  model->set_standard_deviation(deviation);
  return model;
}

struct Bench {
  explicit Bench(const std::string& turn)
      : platform(clock, {{"models/ball", turn, BallModel::descriptor()},
                         {"camera/image", "", BallModel::descriptor()}}) {
    for (robotlink::AnySender* sender : platform.senders()) {
      robotlink::connectUnchecked(*sender, sender->package() == "models/ball"
                                               ? static_cast<robotlink::AnyReceiver&>(watcher.ball)
                                               : watcher.image);
    }
    executor.add(platform);
  }
  ~Bench() { executor.clear(); }
  void step(double deviation) {
    clock.advance(8ms);
    EXPECT_TRUE(platform.put("camera/image", ballOf(0)));
    EXPECT_TRUE(platform.put("models/ball", ballOf(deviation)));
    executor.stepPlatforms();
    executor.runProcesses();
  }

  robotlink::ManualClock clock;
  LogPlatform platform;
  Watcher watcher{"watcher", clock};
  robotlink::LockstepExecutor executor{{.advance = {}, .onStarved = {}, .onFailed = {}}};
};

}  // namespace

TEST(LogPlatform, sendsWhatThePlatformPublishedBeforeTheProcessesRun) {
  Bench bench("");
  bench.executor.add(bench.watcher);
  for (int i = 1; i <= 3; ++i) bench.step(i);
  EXPECT_EQ(bench.watcher.seen, (std::vector<double>{1, 2, 3}));
}

TEST(LogPlatform, sendsWhatALaterProcessPublishedAsLateAsItDid) {
  Bench bench("motion");
  bench.executor.add(bench.watcher);
  ASSERT_NE(bench.platform.turnOf("motion"), nullptr);
  EXPECT_EQ(bench.platform.turnOf("cognition"), nullptr);
  bench.executor.add(*bench.platform.turnOf("motion"));
  for (int i = 1; i <= 3; ++i) bench.step(i);
  EXPECT_EQ(bench.watcher.seen, (std::vector<double>{-1, 1, 2}));
}

TEST(LogPlatform, takesNothingThatItIsNotAskedForOrThatIsOfAnotherType) {
  Bench bench("");
  EXPECT_FALSE(bench.platform.put("models/pose", ballOf(1)));
  EXPECT_FALSE(bench.platform.put("models/ball", std::make_shared<robotcontrol::PlotValue>()));
  EXPECT_FALSE(bench.platform.put("models/ball", nullptr));
}
