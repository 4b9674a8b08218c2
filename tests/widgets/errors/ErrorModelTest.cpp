// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/errors/ErrorModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/errors/ErrorFormula.h"
#include "widgets/plots/PlotSource.h"

namespace widgets {
namespace {

constexpr double kAngle = 2.5;

class ErrorModelTest : public testing::Test {
 protected:
  /// Publishes at a second, to what compares and to a session.
  template <typename T>
  void push(const std::string& path, int second, T message) {
    const robotlink::Instant time{std::chrono::seconds(second)};
    robotlink::assign(*message.mutable_timestamp(), time);
    const auto value = std::make_shared<const T>(std::move(message));
    errors.add("red1", path, time, value);
    session.push({"red1/" + path, time, value});
    session.tick();
  }
  /// The robot stands at (1, -0.5), turned by kAngle; the ball lies at (0.2, 0.4).
  void pushTruth(int second) {
    robotcontrol::OracleWorld truth;
    robotlink::assign(*truth.mutable_robot_in_field(), robotlink::Pose2{1, -0.5, kAngle});
    robotlink::assign(*truth.mutable_ball_in_field(), robotlink::Vector3(0.2, 0.4, 0.04));
    push("oracle/world", second, truth);
  }
  void pushBallModel(const std::string& path, int second, bool known, double x, double y) {
    robotcontrol::BallModel ball;
    ball.set_known(known);
    robotlink::assign(*ball.mutable_position_in_robot(), robotlink::Vector2(x, y));
    push(path, second, ball);
  }
  /// Shows the figures.
  void show() { model.setErrors(errors.errors().at("red1")); }
  std::string text(int row, ErrorModel::Column column) const {
    return model.index(row, column).data().toString().toStdString();
  }
  int rowOf(const char* path, const char* quantity) const {
    for (int row = 0; row < model.rowCount(); ++row)
      if (model.row(row).source.path == path && model.row(row).quantity == quantity) return row;
    return -1;
  }

  robotlink::TruthErrors errors;
  robotlink::Session session;
  ErrorModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(ErrorModelTest, aRowHasTheFiguresOfAnErrorInTheUnitsOfUsers) {
  for (int second = 1; second <= 4; ++second) {
    robotcontrol::RobotPose pose;
    robotlink::assign(*pose.mutable_robot_in_field(), robotlink::Pose2{1 + 0.1 * second, -0.5, kAngle - 0.1});
    push("models/pose", second, pose);
    pushTruth(second);
  }
  show();
  ASSERT_EQ(model.rowCount(), 2);
  const int position = rowOf("models/pose", "position"), heading = rowOf("models/pose", "heading");
  EXPECT_EQ(text(position, ErrorModel::kUnit), "mm");
  EXPECT_EQ(text(position, ErrorModel::kSamples), "4");
  EXPECT_EQ(text(position, ErrorModel::kLast), "400.0");
  EXPECT_EQ(text(position, ErrorModel::kMean), "250.0");
  EXPECT_EQ(text(position, ErrorModel::kMedian), "200.0");
  EXPECT_EQ(text(position, ErrorModel::kNinetyFive), "400.0");
  EXPECT_EQ(text(heading, ErrorModel::kUnit), "°");
  EXPECT_EQ(text(heading, ErrorModel::kMean), "5.7");
  EXPECT_EQ(text(position, ErrorModel::kMissed), "") << "a pose cannot be missed";
  EXPECT_EQ(model.index(position, ErrorModel::kMean).data(ErrorModel::kNumberRole).toInt(), 250);
}

TEST_F(ErrorModelTest, aShadowIsNamedBesideTheSolutionThatRuns) {
  robotcontrol::SolutionTable table;
  auto& task = *table.add_tasks();
  task.set_active("kalman");
  auto& solution = *task.add_solutions();
  solution.set_name("kalman");
  solution.add_outputs("models/ball");
  errors.add("red1", "tables/solutions", {}, std::make_shared<robotcontrol::SolutionTable>(table));
  pushBallModel("models/ball", 1, true, 1.2, 0);
  pushBallModel("shadow/particles/models/ball", 1, true, 1, 0);
  pushTruth(1);
  show();
  const int active = rowOf("models/ball", "position");
  const int shadow = rowOf("shadow/particles/models/ball", "position");
  EXPECT_EQ(text(active, ErrorModel::kStream), "models/ball");
  EXPECT_EQ(text(active, ErrorModel::kSolution), "kalman");
  EXPECT_EQ(text(shadow, ErrorModel::kStream), "models/ball");
  EXPECT_EQ(text(shadow, ErrorModel::kSolution), "particles (shadow)");
}

TEST_F(ErrorModelTest, whatIsNeverKnownHasARowThatSaysSo) {
  pushBallModel("models/ball", 1, false, 0, 0);
  pushTruth(1);
  show();
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(text(0, ErrorModel::kError), "");
  EXPECT_EQ(text(0, ErrorModel::kMean), "");
  EXPECT_EQ(text(0, ErrorModel::kMissed), "100.0");
  EXPECT_EQ(text(0, ErrorModel::kFalse), "");
  EXPECT_EQ(text(0, ErrorModel::kLatency), "0.0");
}

TEST_F(ErrorModelTest, whatHappensToTheBodyHasSharesOfTimeAndDelays) {
  for (int second = 1; second <= 4; ++second) {
    robotcontrol::RobotState state, truth;
    truth.set_fallen(true);
    state.set_fallen(second > 1);
    push("percepts/robot-state", second, state);
    push("oracle/state", second, truth);
  }
  show();
  const int fallen = rowOf("percepts/robot-state", "fallen");
  const int delay = rowOf("percepts/robot-state", "fallen delay");
  EXPECT_EQ(text(fallen, ErrorModel::kUnit), "% of the time");
  EXPECT_EQ(text(fallen, ErrorModel::kMean), "25.0");
  EXPECT_EQ(text(fallen, ErrorModel::kMedian), "") << "a share has only a mean";
  EXPECT_EQ(text(fallen, ErrorModel::kMissed), "0.0");
  EXPECT_EQ(text(rowOf("percepts/robot-state", "picked up"), ErrorModel::kMissed), "") << "nobody lifted it";
  EXPECT_EQ(text(delay, ErrorModel::kUnit), "ms");
  EXPECT_EQ(text(delay, ErrorModel::kMean), "1000.0");
}

TEST_F(ErrorModelTest, theFormulaOfAnErrorComputesWhatTheTableHas) {
  pushTruth(1);
  robotcontrol::RobotPose pose;
  robotlink::assign(*pose.mutable_robot_in_field(), robotlink::Pose2{1.3, -0.1, kAngle - 0.2});
  push("models/pose", 1, pose);
  pushBallModel("models/ball", 1, true, 1.1, 0.3);
  pushBallModel("shadow/particles/models/ball", 1, true, 1, -0.2);
  robotcontrol::BallPercept percept;
  percept.set_seen(true);
  robotlink::assign(*percept.mutable_position_in_robot(), robotlink::Vector2(1.1, 0.1));
  push("percepts/ball", 1, percept);
  robotcontrol::TeamBall team;
  team.set_known(true);
  robotlink::assign(*team.mutable_position_in_field(), robotlink::Vector2(0.5, 0.8));
  push("models/team-ball", 1, team);
  pushTruth(2);
  show();
  int formulas = 0;
  for (int i = 0; i < model.rowCount(); ++i) {
    const ErrorRow& row = model.row(i);
    const std::string formula = errorFormula("red1", row.source.path, row.package, row.quantity);
    if (formula.empty()) continue;
    ++formulas;
    PlotReader reader(PlotSource::fromText(QString::fromStdString(formula)));
    EXPECT_FALSE(reader.source().expression.empty());
    reader.take(session.store());
    ASSERT_TRUE(reader.last()) << formula << reader.problem(session.store()).toStdString();
    EXPECT_NEAR(*reader.last(), row.last, 1e-6) << formula;
  }
  EXPECT_EQ(formulas, 6);
  EXPECT_EQ(errorFormula("red1", "models/ball", "models/ball", "relative"), "");
  EXPECT_EQ(errorFormula("red1", "models/players", "models/players", "position"), "");
}

}  // namespace
}  // namespace widgets
