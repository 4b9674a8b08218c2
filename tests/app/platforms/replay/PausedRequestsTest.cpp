// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a robot in a pause is answered at once, and what the views read shows it, while no time
// passes: the same in a simulation and on a log.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "app/core/Workbench.h"
#include "app/platforms/replay/ReplayFeed.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/TestFolder.h"
#include "tests/app/TickUntil.h"
#include "tests/app/platforms/replay/ReplayFixture.h"

using namespace app;
using app::test::keyRequest;
using app::test::selectRequest;
using robotcontrol::Request;

namespace {

enum class PausedHost { kSimulation, kLog };

class PausedRequestsTest : public ::testing::TestWithParam<PausedHost> {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TestFolder;
    app::test::recordSimulation(logFile(), "compact", 100);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::filesystem::path logFile() { return folder_->path() / "paused.mcap"; }

  void SetUp() override {
    workbench_ = std::make_unique<Workbench>(folder_->path() / "workbench");
    workbench_->onErrors([this](const robotlink::Errors& errors) { errors_ += robotlink::describe(errors); });
    if (GetParam() == PausedHost::kSimulation) {
      workbench_->open(SimulationFeed::opening(defaultSimulation()));
    } else {
      ReplayOptions options;
      options.logs = {{logFile()}};
      workbench_->open(ReplayFeed::opening(std::move(options)));
    }
    ASSERT_TRUE(test::tickUntil(*workbench_, [this] { return !workbench_->loading(); }));
    if (GetParam() == PausedHost::kLog) {
      ASSERT_EQ(ask(recomputing()), "");
    }
    time_ = workbench_->session().timeline().newest();
  }
  void TearDown() override {
    // Also after whatever the answers have set going.
    Request nothing;
    if (GetParam() == PausedHost::kSimulation) {
      nothing.mutable_control_simulation()->set_speed(-1);
    } else {
      nothing.mutable_control_replay();
    }
    EXPECT_EQ(ask(nothing), "");
    EXPECT_TRUE(!holds_ || holds_()) << "and it stays so";
    EXPECT_EQ(workbench_->session().timeline().newest(), time_) << "no time has passed";
    EXPECT_EQ(errors_, "");
  }

  static Request recomputing() {
    Request request;
    for (const char* package : {"red1/percepts/regions", "red1/models/ball"}) {
      auto& choice = *request.mutable_control_replay()->add_packages();
      choice.set_package(package);
      choice.set_source(robotcontrol::ControlReplay::RECOMPUTED);
    }
    return request;
  }
  /// The reason of the refusal; empty if the request was accepted. What holds at the answer is kept.
  std::string ask(const Request& request, std::function<bool()> shown = {}) {
    std::optional<std::string> reason;
    bool atOnce = true;
    workbench_->session().request(request, [&](const robotcontrol::RequestResult& result) {
      reason = result.accepted() ? "" : result.reason();
      if (shown) atOnce = shown();
    });
    if (!test::tickUntil(*workbench_, [&] { return reason.has_value(); })) return "no answer";
    EXPECT_TRUE(atOnce) << "who is answered sees it";
    if (shown) holds_ = std::move(shown);
    return *reason;
  }
  template <typename T>
  const T* newest(const std::string& stream) {
    auto& session = workbench_->session();
    return session.store().latestAs<T>("red1/" + stream, session.timeline().newest());
  }

  static TestFolder* folder_;
  std::string errors_;
  std::unique_ptr<Workbench> workbench_;
  robotlink::Instant time_;
  std::function<bool()> holds_;
};

TestFolder* PausedRequestsTest::folder_ = nullptr;

}  // namespace

TEST_P(PausedRequestsTest, aDebugKeyIsSwitchedOn) {
  const auto shown = [this] {
    const auto* table = newest<robotcontrol::KeyTable>("tables/keys");
    return table != nullptr && std::any_of(table->keys().begin(), table->keys().end(), [](const auto& key) {
             return key.name() == "segmentation/regions" &&
                    key.mode().kind() == robotcontrol::KeyMode::ALWAYS;
           });
  };
  EXPECT_FALSE(shown());
  EXPECT_EQ(ask(keyRequest("red1", "segmentation/regions"), shown), "");
}

TEST_P(PausedRequestsTest, aSolutionIsSwitched) {
  const auto shown = [this] {
    const auto* table = newest<robotcontrol::SolutionTable>("tables/solutions");
    return table != nullptr &&
           std::any_of(table->tasks().begin(), table->tasks().end(), [](const auto& task) {
             return task.name() == "ball-model" && task.active() == "last-percept";
           });
  };
  EXPECT_FALSE(shown());
  EXPECT_EQ(ask(selectRequest("red1", "ball-model", "last-percept"), shown), "");
}

TEST_P(PausedRequestsTest, aSolutionThatThereIsNotIsRefused) {
  EXPECT_THAT(ask(selectRequest("red1", "ball-model", "telepathy")), ::testing::HasSubstr("telepathy"));
}

TEST_P(PausedRequestsTest, parametersAreReadAndSet) {
  const auto values = [this] {
    return newest<robotcontrol::ParameterValues>("parameters/ball-model/last-percept");
  };
  Request request;
  request.set_robot("red1");
  request.mutable_get_parameters()->set_task("ball-model");
  request.mutable_get_parameters()->set_solution("last-percept");
  ASSERT_EQ(ask(request, [&] { return values() != nullptr; }), "");
  const robotcontrol::PackageCopy before = values()->value();
  auto& details = *request.mutable_set_parameters();
  details.set_task("ball-model");
  details.set_solution("last-percept");
  details.mutable_value()->set_type(before.type());
  // The first field, `memory`, as 0.125 s.
  details.mutable_value()->set_data(std::string("\x09\0\0\0\0\0\0\xc0\x3f", 9));
  ASSERT_NE(before.data(), details.value().data());
  const std::string data = details.value().data();
  EXPECT_EQ(ask(request, [values, data] { return values() != nullptr && values()->value().data() == data; }),
            "");
}

TEST_P(PausedRequestsTest, aColorTableIsInUse) {
  Request request;
  request.set_robot("red1");
  auto& table = *request.mutable_set_color_table()->mutable_table();
  table.set_cells(std::string(std::size_t{64} * 64 * 64, '\1'));
  table.add_class_names("orange");
  table.set_source("/home/me/orange.c64");
  EXPECT_EQ(ask(request,
                [this] {
                  const auto* inUse = newest<robotcontrol::ColorTable>("tables/colors");
                  return inUse != nullptr && inUse->source() == "/home/me/orange.c64";
                }),
            "");
}

INSTANTIATE_TEST_SUITE_P(Hosts, PausedRequestsTest,
                         ::testing::Values(PausedHost::kSimulation, PausedHost::kLog), [](const auto& host) {
                           return host.param == PausedHost::kSimulation ? "simulation" : "log";
                         });
