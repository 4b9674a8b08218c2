// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/CompareReport.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Utf8.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::size_t countOf(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// Two variants on eight subjects, of which the second one has 3 more of a figure, give or take a little.
Comparison comparisonOf(const std::string& figure, const std::string& unit = {}) {
  Comparison comparison;
  for (int seed = 0; seed < 8; ++seed) {
    const std::string subject = "seed " + std::to_string(seed);
    comparison.add("old", subject, {{figure, unit, 10.0 + seed}});
    comparison.add("new", subject, {{figure, unit, 13.0 + seed + 0.01 * seed}});
  }
  return comparison;
}

TEST(CompareReport, onlyFieldsThatNeedItAreQuoted) {
  EXPECT_EQ(csvField("seed 1"), "seed 1");
  EXPECT_EQ(csvField(""), "");
  EXPECT_EQ(csvField("a,b"), "\"a,b\"");
  EXPECT_EQ(csvField("say \"hello\""), "\"say \"\"hello\"\"\"");
  EXPECT_EQ(csvField("two\nlines"), "\"two\nlines\"");
}

TEST(CompareReport, aComparisonOfNothingIsAPageAllTheSame) {
  const Comparison nothing;
  EXPECT_EQ(resultsCsv(nothing), "variant,subject,figure,unit,value\n");
  EXPECT_EQ(summaryCsv(nothing), "figure,unit,variant,runs,mean,low,high\n");
  EXPECT_EQ(differencesCsv(nothing), "figure,unit,from,to,runs,change,low,high,chance,real\n");
  EXPECT_THAT(reportHtml(nothing, {"none", "robotctl compare", {}}), HasSubstr("</html>"));
}

TEST(CompareReport, whatHasNoBoundsHasEmptyFields) {
  Comparison one;
  one.add("old", "seed 1", {{"error", "m", 0.5}});
  EXPECT_THAT(summaryCsv(one), HasSubstr("\nerror,m,old,1,0.5,,\n"));
  one.add("old", "seed 2", {{"error", "m", kNoNumber}});
  EXPECT_THAT(resultsCsv(one), HasSubstr("old,seed 2,error,m,\n"));
}

TEST(CompareReport, figuresAreWorseOrBetterOnlyWhereThatIsKnown) {
  const auto kindOf = [](const std::string& figure) {
    const std::string page = reportHtml(comparisonOf(figure), {"t", "c", {}});
    const auto row = page.find("<tr><td>" + figure + "</td><td>old</td><td>new</td><td class='");
    if (row == std::string::npos) return std::string("no difference");
    const auto begin = page.find("class='", row) + 7;
    return page.substr(begin, page.find('\'', begin) - begin);
  };
  EXPECT_EQ(kindOf("models/ball position mean"), "worse") << "more of an error";
  EXPECT_EQ(kindOf("models/ball missed"), "worse");
  EXPECT_EQ(kindOf("ms_per_step"), "worse");
  EXPECT_EQ(kindOf("goals of red"), "better");
  EXPECT_EQ(kindOf("real_time_factor"), "better");
  EXPECT_EQ(kindOf("goals conceded"), "worse") << "although they are goals";
  EXPECT_EQ(kindOf("ball_contacts"), "") << "nobody knows";
}

TEST(CompareReport, aChangeIsAShareOfWhatWasBefore) {
  EXPECT_THAT(reportHtml(comparisonOf("error", "m"), {"t", "c", {}}), HasSubstr(">22.5 % more</td>"));
  Comparison fromNothing;
  for (int seed = 0; seed < 8; ++seed) {
    fromNothing.add("old", std::to_string(seed), {{"error", "m", 0}});
    fromNothing.add("new", std::to_string(seed), {{"error", "m", 1.0 + 0.1 * seed}});
  }
  EXPECT_THAT(reportHtml(fromNothing, {"t", "c", {}}), HasSubstr(">more</td>"))
      << "of nothing there is no share";
}

TEST(CompareReport, figuresOfAPackageStandTogether) {
  Comparison comparison;
  for (int seed = 0; seed < 3; ++seed) {
    comparison.add("old", std::to_string(seed),
                   {{"models/ball position mean", "m", 1.0 * seed},
                    {"models/ball missed", "", 2.0 * seed},
                    {"models/pose position mean", "m", 3.0 * seed},
                    {"goals of red", "", 1.0 * seed}});
  }
  const std::string page = reportHtml(comparison, {"t", "c", {}});
  EXPECT_EQ(countOf("<tr class=group>", page), 2U);
  EXPECT_THAT(page,
              HasSubstr("<tr class=group><td colspan=3>models/ball</td></tr>\n<tr><td>position mean</td>"));
  EXPECT_THAT(page, HasSubstr("<tr><td>missed</td>"));
  EXPECT_THAT(page, HasSubstr("<tr><td>goals of red</td>")) << "this one is of no package";
}

TEST(CompareReport, figuresOfTheTaskComeFirstInUnitsThatReadWell) {
  Comparison comparison;
  for (int seed = 0; seed < 8; ++seed) {
    for (const auto& [variant, more] : {std::pair("old", 1.0), std::pair("new", 2.0)})
      comparison.add(variant, std::to_string(seed),
                     {{"models/pose position mean", "m", more * 0.25 + 0.001 * seed},
                      {"models/ball position mean", "m", more * 0.125 + 0.001 * seed},
                      {"models/ball missed", kShare, more * 0.125 + 0.001 * seed}});
  }
  ReportTitle title{"t", "c", {}};
  title.packages = {"models/ball"};
  title.notes = {"There is more to say."};
  const std::string page = reportHtml(comparison, title);
  const auto own = page.find("<h2>Figures of models/ball</h2>"), others = page.find("<h2>Other figures");
  ASSERT_NE(own, std::string::npos);
  ASSERT_NE(others, std::string::npos);
  EXPECT_LT(page.find("class=group><td colspan=4>models/ball", own), others);
  EXPECT_GT(page.find("class=group><td colspan=4>models/pose", own), others);
  EXPECT_LT(page.find("<td>models/ball position mean"), page.find("<td>models/pose position mean"));
  EXPECT_THAT(page, HasSubstr("<td>128.5 mm <span class=note>[12"));
  EXPECT_THAT(page, HasSubstr("<td>12.85 % <span class=note>[12"));
  EXPECT_THAT(page, HasSubstr("<p>There is more to say.</p>"));
  EXPECT_THAT(page, HasSubstr("weighted by their numbers of samples"));
}

TEST(CompareReport, aVariantWithoutAFigureHasNothingInItsPlot) {
  Comparison comparison;
  for (int seed = 0; seed < 3; ++seed) {
    comparison.add("walks", std::to_string(seed), {{"walk forward", "m/s", 0.2 + 0.1 * seed}});
    comparison.add("stands", std::to_string(seed), {{"fell", "", 1.0 * seed}});
  }
  const std::string page = reportHtml(comparison, {"t", "c", {}});
  EXPECT_EQ(countOf("stroke-width='3'", page), 2U) << "a mean for each figure that was measured";
  EXPECT_EQ(countOf("<circle", page), 6U);
  EXPECT_THAT(page, HasSubstr("<td>-</td>"));
}

TEST(CompareReport, longNamesAreShortenedBetweenTheirLetters) {
  // The nineteenth byte is in the middle of a letter.
  const std::string name = std::string(18, 'a') + "\u00f6" + "bcd";
  Comparison comparison;
  for (int seed = 0; seed < 3; ++seed) comparison.add(name, std::to_string(seed), {{"fell", "", 1.0 * seed}});
  const std::string page = reportHtml(comparison, {"t", "c", {}});
  EXPECT_EQ(robotlink::validUtf8(page), page);
  EXPECT_THAT(page, HasSubstr(">" + std::string(18, 'a') + "\u2026</text>"));
  EXPECT_THAT(page, HasSubstr("<th>" + name + "</th>")) << "whole in the table";
}

TEST(CompareReport, whatNamesSayIsNotReadAsHtml) {
  Comparison comparison = comparisonOf("a<b");
  ReportTitle title{"<script>", "robotctl compare --scene \"x\"", {"seed <1>"}, {}};
  title.tables.push_back({"<h>", {{"A&B"}, {"<td>"}}});
  const std::string page = reportHtml(comparison, title);
  EXPECT_THAT(page, Not(HasSubstr("<script>")));
  EXPECT_THAT(page, HasSubstr("a&lt;b"));
  EXPECT_THAT(page, HasSubstr("--scene &quot;x&quot;"));
  EXPECT_THAT(page, HasSubstr("<p class=missing>Without a result: seed &lt;1&gt;</p>"));
  EXPECT_THAT(page, HasSubstr("<th>A&amp;B</th>"));
  EXPECT_THAT(page, HasSubstr("<td>&lt;td&gt;</td>"));
}

TEST(CompareReport, allFilesAreWrittenOrTheFirstThatCannotBeIsNamed) {
  const TestFolder folder;
  const Comparison comparison = comparisonOf("error", "m");
  ASSERT_TRUE(writeReport(folder.path(), comparison, {"t", "c", {}}));
  EXPECT_EQ(folder.contents(), "differences.csv report.html results.csv summary.csv");
  EXPECT_EQ(robotlink::readFile(folder / "results.csv").value_or(""), resultsCsv(comparison));
  folder.write("taken", "no folder");
  const auto failed = writeReport(folder / "taken", comparison, {"t", "c", {}});
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().describe(), HasSubstr("report.html"));
}

}  // namespace
}  // namespace app
