// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/CurveModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "robotcontrol/Modeling.pb.h"
#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

PlotSource sourceOf(const char* text) {
  return PlotSource::fromText(QString::fromUtf8(text));
}

/// A model that shows what is stored.
class CurveModelTest : public testing::Test {
 protected:
  CurveModel::Curve& curve(std::size_t row = 0) { return *model.curves()[row]; }
  std::string cell(int row, int column) const {
    return model.index(row, column).data(Qt::DisplayRole).toString().toStdString();
  }
  std::string tip(int row = 0) const {
    return model.index(row, 0).data(Qt::ToolTipRole).toString().toStdString();
  }
  void addBall(double time, double x, bool known = true) {
    robotcontrol::BallModel ball;
    ball.set_known(known);
    ball.mutable_position_in_robot()->set_x(x);
    stored.add("red1/models/ball", time, ball);
  }
  /// Lets a curve have the values of a log: each second from `begin` on the number of the second.
  std::shared_ptr<LoggedCurve> log(CurveModel::Curve& of, int begin, int end) {
    auto logged = std::make_shared<LoggedCurve>();
    for (int i = begin; i < end; ++i) logged->series.append({1.0 * i, 1.0 * i});
    of.logged = logged;
    return logged;
  }

  StoredMessages stored;
  CurveModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(CurveModelTest, aSourceIsShownOnceButWithAnotherFilterAgain) {
  EXPECT_TRUE(model.add(sourceOf("plots/a")));
  EXPECT_FALSE(model.add(sourceOf("plots/a")));
  EXPECT_TRUE(model.add(sourceOf("plots/a | derivative")));
  EXPECT_EQ(model.rowCount(), 2);
}

TEST_F(CurveModelTest, whatNamesNoValueIsNotAdded) {
  for (const char* text : {"", "plots/a | nonsense", "plots/a | average", "= 2 + 3", "= sqrt(plots/a.value",
                           "plots/a over plots/b | nonsense"})
    EXPECT_FALSE(model.add(sourceOf(text))) << text;
  EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(CurveModelTest, theLowestColorThatIsFreeIsUsedAgain) {
  for (const char* text : {"plots/a", "plots/b", "plots/c"}) ASSERT_TRUE(model.add(sourceOf(text)));
  model.remove(1);
  ASSERT_TRUE(model.add(sourceOf("plots/d")));
  EXPECT_EQ(curve(1).color, 2) << "those that stay keep theirs";
  EXPECT_EQ(curve(2).color, 1);
  model.clear();
  ASSERT_TRUE(model.add(sourceOf("plots/e")));
  EXPECT_EQ(curve().color, 0);
}

TEST_F(CurveModelTest, aCurveWithoutValuesSaysWhatIsWrong) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a")));
  EXPECT_EQ(cell(0, CurveModel::kValue), "–");
  EXPECT_EQ(tip(), "red1/plots/a: no values yet");
  EXPECT_FALSE(model.update(stored.store));
  EXPECT_EQ(cell(0, CurveModel::kValue), "missing");
  EXPECT_EQ(tip(), "red1/plots/a: nothing is published on red1/plots/a");
  EXPECT_TRUE(model.index(0, 0).data(Qt::ForegroundRole).isValid()) << "it is muted";
  stored.addPlot("red1/plots/a", 1, 2.5);
  EXPECT_TRUE(model.update(stored.store));
  EXPECT_EQ(cell(0, CurveModel::kValue), "2.5");
  EXPECT_EQ(cell(0, CurveModel::kUnit), "m");
  EXPECT_EQ(tip(), "red1/plots/a");
  EXPECT_FALSE(model.index(0, 0).data(Qt::ForegroundRole).isValid());
}

TEST_F(CurveModelTest, onlyNewPointsAreAnnounced) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a")));
  stored.addPlot("red1/plots/a", 1, 10);
  QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  EXPECT_TRUE(model.update(stored.store));
  ASSERT_EQ(changes.count(), 1);
  EXPECT_EQ(changes[0][0].toModelIndex().column(), CurveModel::kValue) << "names stay as they are";
  EXPECT_FALSE(model.update(stored.store));
  EXPECT_EQ(changes.count(), 1);
  EXPECT_EQ(curve().live.size(), 1U) << "each message is a point once";
}

TEST_F(CurveModelTest, theValueAtTheCursorIsTheNewestThatIsNotLater) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a")));
  for (const double time : {1.0, 2.0, 3.0}) stored.addPlot("red1/plots/a", time, 10 * time);
  model.update(stored.store);
  EXPECT_EQ(cell(0, CurveModel::kAtCursor), "") << "without a cursor there is no value at it";
  model.setCursor(2.9);
  EXPECT_EQ(cell(0, CurveModel::kAtCursor), "20");
  model.setCursor(3);
  EXPECT_EQ(cell(0, CurveModel::kAtCursor), "30");
  model.setCursor(0.5);
  EXPECT_EQ(cell(0, CurveModel::kAtCursor), "–");
}

TEST_F(CurveModelTest, theHeaderSaysWhereTheCursorIsSinceTheOrigin) {
  const auto header = [this] {
    return model.headerData(CurveModel::kAtCursor, Qt::Horizontal, Qt::DisplayRole).toString().toStdString();
  };
  QSignalSpy changes(&model, &QAbstractItemModel::headerDataChanged);
  EXPECT_EQ(header(), "At the cursor");
  model.setCursor(12.5);
  model.setOrigin(10);
  EXPECT_EQ(header(), "At 2.500 s");
  EXPECT_EQ(changes.count(), 2);
  model.setCursor(12.5);
  model.setOrigin(10);
  EXPECT_EQ(changes.count(), 2) << "nothing has changed";
}

TEST_F(CurveModelTest, csvHasALineForEachTimeAndGapsWhereACurveHasNoValue) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a")));
  ASSERT_TRUE(model.add(sourceOf("red1/plots/b")));
  stored.addPlot("red1/plots/a", 10, 1);
  stored.addPlot("red1/plots/a", 12, 2);
  stored.addPlot("red1/plots/b", 11, -0.5);
  stored.addPlot("red1/plots/b", 12, 1e-7);
  model.update(stored.store);
  model.setOrigin(10);
  EXPECT_EQ(model.csv().toStdString(),
            "time_s,\"red1/plots/a\",\"red1/plots/b\"\n"
            "0.000000,1,\n"
            "1.000000,,-0.5\n"
            "2.000000,2,1e-07\n");
}

TEST_F(CurveModelTest, csvOfAnEmptyPlotHasTitlesOnly) {
  EXPECT_EQ(model.csv().toStdString(), "time_s\n");
  ASSERT_TRUE(model.add(sourceOf("red1/joints/states: joints[name=\"head\"].position")));
  EXPECT_EQ(model.csv().toStdString(), "time_s,\"red1/joints/states: joints[name=\"\"head\"\"].position\"\n");
}

TEST_F(CurveModelTest, statesAreStripsAndHaveNamesEverywhere) {
  ASSERT_TRUE(model.add(sourceOf("red1/models/ball: known")));
  addBall(1, 0, false);
  addBall(2, 0, true);
  model.update(stored.store);
  EXPECT_TRUE(curve().isStrip());
  EXPECT_EQ(cell(0, CurveModel::kValue), "true");
  EXPECT_EQ(model.csv().toStdString(),
            "time_s,\"red1/models/ball: known\"\n1.000000,\"false\"\n2.000000,\"true\"\n");
  curve().asStrip = false;
  EXPECT_FALSE(curve().isStrip()) << "the user has the last word";
}

TEST_F(CurveModelTest, whatAFilterMakesOfStatesIsNoState) {
  ASSERT_TRUE(model.add(sourceOf("red1/models/ball: known | integral")));
  addBall(1, 0, true);
  addBall(3, 0, true);
  model.update(stored.store);
  EXPECT_FALSE(curve().isStrip());
  EXPECT_EQ(cell(0, CurveModel::kValue), "2");
}

TEST_F(CurveModelTest, aFilterChangesValuesAndUnit) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a | derivative")));
  stored.addPlot("red1/plots/a", 1, 5);
  model.update(stored.store);
  EXPECT_EQ(cell(0, CurveModel::kValue), "–") << "one point has no derivative";
  stored.addPlot("red1/plots/a", 1.5, 6);
  model.update(stored.store);
  EXPECT_EQ(cell(0, CurveModel::kValue), "2");
  EXPECT_EQ(cell(0, CurveModel::kUnit), "m/s");
}

TEST_F(CurveModelTest, aCurveOverAnotherOneShowsBothValues) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/y over red1/plots/x")));
  stored.addPlot("red1/plots/y", 1, 20);
  model.update(stored.store);
  EXPECT_EQ(cell(0, CurveModel::kValue), "–; 20");
  stored.addPlot("red1/plots/x", 2, 3);
  model.update(stored.store);
  EXPECT_EQ(cell(0, CurveModel::kValue), "3; 20");
  model.setCursor(1.5);
  EXPECT_EQ(cell(0, CurveModel::kAtCursor), "–; 20");
  EXPECT_EQ(model.csv().toStdString(),
            "time_s,\"red1/plots/y over red1/plots/x\",\"red1/plots/x\"\n1.000000,20,\n2.000000,,3\n");
}

TEST_F(CurveModelTest, pointsOfAnotherPlatformReplaceTheFormerOnes) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a | integral")));
  stored.addPlot("red1/plots/a", 100, 1);
  stored.addPlot("red1/plots/a", 200, 1);
  model.update(stored.store);
  stored.store.clear();
  stored.addPlot("red1/plots/a", 1, 4);
  EXPECT_TRUE(model.update(stored.store));
  ASSERT_EQ(curve().live.size(), 1U);
  EXPECT_EQ(curve().live.front(), (robotlink::Series::Point{1, 0})) << "the integral starts over, too";
}

TEST_F(CurveModelTest, whatIsHeldComesWithTheNextUpdate) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a")));
  stored.addPlot("red1/plots/a", 1, 5);
  model.update(stored.store);
  stored.addPlot("red1/plots/a", 2, 6);
  model.hold(stored.store);
  EXPECT_EQ(cell(0, CurveModel::kValue), "5") << "the legend is that of what is drawn";
  EXPECT_EQ(curve().live.size(), 1U);
  stored.addPlot("red1/plots/a", 3, 7);
  EXPECT_TRUE(model.update(stored.store));
  EXPECT_EQ(curve().live.size(), 3U);
  EXPECT_EQ(cell(0, CurveModel::kValue), "7");
}

TEST_F(CurveModelTest, theLogHasThePlaceOfWhatIsPublishedUnlessItIsComputedAnew) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a")));
  log(curve(), 0, 10);
  stored.addPlot("red1/plots/a", 4.5, 100);
  EXPECT_TRUE(model.update(stored.store));
  EXPECT_TRUE(curve().isLogged());
  EXPECT_EQ(curve().points().size(), 10U);
  EXPECT_EQ(curve().times(), std::pair(0.0, 9.0));
  EXPECT_EQ(curve().valueAt(4.2), 4);
  EXPECT_EQ(curve().valueAt(4.7), 100) << "it is newer than the one of the log";
  curve().isRecomputed = true;
  EXPECT_EQ(curve().points().size(), 1U);
  EXPECT_FALSE(model.update(stored.store)) << "the log has nothing new";
}

TEST_F(CurveModelTest, whatOnlyTheLogHasIsSaid) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a")));
  const auto logged = log(curve(), 0, 3);
  model.update(stored.store);
  EXPECT_EQ(cell(0, CurveModel::kValue), "in the log only");
  EXPECT_EQ(tip(), "red1/plots/a");
  logged->problem = QStringLiteral("the file is damaged");
  EXPECT_EQ(tip(), "red1/plots/a: the file is damaged");
  logged->isCut = true;
  EXPECT_EQ(tip(),
            "red1/plots/a: only the first values of the log are shown, the others need too much memory");
}

TEST_F(CurveModelTest, aFilterIsComputedOverTheLogAsItIsRead) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a | integral")));
  const auto logged = log(curve(), 0, 3);
  model.update(stored.store);
  EXPECT_EQ(curve().points().back().value, 2);  // the integral of t from 0 to 2
  logged->series.append({3, 3});
  EXPECT_TRUE(model.update(stored.store));
  EXPECT_EQ(curve().points().back().value, 4.5);
  EXPECT_FALSE(model.update(stored.store));
  // Another log that is as long.
  log(curve(), 100, 104);
  EXPECT_TRUE(model.update(stored.store));
  EXPECT_EQ(curve().points().size(), 4U);
  EXPECT_EQ(curve().points().back().value, (103.0 * 103 - 100 * 100) / 2);
}

TEST_F(CurveModelTest, whatAFilterMakesOfALongLogEndsWhereMemoryDoes) {
  ASSERT_TRUE(model.add(sourceOf("red1/plots/a | scale 2")));
  log(curve(), 0, 20'000);
  ASSERT_TRUE(curve().takeLogged(100'000));
  EXPECT_TRUE(curve().isFilteredCut);
  EXPECT_LT(curve().points().size(), 20'000U);
  EXPECT_GT(curve().points().size(), 1000U);
  EXPECT_EQ(curve().points().front().value, 0) << "the begin stays";
  EXPECT_NE(tip().find("too much memory"), std::string::npos);
  log(curve(), 50, 60);
  ASSERT_TRUE(curve().takeLogged(100'000));
  EXPECT_FALSE(curve().isFilteredCut);
  EXPECT_EQ(curve().points().size(), 10U);
}

}  // namespace
}  // namespace widgets::test
