// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/CursorModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "robotcontrol/Modeling.pb.h"
#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

/// The values 1, 2, 3, 4 at 1 s to 4 s, and a second curve without values.
class CursorModelTest : public testing::Test {
 protected:
  CursorModelTest() {
    curves.add(PlotSource::fromText(QStringLiteral("red1/plots/a")));
    curves.add(PlotSource::fromText(QStringLiteral("red1/plots/b")));
    for (const double time : {1.0, 2.0, 3.0, 4.0}) stored.addPlot("red1/plots/a", time, time);
    curves.update(stored.store);
  }
  std::vector<std::string> row(int number) const {
    std::vector<std::string> cells;
    for (int column = 0; column < cursors.columnCount(); ++column)
      cells.push_back(cursors.index(number, column).data(Qt::DisplayRole).toString().toStdString());
    return cells;
  }

  StoredMessages stored;
  CurveModel curves;
  CursorModel cursors{curves};
  QAbstractItemModelTester tester{&cursors, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

using Cells = std::vector<std::string>;

TEST_F(CursorModelTest, thereAreRowsWhileThereAreCursors) {
  EXPECT_EQ(cursors.rowCount(), 0);
  cursors.setCursors(std::pair(1.0, 3.0));
  EXPECT_EQ(cursors.rowCount(), 2);
  cursors.setCursors(std::nullopt);
  EXPECT_EQ(cursors.rowCount(), 0);
}

TEST_F(CursorModelTest, valuesAtTheCursorsAndStatisticsBetweenThem) {
  cursors.setCursors(std::pair(1.5, 4.0));
  EXPECT_EQ(row(0), (Cells{"red1/plots/a", "1", "4", "3", "2", "4", "3", "0.8165"}));
  EXPECT_EQ(row(1), (Cells{"red1/plots/b", "–", "–", "–", "–", "–", "–", "–"}));
}

TEST_F(CursorModelTest, theSecondCursorMayBeBeforeTheFirst) {
  cursors.setCursors(std::pair(4.0, 1.5));
  EXPECT_EQ(row(0), (Cells{"red1/plots/a", "4", "1", "-3", "2", "4", "3", "0.8165"}));
}

TEST_F(CursorModelTest, betweenCursorsWithoutAPointThereAreNoStatistics) {
  cursors.setCursors(std::pair(2.2, 2.8));
  EXPECT_EQ(row(0), (Cells{"red1/plots/a", "2", "2", "0", "–", "–", "–", "–"}));
  cursors.setCursors(std::pair(-5.0, 0.5));
  EXPECT_EQ(row(0), (Cells{"red1/plots/a", "–", "–", "–", "–", "–", "–", "–"}));
}

TEST_F(CursorModelTest, pointsThatArriveBetweenTheCursorsCount) {
  cursors.setCursors(std::pair(1.0, 10.0));
  EXPECT_EQ(row(0)[CursorModel::kMax], "4");
  QSignalSpy changes(&cursors, &QAbstractItemModel::dataChanged);
  stored.addPlot("red1/plots/a", 5, 9);
  curves.update(stored.store);
  EXPECT_EQ(row(0)[CursorModel::kMax], "9");
  EXPECT_EQ(row(0)[CursorModel::kSecond], "9");
  EXPECT_EQ(changes.count(), 1);
}

TEST_F(CursorModelTest, rowsFollowTheCurves) {
  cursors.setCursors(std::pair(1.0, 4.0));
  curves.remove(0);
  ASSERT_EQ(cursors.rowCount(), 1);
  EXPECT_EQ(row(0)[CursorModel::kName], "red1/plots/b");
  EXPECT_EQ(row(0)[CursorModel::kMax], "–") << "nothing is left of the curve that had this row";
  stored.addPlot("red1/plots/c", 2, 8);
  curves.add(PlotSource::fromText(QStringLiteral("red1/plots/c")));
  curves.update(stored.store);
  ASSERT_EQ(cursors.rowCount(), 2);
  EXPECT_EQ(row(1)[CursorModel::kMean], "8");
  curves.clear();
  EXPECT_EQ(cursors.rowCount(), 0);
}

TEST_F(CursorModelTest, whereTheMouseIsChangesNothing) {
  cursors.setCursors(std::pair(1.0, 4.0));
  QSignalSpy changes(&cursors, &QAbstractItemModel::dataChanged);
  curves.setCursor(2);
  EXPECT_EQ(changes.count(), 0);
}

TEST_F(CursorModelTest, statesHaveNamesAndNoStatistics) {
  robotcontrol::BallModel ball;
  stored.add("red1/models/ball", 1, ball);
  ball.set_known(true);
  stored.add("red1/models/ball", 3, ball);
  curves.add(PlotSource::fromText(QStringLiteral("red1/models/ball: known")));
  curves.update(stored.store);
  cursors.setCursors(std::pair(2.0, 4.0));
  EXPECT_EQ(row(2), (Cells{"red1/models/ball: known", "false", "true", "–", "–", "–", "–", "–"}));
}

TEST_F(CursorModelTest, theTitlesSayWhatIsSubtractedFromWhat) {
  const auto title = [this](int column) {
    return cursors.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().toStdString();
  };
  EXPECT_EQ(title(CursorModel::kFirst), "At A");
  EXPECT_EQ(title(CursorModel::kDifference), "B − A");
  EXPECT_EQ(title(CursorModel::kDeviation), "Deviation");
}

}  // namespace
}  // namespace widgets::test
