// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/LogSearch.h"

#include <gmock/gmock.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Computes a ball at x = number of the frame, and publishes it three frames late; so the last three are
/// missing.
class LateBall final : public Computation {
 public:
  static constexpr char kStream[] = "red1/percepts/ball";
  static constexpr int kLate = 3;

  std::vector<std::string> streams() const override { return {kStream, "red1/percepts/never"}; }
  robotlink::Result<std::vector<std::string>> run(const std::set<std::string>& streams,
                                                  const Visit& visit) override {
    EXPECT_THAT(streams, ElementsAre(kStream));
    for (int frame = 0; frame < 100; ++frame) {
      std::vector<robotlink::StreamMessage> messages;
      if (frame >= kLate) {
        auto ball = std::make_shared<robotcontrol::BallModel>();
        ball->mutable_position_in_robot()->set_x(frame - kLate);
        messages.push_back({kStream, sampleTime(frame - kLate), std::move(ball)});
      }
      if (const auto done = visit(sampleTime(frame), std::move(messages)); !done)
        return tl::unexpected(done.error());
    }
    return std::vector<std::string>{"red1: it was late"};
  }
};

MakeComputation lateBall() {
  return [](const auto&) { return std::unique_ptr<Computation>(std::make_unique<LateBall>()); };
}

class LogSearchTest : public testing::Test {
 protected:
  void SetUp() override { SampleLog{}.write(folder_ / "a.mcap"); }
  std::shared_ptr<LogFile> log() const {
    auto file = LogFile::open(folder_ / "a.mcap", {});
    EXPECT_TRUE(file);
    return *file;
  }
  /// The hits as "robot from-until", in frames of the log.
  std::vector<std::string> hits(const std::string& expression, const ExportOptions& options = {}) const {
    SearchReport report;
    const auto all = hitsWith({}, expression, options, report);
    EXPECT_THAT(report.losses, IsEmpty());
    EXPECT_THAT(report.computed, IsEmpty());
    return all;
  }
  std::vector<std::string> hitsWith(const ComputedStreams& computed, const std::string& expression,
                                    const ExportOptions& options, SearchReport& whole) const {
    std::vector<std::string> all;
    const auto frame = [](robotlink::Instant time) {
      return std::to_string(time.time_since_epoch() / std::chrono::milliseconds(40));
    };
    const auto found = [&](const SearchHit& hit) {
      all.push_back(hit.robot + " " + frame(hit.from) + "-" + (hit.until ? frame(*hit.until) : "end"));
      return true;
    };
    const auto report = searchLog(log(), expression, options, found, computed);
    EXPECT_TRUE(report) << report.error().describe();
    if (report) whole = *report;
    EXPECT_EQ(whole.hits, all.size());
    return all;
  }

  TestFolder folder_;
};

TEST_F(LogSearchTest, findsTheSpansInWhichAConditionIsTrue) {
  EXPECT_THAT(hits("mod(models/ball.position_in_robot.x, 40) >= 30"),
              ElementsAre("red1 30-40", "red1 70-80"));
  EXPECT_THAT(hits("red1/models/ball.position_in_robot.x > 97"), ElementsAre(" 98-end"));
  EXPECT_THAT(hits("models/ball.position_in_robot.x < 2"), ElementsAre("red1 0-2"));
}

TEST_F(LogSearchTest, messagesOfOneTimeCountTogether) {
  // The frame's number is that of the ball, plus one: never true between the two messages, either.
  EXPECT_THAT(hits("frames/cognition.number != models/ball.position_in_robot.x + 1"), IsEmpty());
}

TEST_F(LogSearchTest, valuesFromBeforeTheRangeAreInEffectAtItsStart) {
  const ExportOptions options{.from = sampleTime(40), .to = sampleTime(60)};
  EXPECT_THAT(hits("models/ball.position_in_robot.x > 30", options), ElementsAre("red1 40-end"));
}

TEST_F(LogSearchTest, textsAreHitsOneByOne) {
  EXPECT_THAT(hits("log.message =~ \"frame [35]0\""), ElementsAre("red1 30-30", "red1 50-50"));
  EXPECT_THAT(hits("log.level == \"WARNING\" && models/ball.position_in_robot.x > 75"),
              ElementsAre("red1 80-80", "red1 90-90"));
  std::string text;
  ASSERT_TRUE(searchLog(log(), "log.level >= 3", {}, [&](const SearchHit& hit) {
    text = dynamic_cast<const foxglove::Log&>(*hit.text->value).message();
    return false;
  }));
  EXPECT_THAT(text, HasSubstr("frame 0"));
}

TEST_F(LogSearchTest, endsWhenNoMoreHitsAreWanted) {
  int count = 0;
  const auto report = searchLog(log(), "log.level >= 3", {}, [&](const SearchHit&) { return ++count < 3; });
  ASSERT_TRUE(report);
  EXPECT_EQ(report->hits, 3U);
}

TEST_F(LogSearchTest, aValueThatNoMessageHasIsNamed) {
  const auto report = searchLog(log(), "joints/states.joints[name=\"tail\"].position > 1", {},
                                [](const SearchHit&) { return true; });
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->hits, 0U);
  ASSERT_EQ(report->losses.size(), 1U);
  EXPECT_THAT(report->losses.front(), HasSubstr("red1/joints/states.joints[name=\"tail\"].position"));
}

TEST_F(LogSearchTest, endsWhenItIsCanceled) {
  ExportOptions options;
  options.progress = [](double) { return false; };
  const auto report = searchLog(log(), "models/ball.known", options, [](const SearchHit&) { return true; });
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.given-up");
}

TEST_F(LogSearchTest, whatTheLogLacksIsComputed) {
  std::vector<std::set<std::string>> begun;
  const ComputedStreams computed{lateBall(), [&](const auto& streams) { begun.push_back(streams); }};
  SearchReport report;
  EXPECT_THAT(hitsWith(computed, "mod(percepts/ball.position_in_robot.x, 40) >= 30", {}, report),
              ElementsAre("red1 30-40", "red1 70-80"));
  EXPECT_THAT(report.computed, ElementsAre(LateBall::kStream));
  EXPECT_THAT(report.losses, ElementsAre("red1: it was late"));
  EXPECT_THAT(begun, ElementsAre(report.computed));
  const ExportOptions range{.from = sampleTime(40), .to = sampleTime(60)};
  EXPECT_THAT(hitsWith(computed, "percepts/ball.position_in_robot.x > 30", range, report),
              ElementsAre("red1 40-end"));
  EXPECT_THAT(hitsWith(computed, "percepts/ball.position_in_robot.x < 50", range, report),
              ElementsAre("red1 40-50"));
  begun.clear();
  EXPECT_THAT(hitsWith(computed, "models/ball.position_in_robot.x > 97", {}, report),
              ElementsAre("red1 98-end"));
  EXPECT_THAT(begun, IsEmpty()) << "the log has it";
  EXPECT_THAT(report.computed, IsEmpty());
}

TEST_F(LogSearchTest, whatIsComputedLateIsComparedWithWhatTheLogHasOfTheSameTime) {
  SearchReport report;
  EXPECT_THAT(hitsWith({lateBall()}, "percepts/ball.position_in_robot.x != models/ball.position_in_robot.x",
                       {}, report),
              ElementsAre("red1 97-end"));
}

TEST_F(LogSearchTest, aComputationEndsWhenItIsCanceledOrEnoughIsFound) {
  const auto reportWith = [this](const ExportOptions& options) {
    return searchLog(log(), "mod(percepts/ball.position_in_robot.x, 2) == 1", options,
                     [](const SearchHit&) { return false; }, {lateBall()});
  };
  ExportOptions canceled;
  canceled.progress = [](double) { return false; };
  const auto report = reportWith(canceled);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.given-up");
  const auto enough = reportWith({});
  ASSERT_TRUE(enough) << enough.error().describe();
  EXPECT_EQ(enough->hits, 1U);
}

TEST_F(LogSearchTest, whyNothingIsComputedIsSaid) {
  const auto refusedWith = [this](const std::string& expression, const MakeComputation& make) {
    const auto report = searchLog(log(), expression, {}, [](const SearchHit&) { return true; }, {make});
    EXPECT_FALSE(report);
    return report ? std::string() : report.error().text;
  };
  EXPECT_THAT(refusedWith("percepts/bal.known", lateBall()), HasSubstr("did you mean 'percepts/ball'"));
  const auto broken = [](const auto&) -> robotlink::Result<std::unique_ptr<Computation>> {
    return robotlink::failure("layout.wrong", "the layout is wrong");
  };
  EXPECT_THAT(refusedWith("percepts/ball.known", broken),
              AllOf(HasSubstr("there is no stream percepts/ball"), HasSubstr("the layout is wrong")));
}

TEST_F(LogSearchTest, anExpressionThatDoesNotFitTheLogIsRefused) {
  const auto refused = [&](const std::string& expression) {
    const auto report = searchLog(log(), expression, {}, [](const SearchHit&) { return true; });
    EXPECT_FALSE(report);
    return report ? std::string() : report.error().text;
  };
  EXPECT_THAT(refused("models/bal.known"), HasSubstr("did you mean 'models/ball'"));
  EXPECT_THAT(refused("models/ball.knwn"), HasSubstr("did you mean 'known'"));
  EXPECT_THAT(refused("1 > 0"), HasSubstr("names no stream"));
  EXPECT_THAT(refused("models/ball.known >"), HasSubstr("ends too early"));
}

}  // namespace
}  // namespace logplayer
