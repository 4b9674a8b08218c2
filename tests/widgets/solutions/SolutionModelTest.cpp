// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/SolutionModel.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

using Choice = SolutionModel::Choice;

std::vector<TaskEntry> tasksWith(const std::string& active, const std::string& standard = {}) {
  TaskEntry ball;
  ball.name = "ball-percept";
  ball.process = "cognition";
  ball.active = active;
  ball.standard = standard;
  ball.solutions = {{"lines", QStringLiteral("Fits a circle"), {}, true},
                    {"regions", QStringLiteral("Takes a region"), {}, false},
                    {"oracle", QStringLiteral("Looks it up"), QStringLiteral("no ground truth"), false}};
  TaskEntry walk;
  walk.name = "walk";
  return {ball, walk};
}

class SolutionModelTest : public testing::Test {
 protected:
  SolutionModelTest() {
    QObject::connect(&model, &QAbstractItemModel::modelReset, &model, [this] { ++resets; });
    model.setTasks(tasksWith("lines"));
  }
  QModelIndex solution(int row) const { return model.index(row, 0, model.index(0, 0)); }
  Choice choice(int row) const {
    return static_cast<Choice>(model.data(solution(row), SolutionModel::kChoiceRole).toInt());
  }
  std::string state(const QModelIndex& index) const {
    return model.data(index.siblingAtColumn(SolutionModel::kState), Qt::DisplayRole).toString().toStdString();
  }

  SolutionModel model;
  int resets = 0;
};

TEST_F(SolutionModelTest, solutionsAreBelowTheirTask) {
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_EQ(model.rowCount(model.index(0, 0)), 3);
  EXPECT_EQ(model.rowCount(model.index(1, 0)), 0);
  EXPECT_EQ(model.parent(solution(2)), model.index(0, 0));
  EXPECT_EQ(model.data(solution(1), SolutionModel::kTaskRole).toString().toStdString(), "ball-percept");
  EXPECT_TRUE(model.data(solution(0), SolutionModel::kParametersRole).toBool());
  EXPECT_EQ(state(model.index(0, 0)), "lines");
  EXPECT_EQ(state(model.index(1, 0)), "nothing");
  EXPECT_EQ(choice(0), Choice::kActive);
  EXPECT_EQ(choice(1), Choice::kFree);
  EXPECT_EQ(choice(2), Choice::kUnavailable);
  EXPECT_EQ(state(solution(2)), "no ground truth");
}

TEST_F(SolutionModelTest, theTipSaysWhatASolutionReadsAndPublishes) {
  const auto tip = [this](const QModelIndex& index) {
    return model.data(index, Qt::ToolTipRole).toString().toStdString();
  };
  EXPECT_EQ(tip(solution(0)), "Fits a circle") << "the robot does not say";
  auto tasks = tasksWith("lines");
  tasks[0].help = QStringLiteral("Finds the ball");
  auto& lines = tasks[0].solutions[0];
  lines.required << QStringLiteral("camera/image") << QStringLiteral("camera/pose");
  lines.optional << QStringLiteral("colors/table");
  lines.outputs << QStringLiteral("percepts/ball");
  tasks[0].solutions[2].outputs = lines.outputs;
  model.setTasks(tasks);
  const std::string packages =
      "reads camera/image, camera/pose\nreads if offered colors/table\npublishes percepts/ball";
  EXPECT_EQ(tip(solution(0)), "Fits a circle\n\n" + packages);
  EXPECT_EQ(tip(model.index(0, 0)), "Finds the ball\n\n" + packages) << "those of the one that runs";
  EXPECT_EQ(tip(solution(2)), "Looks it up\nno ground truth\n\npublishes percepts/ball");
}

TEST_F(SolutionModelTest, aRequestIsPendingUntilATableConfirmsIt) {
  model.setPending("ball-percept", "regions");
  EXPECT_EQ(choice(1), Choice::kPending);
  EXPECT_EQ(choice(0), Choice::kActive);
  EXPECT_EQ(state(model.index(0, 0)), "lines → regions…");
  model.setTasks(tasksWith("lines"));
  EXPECT_EQ(choice(1), Choice::kPending) << "this table was published before";
  model.setTasks(tasksWith("regions"));
  EXPECT_EQ(choice(1), Choice::kActive);
  EXPECT_EQ(state(model.index(0, 0)), "regions");
  EXPECT_EQ(resets, 1) << "rows stay where the names are the same";
}

TEST_F(SolutionModelTest, aRefusalIsShownUntilTheNextRequest) {
  model.setPending("ball-percept", "regions");
  model.refuse("ball-percept", "regions", QStringLiteral("it is busy"));
  EXPECT_EQ(choice(1), Choice::kFree);
  EXPECT_EQ(state(solution(1)), "refused: it is busy");
  EXPECT_EQ(state(solution(0)), "Fits a circle");
  EXPECT_EQ(model.data(solution(1), Qt::ToolTipRole).toString().toStdString(),
            "Takes a region\nrefused: it is busy");
  model.setPending("ball-percept", "oracle");
  EXPECT_EQ(state(solution(1)), "Takes a region");
}

TEST_F(SolutionModelTest, theDefaultIsThatOfTheLayoutOrElseWhatRanFirst) {
  model.setTasks(tasksWith("regions"));
  EXPECT_EQ(model.standardOf(model.tasks()[0]), "lines");
  model.setTasks(tasksWith("regions", "oracle"));
  EXPECT_EQ(model.standardOf(model.tasks()[0]), "oracle");
}

TEST_F(SolutionModelTest, otherSolutionsResetTheTree) {
  auto tasks = tasksWith("lines");
  tasks[0].solutions.pop_back();
  model.setTasks(tasks);
  EXPECT_EQ(resets, 2);
  EXPECT_EQ(model.rowCount(model.index(0, 0)), 2);
}

}  // namespace
}  // namespace widgets
