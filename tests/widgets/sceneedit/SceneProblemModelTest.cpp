// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneProblemModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "widgets/Theme.h"

namespace widgets::test {
namespace {

class SceneProblemModelTest : public testing::Test {
 protected:
  QVariant cell(int row, int column, int role = Qt::DisplayRole) const {
    return model.data(model.index(row, column), role);
  }

  const QPalette palette{Qt::white};
  SceneProblemModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(SceneProblemModelTest, aProblemHasItsLineAndTheNameOfTheFileThatItIsIn) {
  model.show({{false, "no such joint", "/scenes/models/p3at/model.sdf", 12}, {true, "no ground", {}, 0}},
             palette);
  EXPECT_EQ(cell(0, SceneProblemModel::kLine), 12);
  EXPECT_EQ(cell(0, SceneProblemModel::kText).toString(), QStringLiteral("model.sdf: no such joint"));
  EXPECT_FALSE(cell(1, SceneProblemModel::kLine).isValid()) << "it is about the whole file";
  EXPECT_EQ(cell(1, SceneProblemModel::kText).toString(), QStringLiteral("no ground"));
}

TEST_F(SceneProblemModelTest, errorsAndWarningsAreToldApartByColorAndByWords) {
  model.show({{false, "a", {}, 1}, {true, "b", {}, 2}}, palette);
  EXPECT_EQ(cell(0, SceneProblemModel::kText, Qt::ForegroundRole), colorOf(Meaning::kBad, palette));
  EXPECT_EQ(cell(1, SceneProblemModel::kText, Qt::ForegroundRole), colorOf(Meaning::kWarning, palette));
  EXPECT_EQ(cell(0, SceneProblemModel::kText, Qt::ToolTipRole).toString(), QStringLiteral("Error: a"));
  EXPECT_EQ(cell(1, SceneProblemModel::kLine, Qt::ToolTipRole).toString(), QStringLiteral("Warning: b"));
}

TEST_F(SceneProblemModelTest, theSameProblemsKeepTheirSelection) {
  QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
  model.show({{false, "a", {}, 3}}, palette);
  EXPECT_EQ(resets.count(), 1);
  model.show({{false, "a", {}, 3}}, palette);
  EXPECT_EQ(resets.count(), 1);
  model.show({{false, "a", {}, 4}}, palette);
  EXPECT_EQ(resets.count(), 2);
  model.show({}, palette);
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace widgets::test
