// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ChangeSteps.h"

#include <gmock/gmock.h>

#include "app/core/Workbench.h"
#include "robotcontrol/Logging.pb.h"
#include "tests/TestFolder.h"
#include "tests/app/ShortLog.h"
#include "tests/app/TickUntil.h"

using namespace app;
using app::test::ShortLog;
using testing::HasSubstr;

namespace {

class ChangeStepsTest : public testing::Test {
 protected:
  ChangeStepsTest() {
    workbench_.onErrors(
        [this](const robotlink::Errors& reported) { errors_ += robotlink::describe(reported); });
    workbench_.session().setRefusalHandler(
        [this](const std::string& what, const std::string& reason) { errors_ += what + ": " + reason; });
  }
  /// Runs a step to its end; why it failed.
  std::string step(const std::string& rest) {
    const auto begun = workbench_.commands().runLine("timeline.step-change " + rest);
    if (!begun) return begun.error().text;
    std::string problem;
    EXPECT_TRUE(app::test::tickUntil(workbench_, [&] {
      const auto working = workbench_.working();
      if (!working) problem = working.error().text;
      return !working || !*working;
    }));
    return problem;
  }

  TestFolder folder_;
  Workbench workbench_{folder_ / "workbench"};
  std::string errors_;
};

}  // namespace

TEST_F(ChangeStepsTest, aLogIsSteppedToWhereAValueChangesOrPassesANumber) {
  ASSERT_EQ(ShortLog::write(folder_ / "a.mcap"), "");
  ASSERT_TRUE(workbench_.commands().run("log.open", {(folder_ / "a.mcap").string()}));
  const auto status = [this] {
    auto& session = workbench_.session();
    return session.store().latestAs<robotcontrol::ReplayStatus>("replay", session.timeline().newest());
  };
  ASSERT_TRUE(app::test::tickUntil(workbench_,
                                   [&] { return workbench_.loaded() != nullptr && status() != nullptr; }));
  const auto showsFrame = [&](int frame) {
    return app::test::tickUntil(
        workbench_, [&] { return status()->time() == ShortLog::time(frame).time_since_epoch().count(); });
  };
  ASSERT_TRUE(showsFrame(1));
  const std::string number = "frames/planner.number";
  EXPECT_EQ(step(number), "");
  EXPECT_TRUE(showsFrame(2));
  EXPECT_EQ(step(number + " next " + std::to_string(ShortLog::kFirstNumber + 30)), "");
  EXPECT_TRUE(showsFrame(30));
  EXPECT_EQ(step(number + " previous"), "");
  EXPECT_TRUE(showsFrame(29));
  EXPECT_EQ(step("\"frames/planner.number > 110\" previous"), "");
  EXPECT_TRUE(showsFrame(10));
  EXPECT_THAT(step(number + " next 1000000"), HasSubstr("does not change any more"));
  EXPECT_THAT(errors_, HasSubstr("does not change any more")) << "people are told, too";
  EXPECT_THAT(step("frames/plan.number"), HasSubstr("frames/planner"));
}

TEST_F(ChangeStepsTest, whatIsKeptOfLiveRobotsIsSteppedThrough) {
  auto& session = workbench_.session();
  session.setRobots({"red1"});
  for (int i = 0; i < 100; ++i) {
    auto info = std::make_shared<robotcontrol::FrameInfo>();
    info->set_number(static_cast<std::uint64_t>(i / 10));
    session.push({"red1/frames/cognition", robotlink::Instant(std::chrono::milliseconds(100 * i)), info});
  }
  workbench_.tick();
  const auto shown = [&] { return robotlink::seconds(session.timeline().shown().time_since_epoch()); };
  EXPECT_EQ(step("frames/cognition.number previous"), "");
  EXPECT_EQ(shown(), 9);
  EXPECT_EQ(step("frames/cognition.number previous 3"), "");
  EXPECT_EQ(shown(), 3);
  EXPECT_EQ(step("frames/cognition.number"), "");
  EXPECT_EQ(shown(), 4);
  EXPECT_THAT(step("frames/cognition.number next 50"), HasSubstr("does not change any more"));
  EXPECT_EQ(shown(), 4);
  EXPECT_THAT(step("frames/cognition.numbr"), HasSubstr("numbr"));
  EXPECT_THAT(step("frames/cogniton.number"), HasSubstr("frames/cognition"));
  EXPECT_THAT(step("\"1 + 1\""), HasSubstr("stream"));
}
