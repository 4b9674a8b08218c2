// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Comparison.h"

#include <gmock/gmock.h>

#include <fstream>

#include "app/robotctl/compare/CompareReport.h"
#include "app/robotctl/compare/RunPlan.h"
#include "app/robotctl/compare/SlurmBatch.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Bootstrap, boundsHoldTheMeanAndShrinkWithMoreValues) {
  std::vector<double> few, many;
  for (int i = 0; i < 10; ++i) few.push_back(i % 5);
  for (int i = 0; i < 1000; ++i) many.push_back(i % 5);
  const MeanInterval wide = bootstrapMean(few), narrow = bootstrapMean(many);
  EXPECT_EQ(wide.mean, 2);
  EXPECT_LT(wide.low, 2);
  EXPECT_GT(wide.high, 2);
  EXPECT_LT(narrow.high - narrow.low, (wide.high - wide.low) / 5);
  // The standard error of the mean is sqrt(2 / 1000), times 1.96.
  EXPECT_NEAR(narrow.high - 2, 1.96 * std::sqrt(2.0 / 1000), 0.01);
  EXPECT_EQ(bootstrapMean(few).low, wide.low) << "the same values have the same bounds";
}

TEST(Bootstrap, aSingleValueHasNoBounds) {
  EXPECT_EQ(bootstrapMean({3}).mean, 3);
  EXPECT_TRUE(std::isinf(bootstrapMean({3}).high));
  EXPECT_TRUE(std::isinf(bootstrapMean({}).low));
}

TEST(Comparison, errorsOfRobotsArePooledByTheirSamples) {
  const auto printed = nlohmann::json::parse(R"({"goals": {"red": 2, "blue": 1}, "scene": "x", "errors": {
    "red1": {"models/ball": {"position": {"unit": "m", "count": 3000, "mean": 0.1, "p95": 0.3},
                             "missed": 0.2, "there": 10, "false": 0.5, "reported": 0}},
    "red2": {"models/ball": {"position": {"unit": "m", "count": 1000, "mean": 0.3, "p95": 0.5},
                             "fallen": {"unit": "share of time", "count": 5, "mean": 0.2, "missed": 1.0, "there": 2},
                             "missed": 0.4, "there": 30},
             "percepts/ball": {"position": {"unit": "m", "count": 0, "mean": 0}}}}})");
  std::map<std::string, double> values;
  for (const Figure& figure : figuresIn(printed)) values[figure.name] = figure.value;
  EXPECT_DOUBLE_EQ(values.at("models/ball position mean"), 0.15);
  EXPECT_DOUBLE_EQ(values.at("models/ball position p95"), 0.35);
  EXPECT_DOUBLE_EQ(values.at("models/ball missed"), 0.35);
  EXPECT_DOUBLE_EQ(values.at("models/ball fallen missed"), 1);
  EXPECT_FALSE(values.contains("models/ball false")) << "nothing was reported";
  EXPECT_FALSE(values.contains("models/ball there")) << "a weight is no figure";
  EXPECT_FALSE(values.contains("percepts/ball position mean")) << "nothing was measured";
  EXPECT_EQ(values.at("goals of red"), 2);
}

class ComparisonTest : public testing::Test {
 protected:
  ComparisonTest() {
    for (int seed = 0; seed < 12; ++seed) {
      const std::string subject = "seed " + std::to_string(seed);
      const double luck = 10.0 * seed;  // differs more between seeds than between variants
      comparison_.add("old", subject, {{"error", "m", luck + 1}, {"cost", "", 5.0 + seed % 2}});
      comparison_.add("new, <better>", subject,
                      {{"error", "m", luck + 0.5 + 0.01 * seed}, {"cost", "", 5.0 + (seed + 1) % 2}});
    }
  }
  Comparison comparison_;
};

TEST_F(ComparisonTest, whatIsRealIsFoundOnTheSameSubjects) {
  const auto all = comparison_.differences();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].figure, "error");
  EXPECT_EQ(all[0].subjects, 12U);
  EXPECT_TRUE(all[0].isReal());
  EXPECT_NEAR(all[0].change.mean, -0.445, 1e-9);
  EXPECT_FALSE(all[1].isReal()) << "the cost goes up as often as down";
}

TEST_F(ComparisonTest, whatIsTheSameInAllRunsIsNoDifference) {
  const std::size_t before = comparison_.differences().size();
  for (int seed = 0; seed < 12; ++seed) {
    for (const char* variant : {"old", "new, <better>"})
      comparison_.add(variant, "seed " + std::to_string(seed), {{"latency", "s", 0}});
  }
  EXPECT_EQ(comparison_.differences().size(), before);
  EXPECT_THAT(reportHtml(comparison_, {}), HasSubstr("The same in all runs: latency (0 s)."));
}

TEST_F(ComparisonTest, fewRunsAreNotReal) {
  Comparison few;
  for (int seed = 0; seed < 3; ++seed) {
    few.add("old", std::to_string(seed), {{"error", "m", 5.0 + 0.1 * seed}});
    few.add("new", std::to_string(seed), {{"error", "m", 1.0 + 0.1 * seed}});
  }
  const auto all = few.differences();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_LT(all[0].change.high, 0);
  EXPECT_FALSE(all[0].isReal());
  EXPECT_THAT(reportHtml(few, {"few", "robotctl compare", {}}), HasSubstr("fewer than 6 runs"));
}

TEST_F(ComparisonTest, aPlotShowsWhatIsFarFromZeroLarge) {
  Comparison far;
  for (int seed = 0; seed < 3; ++seed) far.add("a", std::to_string(seed), {{"height", "m", 100.0 + seed}});
  EXPECT_THAT(reportHtml(far, {"far", "robotctl compare", {}}), HasSubstr(">100 m</text>"));
  Comparison near;
  for (int seed = 0; seed < 3; ++seed) near.add("a", std::to_string(seed), {{"height", "m", 1.0 + seed}});
  EXPECT_THAT(reportHtml(near, {"near", "robotctl compare", {}}), HasSubstr(">0 m</text>"));
}

TEST_F(ComparisonTest, aSubjectThatOnlyOneWasTriedOnCountsForNoDifference) {
  comparison_.add("old", "seed 99", {{"error", "m", 1e6}});
  EXPECT_EQ(comparison_.differences()[0].subjects, 12U);
}

TEST_F(ComparisonTest, tablesAreCsvAndThePageIsWhole) {
  EXPECT_THAT(resultsCsv(comparison_), HasSubstr("old,seed 3,error,m,31"));
  EXPECT_THAT(summaryCsv(comparison_), HasSubstr("error,m,\"new, <better>\",12,"));
  EXPECT_THAT(differencesCsv(comparison_), HasSubstr("error,m,old,\"new, <better>\",12,-0.44"));
  const std::string page = reportHtml(comparison_, {"a & b", "robotctl compare", {"old, seed 7"}});
  EXPECT_THAT(page, HasSubstr("<h1>a &amp; b</h1>"));
  EXPECT_THAT(page, HasSubstr("new, &lt;better&gt;"));
  EXPECT_THAT(page, HasSubstr("Without a result: old, seed 7"));
  EXPECT_THAT(page, Not(HasSubstr("http"))) << "it needs nothing else";
  EXPECT_THAT(page, HasSubstr("</html>"));
}

TEST(RunPlan, wordsOfACommandAreQuotedForTheShell) {
  EXPECT_EQ(shellLine({"run", "log:a b.mcap", "it's", ""}), "run 'log:a b.mcap' 'it'\\''s' ''");
}

TEST(RunPlan, aResultCountsOnlyForTheSameRun) {
  const TestFolder folder;
  const auto files = RunFiles::in(folder / "runs");
  ASSERT_TRUE(files);
  PlannedRun run{"a/b", "seed 1", {"sim", "x", "--seed", "1"}};
  EXPECT_FALSE(files->isDone(run));
  ASSERT_TRUE(files->prepare(run));
  EXPECT_FALSE(files->isDone(run));
  std::ofstream(files->unfinished(run)) << "{}";
  ASSERT_TRUE(files->finish(run));
  EXPECT_TRUE(files->isDone(run));
  PlannedRun longer = run;
  longer.arguments.back() = "2";
  EXPECT_FALSE(files->isDone(longer));
  ASSERT_TRUE(files->prepare(longer));
  EXPECT_FALSE(files->isDone(run)) << "the older result is gone";
  EXPECT_FALSE(files->finish(longer)) << "nothing was written";
}

TEST(RunPlan, aFolderThatCannotBeMadeIsNamed) {
  const TestFolder folder;
  std::ofstream(folder / "file") << "x";
  const auto files = RunFiles::in(folder / "file" / "runs");
  ASSERT_FALSE(files);
  EXPECT_THAT(files.error().text, HasSubstr("file"));
}

TEST(SlurmBatch, aJobOfTheArrayExecutesItsLine) {
  const TestFolder folder;
  const auto files = RunFiles::in(folder / "runs");
  ASSERT_TRUE(files);
  const SlurmBatch batch(*files);
  EXPECT_THAT(batch.script(7), HasSubstr("#SBATCH --array=1-7\n"));
  EXPECT_THAT(batch.script(7), HasSubstr("run <= 7; run += 7"));
  EXPECT_THAT(batch.script(7), HasSubstr("sed -n \"${run}p\""));
  EXPECT_THAT(batch.script(2500), HasSubstr("#SBATCH --array=1-1000\n")) << "each does two or three runs";
  EXPECT_THAT(batch.script(2500), HasSubstr("run <= 2500; run += 1000"));
  const PlannedRun run{"a", "seed 1", {"sim", "my scene"}};
  const std::string lines = batch.commands({run, run}, "/usr/bin/robotctl");
  EXPECT_THAT(lines, HasSubstr("/usr/bin/robotctl sim 'my scene' > "));
  EXPECT_THAT(lines, HasSubstr(" && mv " + files->unfinished(run).string() + " " +
                               files->result(run).string() + "\n"));
}

}  // namespace
}  // namespace app
