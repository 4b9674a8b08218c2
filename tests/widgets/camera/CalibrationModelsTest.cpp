// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QJsonObject>
#include <algorithm>
#include <set>

#include "robotlink/config/FieldDescription.h"
#include "widgets/camera/BoardViews.h"
#include "widgets/camera/FieldMarks.h"
#include "widgets/camera/MarkModel.h"

namespace widgets::test {
namespace {

/// As resources/fields/2002.yaml has it.
robotlink::FieldDescription fieldOf2002() {
  robotlink::FieldDescription field;
  field.length = 4.2;
  field.width = 2.7;
  field.centerCircleDiameter = 0.3;
  field.penaltyAreaLength = 0.5;
  field.penaltyAreaWidth = 1;
  field.goalWidth = 0.6;
  field.goals = {{"yellow", -2.1, "yellow"}, {"skyblue", 2.1, "skyblue"}};
  for (const double x : {-2.2, 0.0, 2.2})
    for (const double y : {-1.45, 1.45}) field.beacons.push_back({"beacon", {x, y}, "pink", "yellow"});
  return field;
}

TEST(FieldMarksTest, theFieldOf2002HasItsLinesPostsAndBeacons) {
  const auto marks = fieldMarks(fieldOf2002());
  const auto count = [&](const QString& kind) {
    return std::ranges::count_if(marks, [&](const FieldMark& mark) { return mark.kind == kind; });
  };
  EXPECT_EQ(count(QStringLiteral("wall corner")), 4);
  EXPECT_EQ(count(QStringLiteral("halfway line")), 2);
  EXPECT_EQ(count(QStringLiteral("center circle")), 2);
  EXPECT_EQ(count(QStringLiteral("penalty corner")), 4);
  EXPECT_EQ(count(QStringLiteral("penalty at goal")), 4);
  EXPECT_EQ(count(QStringLiteral("goal post")), 4);
  EXPECT_EQ(count(QStringLiteral("beacon")), 6);
  std::set<QString> names;
  for (const FieldMark& mark : marks) names.insert(mark.name());
  EXPECT_EQ(names.size(), marks.size()) << "each name is one mark's";
  EXPECT_TRUE(names.contains(QStringLiteral("goal post (-2.10, 0.30)")));
  EXPECT_TRUE(names.contains(QStringLiteral("halfway line (0.00, -1.35)")));
}

TEST(FieldMarksTest, aFieldWithBoundaryLinesHasTheirCorners) {
  robotlink::FieldDescription field;
  field.length = 6;
  field.width = 4;
  field.boundaryLength = 5;
  field.boundaryWidth = 3;
  const auto marks = fieldMarks(field);
  ASSERT_EQ(marks.size(), 6U);
  EXPECT_EQ(marks[0].name(), QStringLiteral("field corner (-2.50, 1.50)"));
}

std::vector<robotlink::Vector2> shifted(double by) {
  std::vector<robotlink::Vector2> corners;
  for (int i = 0; i < 54; ++i) corners.emplace_back(i + by, i);
  return corners;
}

TEST(BoardViewsTest, onlyAViewElsewhereIsNew) {
  BoardViews views;
  EXPECT_TRUE(views.isNew(shifted(0)));
  views.add(shifted(0), {}, 320, 240);
  EXPECT_FALSE(views.isNew(shifted(15)));
  EXPECT_TRUE(views.isNew(shifted(17)));
}

TEST(BoardViewsTest, anotherBoardOrSizeBeginsAnew) {
  BoardViews views;
  views.add(shifted(0), {}, 320, 240);
  views.add(shifted(50), {}, 320, 240);
  EXPECT_EQ(views.views().size(), 2U);
  views.add(shifted(0), {8, 6, 0.02}, 320, 240);
  EXPECT_EQ(views.views().size(), 1U);
  EXPECT_EQ(views.board().columns, 8);
  views.add(shifted(0), {8, 6, 0.02}, 640, 480);
  EXPECT_EQ(views.views().size(), 1U);
  EXPECT_EQ(views.width(), 640);
  views.remove(7);
  EXPECT_EQ(views.views().size(), 1U);
  views.remove(0);
  EXPECT_TRUE(views.views().empty());
}

class MarkModelTest : public testing::Test {
 protected:
  MarkModelTest() { model_.setMarks(fieldMarks(fieldOf2002())); }
  QString text(int row, int column) const { return model_.index(row, column).data().toString(); }

  MarkModel model_;
  const QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(MarkModelTest, whatIsClickedIsShownWithItsError) {
  model_.pick(1, QPointF(12.34, 5));
  model_.pick(3, QPointF(1, 2));
  EXPECT_EQ(text(1, MarkModel::kPixel), QStringLiteral("12, 5"));
  EXPECT_EQ(text(1, MarkModel::kKind), QStringLiteral("wall corner"));
  EXPECT_EQ(text(1, MarkModel::kPlace), QStringLiteral("-2.10, -1.35"));
  EXPECT_EQ(text(0, MarkModel::kPixel), QString());
  model_.setErrors({0.5, 1.25});
  EXPECT_EQ(text(1, MarkModel::kError), QStringLiteral("0.50"));
  EXPECT_EQ(text(3, MarkModel::kError), QStringLiteral("1.25"));
  // A further mark makes them obsolete, and errors of another number are of other marks.
  model_.pick(4, QPointF(1, 1));
  EXPECT_EQ(text(1, MarkModel::kError), QString());
  model_.setErrors({1, 2});
  EXPECT_EQ(text(1, MarkModel::kError), QString());
  model_.pick(-1, QPointF());
  model_.pick(1000, QPointF());
  model_.clear();
  EXPECT_EQ(text(1, MarkModel::kPixel), QString());
}

TEST_F(MarkModelTest, theNextMarkIsOneWithoutAPixel) {
  EXPECT_EQ(model_.nextFree(0), 1);
  model_.pick(1, QPointF(1, 1));
  EXPECT_EQ(model_.nextFree(0), 2);
  EXPECT_EQ(model_.nextFree(model_.rowCount() - 1), 0);
  for (int row = 0; row < model_.rowCount(); ++row) model_.pick(row, QPointF(1, 1));
  EXPECT_EQ(model_.nextFree(0), -1);
}

TEST_F(MarkModelTest, whatWasClickedIsKept) {
  model_.pick(2, QPointF(3, 4));
  const QJsonObject state = model_.save();
  MarkModel other;
  other.setMarks(fieldMarks(fieldOf2002()));
  other.restore(state);
  EXPECT_EQ(other.marks()[2].pixel, QPointF(3, 4));
  other.restore({{other.marks()[1].mark.name(), QStringLiteral("nonsense")}});
  EXPECT_FALSE(other.marks()[1].pixel);
  EXPECT_FALSE(other.marks()[2].pixel);
}

}  // namespace
}  // namespace widgets::test
