// SPDX-License-Identifier: GPL-3.0-or-later
// What simulated platforms of all kinds report about being set up and shut down.
#include <gmock/gmock.h>

#include "app/platforms/simulated/SimulatedRun.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"

using namespace app;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

namespace {

constexpr char kWasSetUp[] = "The platform was set up in [0-9.]+ ms\\.";
constexpr char kWasShutDown[] = "The platform was shut down in [0-9.]+ ms\\.";

struct Scenario {
  const char* scene;
  const char* model;
};

class PlatformReports : public testing::TestWithParam<Scenario> {
 protected:
  void SetUp() override {
    RunOptions options;
    options.scene = robotlink::resource(std::string("scenes/") + GetParam().scene);
    if (*GetParam().model != '\0')
      options.robots = simcore::RobotsToAdd{.model = GetParam().model, .count = 1};
    SimulatedRun::Listeners listeners;
    listeners.platform = [this](const std::string&, robotlink::Instant, const std::string& text) {
      texts_.push_back(text);
    };
    auto run = SimulatedRun::create(options, std::move(listeners));
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
  }
  void play(int steps) {
    for (int i = 0; i < steps; ++i) run_->step();
  }
  /// Removes and returns the sentences so far.
  std::vector<std::string> texts() { return std::exchange(texts_, {}); }

  /// Declared before the run, which reports until its end.
  std::vector<std::string> texts_;
  std::unique_ptr<SimulatedRun> run_;
};

}  // namespace

TEST_P(PlatformReports, sayHowLongSettingUpAndShuttingDownTook) {
  EXPECT_THAT(texts(), ElementsAre(MatchesRegex(kWasSetUp)));
  play(10);
  texts();
  ASSERT_TRUE(run_->reset(2).empty());
  EXPECT_THAT(texts(), ElementsAre(MatchesRegex(kWasShutDown), MatchesRegex(kWasSetUp)));
  run_.reset();
  EXPECT_THAT(texts(), ElementsAre(MatchesRegex(kWasShutDown)));
}

INSTANTIATE_TEST_SUITE_P(OfAllKinds, PlatformReports,
                         testing::Values(Scenario{"field2002.sdf", ""}, Scenario{"pioneer.sdf", ""},
                                         Scenario{"house.map", "burger"}));

TEST(SimulatedPioneerReports, aMicrocontrollerHasTheLimitsOfItsDescription) {
  RunOptions options;
  options.scene = robotlink::resource("scenes/pioneer.sdf");
  auto run = SimulatedRun::create(options, {});
  ASSERT_TRUE(run) << robotlink::describe(run.error());
  const auto& description = *(*run)->description("p3at1");
  const auto& pioneer = *(*run)->world().pioneers().front();
  const auto& settings = pioneer.session().settings();
  EXPECT_EQ(settings.lowVoltage, description.battery->low);
  EXPECT_EQ(settings.shutdownVoltage, description.battery->empty);
  EXPECT_EQ(settings.fullVoltage, description.battery->full);
  EXPECT_EQ(settings.motion.speed, description.drive->maximumSpeed);
  EXPECT_EQ(settings.sonars, 16);
}

TEST(SimulatedPioneerReports, sayWhatAMicrocontrollerWasAskedFor) {
  RunOptions options;
  options.scene = robotlink::resource("scenes/pioneer.sdf");
  std::vector<std::string> texts;
  SimulatedRun::Listeners listeners;
  listeners.platform = [&](const std::string&, robotlink::Instant, const std::string& text) {
    texts.push_back(text);
  };
  auto run = SimulatedRun::create(options, std::move(listeners));
  ASSERT_TRUE(run) << robotlink::describe(run.error());
  for (int i = 0; i < 250; ++i) (*run)->step();
  EXPECT_THAT(texts, Contains(AllOf(StartsWith("The robot"), testing::HasSubstr("was set up in"),
                                    testing::HasSubstr("sonars on, laser on, motors on."))));
}
