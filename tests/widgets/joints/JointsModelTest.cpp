// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/joints/JointsModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <limits>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

using robotlink::radians;

/// A robot with a head and a mouth.
class JointsModelTest : public testing::Test {
 protected:
  JointsModelTest() {
    robot.joints = {{"pan", radians(-90), radians(90), radians(180)},
                    {"mouth", radians(-45), radians(0), radians(60)}};
  }
  /// Measured angles, in the order of their names.
  void measure(double time, const std::vector<std::pair<const char*, double>>& angles,
               const char* path = "red1/joints/states") {
    foxglove::JointStates states;
    for (const auto& [name, degrees] : angles) {
      states.add_joints()->set_name(name);
      states.mutable_joints()->rbegin()->set_position(radians(degrees));
    }
    stored.add(path, time, states);
  }
  void request(double time, const std::vector<double>& degrees) {
    robotcontrol::JointRequest wanted;
    for (const double angle : degrees) wanted.add_positions(radians(angle));
    stored.add("red1/joints/request", time, wanted);
  }
  void show(double time = 100, const std::map<std::string, double>& commanded = {}) {
    model.show(&robot, "red1", stored.store, atSeconds(time), commanded);
  }
  std::string cell(int row, int column) const {
    return model.index(row, column).data().toString().toStdString();
  }
  std::string tip(int row, int column) const {
    return model.index(row, column).data(Qt::ToolTipRole).toString().toStdString();
  }

  robotlink::RobotDescription robot;
  StoredMessages stored;
  JointsModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

TEST_F(JointsModelTest, withoutMessagesOnlyTheLimitsAreKnown) {
  show();
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(cell(0, JointsModel::kName), "pan");
  EXPECT_EQ(cell(0, JointsModel::kLimits), "-90.0 … 90.0");
  EXPECT_EQ(cell(1, JointsModel::kLimits), "-45.0 … 0.0");
  for (const int column : {JointsModel::kRequested, JointsModel::kMeasured, JointsModel::kError,
                           JointsModel::kSpeed, JointsModel::kLoad})
    EXPECT_EQ(cell(0, column), "–") << column;
}

TEST_F(JointsModelTest, theErrorIsRequestedMinusMeasured) {
  measure(1, {{"pan", 20}, {"mouth", -10}});
  request(1, {30, -10.04});
  show();
  EXPECT_EQ(cell(0, JointsModel::kRequested), "30.0");
  EXPECT_EQ(cell(0, JointsModel::kMeasured), "20.0");
  EXPECT_EQ(cell(0, JointsModel::kError), "10.0");
  EXPECT_EQ(cell(1, JointsModel::kError), "0.0") << "there is no negative zero";
}

TEST_F(JointsModelTest, measuredJointsAreFoundByNameWhereverTheyAre) {
  measure(1, {{"tail", 1}, {"mouth", -10}, {"pan", 20}});
  show();
  EXPECT_EQ(cell(0, JointsModel::kMeasured), "20.0");
  EXPECT_EQ(cell(1, JointsModel::kMeasured), "-10.0");
  EXPECT_EQ(model.rowOf("mouth"), 1);
  EXPECT_EQ(model.rowOf("tail"), -1) << "the robot has no such joint";
}

TEST_F(JointsModelTest, aRequestMayBeShorterOrLeaveJointsAsTheyAre) {
  request(1, {kNothing});
  show();
  EXPECT_EQ(cell(0, JointsModel::kRequested), "–");
  EXPECT_EQ(cell(1, JointsModel::kRequested), "–");
  request(2, {1, 2, 3});
  show();
  EXPECT_EQ(cell(1, JointsModel::kRequested), "2.0");
}

TEST_F(JointsModelTest, theInstantIsThatOfTheTimeline) {
  measure(1, {{"pan", 1}});
  measure(2, {{"pan", 2}});
  show(1.5);
  EXPECT_EQ(cell(0, JointsModel::kMeasured), "1.0");
  show(0.5);
  EXPECT_EQ(cell(0, JointsModel::kMeasured), "–");
}

TEST_F(JointsModelTest, theHistoryIsOfTheLastSecondsBeforeTheInstant) {
  for (int i = 0; i <= 10; ++i) measure(i, {{"pan", 1.0 * i}});
  show(8);
  const auto& history = model.row(0).history;
  ASSERT_EQ(history.size(), 5U);
  EXPECT_DOUBLE_EQ(history.front(), radians(4));
  EXPECT_DOUBLE_EQ(history.back(), radians(8));
  EXPECT_TRUE(model.row(1).history.empty());
}

TEST_F(JointsModelTest, aHistoryHasABoundedNumberOfAnglesAndTheNewest) {
  for (const int count : {99, 100, 101, 150, 199, 200, 1000}) {
    stored.store.clear();
    for (int i = 1; i <= count; ++i) measure(4.0 * i / count, {{"pan", 1.0 * i}});
    show(4);
    const auto& history = model.row(0).history;
    EXPECT_LE(history.size(), JointsModel::kHistoryPoints) << count;
    EXPECT_GE(history.size(), JointsModel::kHistoryPoints / 2) << count;
    EXPECT_DOUBLE_EQ(history.back(), radians(count)) << count;
  }
}

TEST_F(JointsModelTest, anglesThatAreNoNumbersAreNotPartOfTheHistory) {
  measure(1, {{"pan", 1}});
  measure(2, {{"pan", kNothing}});
  measure(3, {{"pan", 3}});
  show(3);
  EXPECT_EQ(model.row(0).history.size(), 2U);
}

TEST_F(JointsModelTest, speedAndLoadAreShownIfTheRobotMeasuresThem) {
  foxglove::JointStates states;
  auto& pan = *states.add_joints();
  pan.set_name("pan");
  pan.set_velocity(radians(-12.34));
  pan.set_effort(-0.0);
  stored.add("red1/joints/states", 1, states);
  show();
  EXPECT_EQ(cell(0, JointsModel::kMeasured), "–") << "it does not say the angle";
  EXPECT_EQ(cell(0, JointsModel::kSpeed), "-12.3");
  EXPECT_EQ(cell(0, JointsModel::kLoad), "0.000");
  EXPECT_EQ(tip(0, JointsModel::kSpeed), "At most 180°/s");
  EXPECT_EQ(tip(0, JointsModel::kLoad), "");
  EXPECT_EQ(tip(1, JointsModel::kLoad), "The robot does not measure the torque of its joints");
}

TEST_F(JointsModelTest, whatTheUserCommandsIsPartOfTheRow) {
  show(1, {{"mouth", 0.5}, {"tail", 1}});
  EXPECT_FALSE(model.row(0).commanded);
  EXPECT_EQ(model.row(1).commanded, 0.5);
}

TEST_F(JointsModelTest, requestedAnglesAreEditedWhileThatIsPossible) {
  show();
  const QModelIndex pan = model.index(0, JointsModel::kRequested);
  QSignalSpy wanted(&model, &JointsModel::angleWanted);
  EXPECT_FALSE(model.flags(pan).testFlag(Qt::ItemIsEditable));
  EXPECT_FALSE(model.setData(pan, 10));
  model.setEditable(true);
  EXPECT_TRUE(model.flags(pan).testFlag(Qt::ItemIsEditable));
  EXPECT_FALSE(model.flags(model.index(0, JointsModel::kMeasured)).testFlag(Qt::ItemIsEditable));
  EXPECT_TRUE(model.setData(pan, QStringLiteral(" 12.5 ")));
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted[0][0].toString(), QStringLiteral("pan"));
  EXPECT_DOUBLE_EQ(wanted[0][1].toDouble(), radians(12.5));
  EXPECT_EQ(cell(0, JointsModel::kRequested), "–") << "the robot decides";
}

TEST_F(JointsModelTest, whatIsTypedStaysWithinTheLimits) {
  show();
  model.setEditable(true);
  QSignalSpy wanted(&model, &JointsModel::angleWanted);
  EXPECT_TRUE(model.setData(model.index(1, JointsModel::kRequested), 30));
  EXPECT_DOUBLE_EQ(wanted.takeFirst()[1].toDouble(), 0);
  EXPECT_TRUE(model.setData(model.index(1, JointsModel::kRequested), -1e9));
  EXPECT_DOUBLE_EQ(wanted.takeFirst()[1].toDouble(), radians(-45));
  for (const char* typed : {"", "ten", "nan", "inf", "1 2", "10°"})
    EXPECT_FALSE(model.setData(model.index(0, JointsModel::kRequested), QString::fromUtf8(typed))) << typed;
  EXPECT_EQ(wanted.count(), 0);
}

TEST_F(JointsModelTest, jointsOfAnotherProgramHaveNoLimits) {
  measure(1, {{"elbow", 200}, {"wrist", -5}}, "arm/states");
  model.showStream(stored.store, "arm/states", atSeconds(1));
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(cell(0, JointsModel::kName), "elbow");
  EXPECT_EQ(cell(0, JointsModel::kMeasured), "200.0");
  EXPECT_EQ(cell(0, JointsModel::kLimits), "–");
  EXPECT_EQ(tip(0, JointsModel::kSpeed), "");
  model.showStream(stored.store, "arm/other", atSeconds(1));
  EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(JointsModelTest, aMessageWithTooManyJointsIsCut) {
  std::vector<std::pair<const char*, double>> many(1500, {"joint", 1});
  measure(1, many, "arm/states");
  model.showStream(stored.store, "arm/states", atSeconds(1));
  EXPECT_EQ(model.rowCount(), 1000);
}

TEST_F(JointsModelTest, newAnglesKeepTheSelectionAndOtherJointsDoNot) {
  show();
  QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
  measure(1, {{"pan", 1}});
  show();
  EXPECT_EQ(resets.count(), 0);
  robot.joints[0].maximum = radians(80);
  show();
  EXPECT_EQ(resets.count(), 1);
  model.show(nullptr, "red1", stored.store, atSeconds(1), {});
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace widgets::test
