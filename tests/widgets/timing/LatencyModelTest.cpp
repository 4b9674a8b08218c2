// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/LatencyModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

namespace widgets {
namespace {

class LatencyModelTest : public testing::Test {
 protected:
  void add(const char* reading, const char* command, double waitingMs, double computingMs) {
    model_.add({reading, command, waitingMs / 1000, computingMs / 1000});
  }
  QString cell(int row, int column) const {
    return model_.data(model_.index(row, column), Qt::DisplayRole).toString();
  }
  double number(int row, int column) const {
    return model_.data(model_.index(row, column), LatencyModel::kNumberRole).toDouble();
  }

  LatencyModel model_;
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(LatencyModelTest, eachReadingAndCommandHasARow) {
  add("camera/image", "joints/request", 10, 5);
  add("body/sensors", "joints/request", 1, 1);
  add("camera/image", "joints/request", 20, 5);
  EXPECT_EQ(model_.rowCount(), 0) << "views learn of it once per tick";
  model_.update();
  ASSERT_EQ(model_.rowCount(), 2);
  EXPECT_EQ(cell(0, LatencyModel::kReading), QLatin1String("camera/image"));
  EXPECT_EQ(cell(1, LatencyModel::kReading), QLatin1String("body/sensors"));
  EXPECT_EQ(cell(0, LatencyModel::kCommand), QLatin1String("joints/request"));
  EXPECT_NEAR(number(0, LatencyModel::kLast), 25, 1e-9);
  EXPECT_NEAR(number(0, LatencyModel::kMean), 20, 1e-9);
  EXPECT_NEAR(number(0, LatencyModel::kMax), 25, 1e-9);
  EXPECT_NEAR(number(0, LatencyModel::kWaiting), 15, 1e-9);
  EXPECT_NEAR(number(0, LatencyModel::kComputing), 5, 1e-9);
  EXPECT_EQ(number(0, LatencyModel::kCount), 2);
}

TEST_F(LatencyModelTest, percentilesAreThoseOfAll) {
  for (int i = 1; i <= 100; ++i) add("a", "b", i, 0);
  model_.update();
  EXPECT_NEAR(number(0, LatencyModel::kMedian), 50, 1);
  EXPECT_NEAR(number(0, LatencyModel::kNinetyFive), 95, 2);
  EXPECT_NEAR(number(0, LatencyModel::kNinetyNine), 99, 2);
}

TEST_F(LatencyModelTest, viewsAreToldOfWhatChanged) {
  QSignalSpy changed(&model_, &QAbstractItemModel::dataChanged);
  QSignalSpy added(&model_, &QAbstractItemModel::rowsInserted);
  model_.update();
  EXPECT_EQ(changed.count(), 0) << "nothing is there";
  add("a", "b", 1, 1);
  model_.update();
  EXPECT_EQ(added.count(), 1);
  add("a", "b", 2, 2);
  model_.update();
  EXPECT_EQ(added.count(), 1);
  EXPECT_EQ(changed.count(), 2);
}

TEST_F(LatencyModelTest, aResetForgetsAll) {
  add("a", "b", 1, 1);
  model_.update();
  model_.reset();
  EXPECT_EQ(model_.rowCount(), 0);
  EXPECT_EQ(model_.summary(), QString());
  add("c", "d", 3, 0);
  model_.update();
  ASSERT_EQ(model_.rowCount(), 1);
  EXPECT_EQ(cell(0, LatencyModel::kReading), QLatin1String("c"));
}

TEST_F(LatencyModelTest, theSummaryIsThatOfTheImage) {
  add("body/sensors", "joints/request", 1, 1);
  model_.update();
  EXPECT_TRUE(model_.summary().contains(QLatin1String("body/sensors")));
  add("camera/image", "joints/request", 20, 1);
  model_.update();
  EXPECT_TRUE(model_.summary().contains(QLatin1String("camera/image")));
  EXPECT_TRUE(model_.summary().contains(QLatin1String("21.0"))) << model_.summary().toStdString();
}

TEST_F(LatencyModelTest, allCellsAreExportedWithAHeader) {
  add("camera/image", "joints/request", 10, 5);
  add("body/sensors", "joints/request", 1, 1);
  model_.update();
  const QStringList lines = model_.csv().trimmed().split(QLatin1Char('\n'));
  ASSERT_EQ(lines.size(), 3);
  for (const QString& line : lines) EXPECT_EQ(line.count(QLatin1Char(',')), LatencyModel::kColumns - 1);
  EXPECT_TRUE(lines[1].contains(QLatin1String("camera/image")));
}

}  // namespace
}  // namespace widgets
