// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/KeyTreeModel.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

KeyEntry keyEntry(const char* name, KeyValue::Kind kind = KeyValue::Kind::kOff, unsigned n = 0) {
  KeyEntry entry;
  entry.name = name;
  entry.value = {kind, n};
  entry.inUse = true;
  return entry;
}

class KeyTreeModelTest : public testing::Test {
 protected:
  KeyTreeModelTest() {
    QObject::connect(&model, &QAbstractItemModel::modelReset, &model, [this] { ++resets; });
    QObject::connect(&model, &KeyTreeModel::keyChosen, &model,
                     [this](const QString& key, const KeyValue& value) {
                       requested.emplace_back(key.toStdString(), value);
                     });
    model.setKeys(
        {keyEntry("ball/circle"), keyEntry("ball/rays", KeyValue::Kind::kTimes, 3), keyEntry("log")});
  }
  std::string text(const QModelIndex& index, KeyTreeModel::Column column) const {
    return model.data(index.siblingAtColumn(column), Qt::DisplayRole).toString().toStdString();
  }
  QModelIndex ball() const { return model.index(0, 0); }
  QModelIndex circle() const { return model.index(0, 0, ball()); }
  QModelIndex rays() const { return model.index(1, 0, ball()); }

  KeyTreeModel model;
  int resets = 0;
  std::vector<std::pair<std::string, KeyValue>> requested;
};

TEST_F(KeyTreeModelTest, groupsKeysByThePartsOfTheirNames) {
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_EQ(text(ball(), KeyTreeModel::kName), "ball");
  EXPECT_EQ(model.rowCount(ball()), 2);
  EXPECT_EQ(text(rays(), KeyTreeModel::kName), "rays");
  EXPECT_EQ(model.parent(rays()), ball());
  EXPECT_FALSE(model.parent(ball()).isValid());
  EXPECT_EQ(model.keysBelow(ball()), (std::vector<std::string>{"ball/circle", "ball/rays"}));
  EXPECT_EQ(model.keysBelow({}).size(), 3U);
}

TEST_F(KeyTreeModelTest, aGroupSaysHowManyOfItsKeysAreOn) {
  EXPECT_EQ(text(ball(), KeyTreeModel::kMode), "1 of 2 on");
  EXPECT_TRUE(model.data(ball(), KeyTreeModel::kActiveRole).toBool());
  EXPECT_FALSE(model.data(circle(), KeyTreeModel::kActiveRole).toBool());
  EXPECT_EQ(text(rays(), KeyTreeModel::kNumber), "3 left");
}

TEST_F(KeyTreeModelTest, aChosenModeIsPendingUntilTheRobotsNextTable) {
  ASSERT_TRUE(model.setData(circle().siblingAtColumn(KeyTreeModel::kMode), int(KeyValue::Kind::kEveryNth),
                            Qt::EditRole));
  ASSERT_EQ(requested.size(), 1U);
  EXPECT_EQ(requested[0].first, "ball/circle");
  EXPECT_EQ(requested[0].second, (KeyValue{KeyValue::Kind::kEveryNth, 10}))
      << "a missing number has a useful default";
  EXPECT_EQ(text(circle(), KeyTreeModel::kMode), "every n-th");
  model.setKeys({keyEntry("ball/circle"), keyEntry("ball/rays"), keyEntry("log")});
  EXPECT_EQ(text(circle(), KeyTreeModel::kMode), "off") << "the robot knows better";
  EXPECT_EQ(resets, 1) << "rows stay where the names are the same";
}

TEST_F(KeyTreeModelTest, aRefusalGivesTheOldModeBackAndSaysWhy) {
  model.choose("ball/circle", {KeyValue::Kind::kAlways, 0});
  model.refuse("ball/circle", QStringLiteral("no <such> key"));
  EXPECT_EQ(text(circle(), KeyTreeModel::kMode), "off");
  const QString tip = model.data(circle(), Qt::ToolTipRole).toString();
  EXPECT_TRUE(tip.contains(QStringLiteral("Refused: no &lt;such&gt; key"))) << tip.toStdString();
  model.choose("ball/circle", {KeyValue::Kind::kAlways, 0});
  EXPECT_FALSE(model.data(circle(), Qt::ToolTipRole).toString().contains(QStringLiteral("Refused")));
}

TEST_F(KeyTreeModelTest, onlyWhatCanBeEditedIsEditable) {
  const auto editable = [this](const QModelIndex& index, KeyTreeModel::Column column) {
    return model.flags(index.siblingAtColumn(column)).testFlag(Qt::ItemIsEditable);
  };
  EXPECT_FALSE(editable(ball(), KeyTreeModel::kMode));
  EXPECT_FALSE(editable(circle(), KeyTreeModel::kName));
  EXPECT_TRUE(editable(circle(), KeyTreeModel::kMode));
  EXPECT_FALSE(editable(circle(), KeyTreeModel::kNumber)) << "off has no number";
  EXPECT_TRUE(editable(rays(), KeyTreeModel::kNumber));
  EXPECT_FALSE(model.setData(rays().siblingAtColumn(KeyTreeModel::kNumber), 0, Qt::EditRole));
  EXPECT_FALSE(
      model.setData(circle().siblingAtColumn(KeyTreeModel::kMode), int(KeyValue::Kind::kOff), Qt::EditRole));
  EXPECT_TRUE(requested.empty());
}

TEST_F(KeyTreeModelTest, otherKeysResetTheTree) {
  model.setKeys({keyEntry("log")});
  EXPECT_EQ(resets, 2);
  EXPECT_EQ(model.rowCount(), 1);
}

}  // namespace
}  // namespace widgets
