// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep is told and what it writes; that it measures is in ParameterCommandsTest.
#include "widgets/solutions/ParameterSweep.h"

#include <gtest/gtest.h>

#include <cmath>

namespace widgets::test {
namespace {

using Values = std::vector<std::string>;

Values sweptValues(const std::string& text) {
  const auto values = ParameterSweep::valuesIn(text);
  return values ? *values : Values{"fails: " + values.error().id};
}

TEST(ParameterSweep, valuesAreListedAsTheyAreTyped) {
  EXPECT_EQ(sweptValues("1,2,5"), (Values{"1", "2", "5"}));
  EXPECT_EQ(sweptValues("on,off"), (Values{"on", "off"}));
  EXPECT_EQ(sweptValues("0.50"), (Values{"0.50"}));
}

TEST(ParameterSweep, aRangeHasItsEndDespiteRounding) {
  EXPECT_EQ(sweptValues("0.1:0.5:0.1"), (Values{"0.1", "0.2", "0.3", "0.4", "0.5"}));
  EXPECT_EQ(sweptValues("0:0.3:0.1"), (Values{"0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(sweptValues("0:1:0.3"), (Values{"0", "0.3", "0.6", "0.9"}));
  EXPECT_EQ(sweptValues("3:1:-1"), (Values{"3", "2", "1"}));
  EXPECT_EQ(sweptValues("2:2:1"), (Values{"2"}));
}

TEST(ParameterSweep, textsThatAreNoValuesFail) {
  for (const char* text : {"", ",", "1,,2", "1:2", "1:2:0", "1:2:-1", "1:2:3:4", "a:2:1", "1:nan:1",
                           "1:inf:1", "::", "0:1:1e-9"})
    EXPECT_EQ(sweptValues(text), Values{"fails: sweep.values"}) << text;
}

TEST(ParameterSweep, aFailureRepeatsTheTextAndSaysHowToWriteIt) {
  const auto values = ParameterSweep::valuesIn("1:2");
  ASSERT_FALSE(values);
  EXPECT_NE(values.error().text.find("not '1:2'"), std::string::npos) << values.error().text;
  EXPECT_NE(values.error().text.find("0.1:0.5:0.1"), std::string::npos);
}

TEST(ParameterSweep, thereAreAThousandValuesAtMost) {
  EXPECT_EQ(sweptValues("1:1000:1").size(), 1000U);
  EXPECT_EQ(sweptValues("1:1001:1"), Values{"fails: sweep.values"});
  std::string list = "0";
  for (int i = 1; i < 1000; ++i) list += "," + std::to_string(i);
  EXPECT_EQ(sweptValues(list).size(), 1000U);
  EXPECT_EQ(sweptValues(list + ",1000"), Values{"fails: sweep.values"});
}

TEST(ParameterSweepRow, figuresOfMeasurements) {
  ParameterSweep::Row row{"1"};
  for (const double figure : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) row.add(figure);
  EXPECT_EQ(row.count, 8U);
  EXPECT_DOUBLE_EQ(row.mean, 5);
  EXPECT_DOUBLE_EQ(row.deviation(), std::sqrt(32.0 / 7));
  EXPECT_EQ(row.minimum, 2);
  EXPECT_EQ(row.maximum, 9);
}

TEST(ParameterSweepRow, extremesOfNegativeFiguresAreNotZero) {
  ParameterSweep::Row row{"1"};
  row.add(-3);
  EXPECT_EQ(row.maximum, -3);
  EXPECT_EQ(row.deviation(), 0) << "one figure does not deviate";
}

TEST(ParameterSweepRow, smallDeviationsOfLargeFiguresAreKept) {
  ParameterSweep::Row row{"1"};
  for (const double figure : {1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}) row.add(figure);
  EXPECT_DOUBLE_EQ(row.deviation(), std::sqrt(30.0));
}

TEST(ParameterSweepRow, csvLeavesOutWhatWasNotMeasured) {
  ParameterSweep::Row measured{"0.1"}, nothing{"on"};
  measured.add(1);
  measured.add(2);
  EXPECT_EQ(ParameterSweep::csv({measured, nothing}),
            "value,count,mean,deviation,minimum,maximum\n"
            "0.1,2,1.5,0.707106781,1,2\n"
            "on,0,,,,\n");
  EXPECT_EQ(ParameterSweep::csv({}), "value,count,mean,deviation,minimum,maximum\n");
}

}  // namespace
}  // namespace widgets::test
