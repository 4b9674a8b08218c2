// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/search/SearchModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

namespace widgets::test {
namespace {

robotlink::Instant hitAt(double seconds) {
  return robotlink::Instant(robotlink::fromSeconds(seconds));
}

SearchRow hit(double from, std::optional<double> until, const char* text, std::size_t number = 0) {
  SearchRow row{hitAt(from),
                std::nullopt,
                QStringLiteral("red1"),
                QString::fromUtf8(text),
                number == 0 ? QStringLiteral("first.mcap") : QStringLiteral("second.mcap"),
                number};
  if (until) row.until = hitAt(*until);
  return row;
}

class SearchModelTest : public testing::Test {
 protected:
  std::string cell(int row, int column) const {
    return model.index(row, column).data().toString().toStdString();
  }
  std::vector<std::string> texts() const {
    std::vector<std::string> all;
    for (const SearchRow& row : model.rows()) all.push_back(row.text.toStdString());
    return all;
  }

  SearchModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

using Texts = std::vector<std::string>;

TEST_F(SearchModelTest, hitsOfSeveralLogsLieInOrderOfTime) {
  model.add({hit(3, 4, "c"), hit(7, 8, "e")});
  model.add({hit(5, 6, "d", 1), hit(1, 2, "a", 1), hit(3, 3, "c2", 1)});
  EXPECT_EQ(texts(), (Texts{"a", "c", "c2", "d", "e"})) << "of equal times the first to be found is first";
}

TEST_F(SearchModelTest, lengthsAreShownWhereThereAreSome) {
  model.add({hit(1, 2.5, "a"), hit(2, 2, "b"), hit(3, std::nullopt, "c")});
  EXPECT_EQ(cell(0, SearchModel::kLength), "1.500");
  EXPECT_EQ(cell(1, SearchModel::kLength), "");
  EXPECT_EQ(cell(2, SearchModel::kLength), "to the end");
}

TEST_F(SearchModelTest, timesCountFromTheOrigin) {
  model.add({hit(12.3456, 13, "a")});
  EXPECT_EQ(cell(0, SearchModel::kFrom), "12.346");
  QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  model.setOrigin(hitAt(10));
  EXPECT_EQ(cell(0, SearchModel::kFrom), "2.346");
  EXPECT_EQ(cell(0, SearchModel::kLength), "0.654") << "a length has no origin";
  model.setOrigin(hitAt(10));
  EXPECT_EQ(changes.count(), 1);
}

TEST_F(SearchModelTest, theHitAtATimeIsTheLastThatHasBegun) {
  EXPECT_EQ(model.rowAt(hitAt(5)), -1);
  model.add({hit(1, 9, "a"), hit(3, 4, "b"), hit(3, 5, "c")});
  EXPECT_EQ(model.rowAt(hitAt(0.9)), -1);
  EXPECT_EQ(model.rowAt(hitAt(1)), 0);
  EXPECT_EQ(model.rowAt(hitAt(3)), 2);
  EXPECT_EQ(model.rowAt(hitAt(1000)), 2);
}

TEST_F(SearchModelTest, hitsMoveWithTheirLog) {
  model.add({hit(1, std::nullopt, "a", 0), hit(2, 3, "b", 1), hit(4, 5, "c", 0)});
  model.move(0, std::chrono::seconds(2));
  EXPECT_EQ(texts(), (Texts{"b", "a", "c"}));
  EXPECT_EQ(model.row(1).from, hitAt(3));
  EXPECT_FALSE(model.row(1).until) << "to the end of the log, wherever that is";
  EXPECT_EQ(model.row(2).until, hitAt(7));
  EXPECT_EQ(model.row(0).until, hitAt(3)) << "the other log stays";
}

TEST_F(SearchModelTest, csvQuotesTextsAndLeavesOutWhatIsOpen) {
  model.add({hit(1, std::nullopt, "he said \"no\", twice"), hit(2, 2.5, "b", 1)});
  model.setOrigin(hitAt(1));
  EXPECT_EQ(model.csv().toStdString(),
            "from_s,until_s,robot,text,log\n"
            "0.000000,,\"red1\",\"he said \"\"no\"\", twice\",\"first.mcap\"\n"
            "1.000000,1.500000,\"red1\",\"b\",\"second.mcap\"\n");
  model.clear();
  EXPECT_EQ(model.csv().toStdString(), "from_s,until_s,robot,text,log\n");
}

TEST_F(SearchModelTest, onlyTextsHaveToolTips) {
  model.add({hit(1, 2, "a long text")});
  EXPECT_EQ(model.index(0, SearchModel::kText).data(Qt::ToolTipRole).toString(),
            QStringLiteral("a long text"));
  EXPECT_FALSE(model.index(0, SearchModel::kRobot).data(Qt::ToolTipRole).isValid());
}

}  // namespace
}  // namespace widgets::test
