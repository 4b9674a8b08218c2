// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotTreeModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QMimeData>
#include <memory>

namespace widgets::test {
namespace {

constexpr char kBallType[] = "robotcontrol.BallModel";

PlotChoice fieldChoice(const char* stream, const std::string& field, const char* type = kBallType) {
  return {{stream, field, type}};
}

/// The elements [begin, end) of a list, as choices.
std::vector<PlotChoice> elementChoices(const char* stream, int begin, int end) {
  std::vector<PlotChoice> choices;
  for (int i = begin; i < end; ++i)
    choices.push_back(fieldChoice(stream, "data[" + std::to_string(i) + "]", ""));
  return choices;
}

class PlotTreeModelTest : public testing::Test {
 protected:
  /// The names of the rows below an index.
  std::vector<std::string> names(const QModelIndex& parent = {}) const {
    std::vector<std::string> all;
    for (int row = 0; row < model.rowCount(parent); ++row)
      all.push_back(model.index(row, PlotTreeModel::kName, parent).data().toString().toStdString());
    return all;
  }
  /// The index below the first rows, one for each number.
  QModelIndex at(std::initializer_list<int> rows) const {
    QModelIndex index;
    for (const int row : rows) index = model.index(row, 0, index);
    return index;
  }

  PlotTreeModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

using Names = std::vector<std::string>;

TEST_F(PlotTreeModelTest, streamsLieBelowThePartsOfTheirPaths) {
  model.setChoices({fieldChoice("red1/models/ball", "known"),
                    fieldChoice("red1/models/ball", "age"),
                    {{"red1/plots/x", {}, "robotcontrol.PlotValue"}},
                    {{"blue1/plots/x"}}});
  EXPECT_EQ(names(), (Names{"red1", "blue1"}));
  EXPECT_EQ(names(at({0})), (Names{"models", "plots"}));
  EXPECT_EQ(names(at({0, 0, 0})), (Names{"known", "age"}));
  EXPECT_EQ(at({0, 0}).data(PlotTreeModel::kPathRole).toString(), QStringLiteral("red1/models"));
  EXPECT_EQ(at({0, 0, 0, 1}).data(PlotTreeModel::kSourceRole).toString(),
            QStringLiteral("red1/models/ball: age"));
}

TEST_F(PlotTreeModelTest, onlyWhatCanBePlottedIsDraggedAndHasASource) {
  PlotChoice unknown{{"red1/other"}, QStringLiteral("Play it first."), false};
  model.setChoices({fieldChoice("red1/models/ball", "known"), unknown, {{"red1/plots/x"}}});
  const auto isDragged = [&](const QModelIndex& index) {
    return model.flags(index).testFlag(Qt::ItemIsDragEnabled);
  };
  EXPECT_FALSE(isDragged(at({0})));
  EXPECT_FALSE(isDragged(at({0, 0, 0}))) << "the stream has fields";
  EXPECT_TRUE(isDragged(at({0, 0, 0, 0})));
  EXPECT_FALSE(isDragged(at({0, 1})));
  EXPECT_TRUE(at({0, 1}).data(PlotTreeModel::kSourceRole).toString().isEmpty());
  EXPECT_TRUE(isDragged(at({0, 2, 0}))) << "a stream of plot values is a leaf";
}

TEST_F(PlotTreeModelTest, whatIsNotPublishedIsGrayAndSaysWhy) {
  PlotChoice off = fieldChoice("red1/models/ball", "known");
  off.missing = QStringLiteral("Its debug key is off.");
  model.setChoices({off, fieldChoice("red1/models/pose", "age")});
  EXPECT_EQ(at({0, 0, 0, 0}).data(Qt::ToolTipRole).toString(),
            QStringLiteral("red1/models/ball: known\nIts debug key is off."));
  EXPECT_TRUE(at({0, 0, 0, 0}).data(Qt::ForegroundRole).isValid());
  EXPECT_FALSE(at({0, 0, 1, 0}).data(Qt::ForegroundRole).isValid());
}

TEST_F(PlotTreeModelTest, unitsStandBesideTheFields) {
  model.setChoices(
      {fieldChoice("red1/models/ball", "known"), fieldChoice("red1/models/ball", "velocity_in_robot.x")});
  const QModelIndex stream = at({0, 0, 0});
  EXPECT_EQ(model.index(0, PlotTreeModel::kUnit, stream).data().toString(), QString());
  EXPECT_EQ(model.index(1, PlotTreeModel::kUnit, stream).data().toString(), QStringLiteral("m/s"));
}

TEST_F(PlotTreeModelTest, namesAreExplained) {
  model.setChoices(elementChoices("red1/requests", 0, 2), [](const PlotSource& source) {
    return source.field == "data[1]" ? QStringLiteral("head") : QString();
  });
  EXPECT_EQ(names(at({0, 0})), (Names{"data[0]", "data[1] head"}));
}

TEST_F(PlotTreeModelTest, aLongListHasARowOfItsOwn) {
  constexpr int kMax = PlotTreeModel::kMaxElements;
  auto choices = elementChoices("red1/short", 0, kMax);
  for (PlotChoice& each : elementChoices("red1/tall", 0, kMax + 1)) choices.push_back(each);
  choices.push_back(fieldChoice("red1/tall", "mean", ""));
  model.setChoices(choices);
  EXPECT_EQ(model.rowCount(at({0, 0})), kMax);
  EXPECT_EQ(names(at({0, 1})), (Names{"data[0 … 32]", "mean"}));
  EXPECT_EQ(at({0, 1, 0}).data(PlotTreeModel::kPathRole).toString(), QStringLiteral("red1/tall.data"));
  EXPECT_EQ(model.rowCount(at({0, 1, 0})), kMax + 1);
  EXPECT_FALSE(model.flags(at({0, 1, 0})).testFlag(Qt::ItemIsDragEnabled));
}

TEST_F(PlotTreeModelTest, aListIsLongByItsElementsNotByTheirFields) {
  std::vector<PlotChoice> choices;
  for (int i = 0; i < 20; ++i) {
    const std::string element = "joints[" + std::to_string(i) + "].";
    choices.push_back(fieldChoice("red1/joints", element + "position", ""));
    choices.push_back(fieldChoice("red1/joints", element + "velocity", ""));
  }
  model.setChoices(choices);
  EXPECT_EQ(model.rowCount(at({0, 0})), 40);
}

TEST_F(PlotTreeModelTest, elementsWithNamesAreNoLongList) {
  std::vector<PlotChoice> choices;
  for (int i = 0; i < 2 * PlotTreeModel::kMaxElements; ++i)
    choices.push_back(fieldChoice("red1/joints", "joints[name=\"j" + std::to_string(i) + "\"].position", ""));
  choices.push_back(fieldChoice("red1/joints", "joints]0[", ""));
  model.setChoices(choices);
  EXPECT_EQ(model.rowCount(at({0, 0})), static_cast<int>(choices.size()));
}

TEST_F(PlotTreeModelTest, draggedSourcesAreLinesOfText) {
  model.setChoices({fieldChoice("red1/models/ball", "known"), fieldChoice("red1/models/ball", "age")});
  const std::unique_ptr<QMimeData> data(model.mimeData({at({0}), at({0, 0, 0, 0}), at({0, 0, 0, 1})}));
  EXPECT_EQ(data->text(), QStringLiteral("red1/models/ball: known\nred1/models/ball: age"));
  EXPECT_EQ(QString::fromUtf8(data->data(QString::fromLatin1(PlotTreeModel::kMimeType))), data->text());
  EXPECT_EQ(model.mimeTypes(), QStringList(QString::fromLatin1(PlotTreeModel::kMimeType)));
}

TEST_F(PlotTreeModelTest, otherChoicesReplaceTheTree) {
  model.setChoices({fieldChoice("red1/models/ball", "known")});
  model.setChoices({});
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.columnCount(), static_cast<int>(PlotTreeModel::kColumns));
}

}  // namespace
}  // namespace widgets::test
