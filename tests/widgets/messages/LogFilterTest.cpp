// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/LogFilter.h"

#include <gtest/gtest.h>

#include "widgets/log/LogModel.h"

namespace widgets {
namespace {

using Level = LogEntry::Level;

class LogFilterTest : public testing::Test {
 protected:
  LogFilterTest() {
    std::vector<LogEntry> entries;
    const auto add = [&](Level level, const char* robot, const char* source, const char* text) {
      entries.push_back({robotlink::Instant(std::chrono::seconds(entries.size())), level,
                         QString::fromUtf8(robot), QString::fromUtf8(source), QString::fromUtf8(text)});
    };
    add(Level::kInfo, "red1", "cognition/ball-percept", "Ball (1) found");
    add(Level::kWarning, "red1", "motion", "A joint is hot");
    add(Level::kError, "blue1", "cognition", "no BALL");
    model.append(std::move(entries));
    filter.setSourceModel(&model);
  }
  /// The texts that are shown, one after the other.
  std::string shown() const {
    std::string texts;
    for (int row = 0; row < filter.rowCount(); ++row)
      texts += filter.index(row, LogModel::kText).data().toString().toStdString() + "|";
    return texts;
  }
  std::string search(const char* text, bool expression) {
    return filter.setPattern(QString::fromUtf8(text), expression).toStdString();
  }

  LogModel model;
  LogFilter filter;
};

TEST_F(LogFilterTest, showsAllAtFirst) {
  EXPECT_EQ(shown(), "Ball (1) found|A joint is hot|no BALL|");
}

TEST_F(LogFilterTest, showsALevelAndWhatIsWorse) {
  filter.setMinimumLevel(static_cast<int>(Level::kWarning));
  EXPECT_EQ(shown(), "A joint is hot|no BALL|");
  filter.setMinimumLevel(0);
  EXPECT_EQ(filter.rowCount(), 3);
}

TEST_F(LogFilterTest, showsOneRobot) {
  filter.setRobot(QStringLiteral("blue1"));
  EXPECT_EQ(shown(), "no BALL|");
  filter.setRobot({});
  EXPECT_EQ(filter.rowCount(), 3);
}

TEST_F(LogFilterTest, findsPartsOfTextsAndSourcesInAnyCaseOfLetters) {
  EXPECT_EQ(search("ball", false), "");
  EXPECT_EQ(shown(), "Ball (1) found|no BALL|");
  search("MOTION", false);
  EXPECT_EQ(shown(), "A joint is hot|") << "of its source";
  search("(1", false);
  EXPECT_EQ(shown(), "Ball (1) found|") << "which would be no expression";
}

TEST_F(LogFilterTest, findsByExpressions) {
  EXPECT_EQ(search("^(no|a) ", true), "");
  EXPECT_EQ(shown(), "A joint is hot|no BALL|");
  search("", true);
  EXPECT_EQ(filter.rowCount(), 3);
}

TEST_F(LogFilterTest, anExpressionThatIsNoneIsSaidAndTheLastOneHolds) {
  search("hot$", true);
  EXPECT_NE(search("(", true).find("at character "), std::string::npos);
  EXPECT_EQ(shown(), "A joint is hot|");
}

TEST_F(LogFilterTest, allConditionsHoldTogether) {
  filter.setRobot(QStringLiteral("red1"));
  filter.setMinimumLevel(static_cast<int>(Level::kInfo));
  search("ball", false);
  EXPECT_EQ(shown(), "Ball (1) found|");
  filter.setMinimumLevel(static_cast<int>(Level::kError));
  EXPECT_EQ(shown(), "");
}

}  // namespace
}  // namespace widgets
