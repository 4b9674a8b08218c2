// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/StrokeModel.h"

#include <gtest/gtest.h>

#include "colortool/image/ClassPresets.h"

namespace widgets {
namespace {

class StrokeModelTest : public testing::Test {
 protected:
  StrokeModelTest() {
    samples.classes = colortool::findClassPreset("2002")->classes();
    samples.images.push_back({});
    samples.images.back().id = 7;
    samples.images.back().camera = "red1";
    for (const std::uint64_t id : {1, 2, 3}) add(id);
    const auto count = [this](const char* what) { events += what; };
    QObject::connect(&model, &QAbstractItemModel::modelReset, &model, [count] { count("reset "); });
    QObject::connect(&model, &QAbstractItemModel::rowsInserted, &model, [count] { count("insert "); });
    QObject::connect(&model, &QAbstractItemModel::rowsRemoved, &model, [count] { count("remove "); });
    model.setSamples(samples);
    events.clear();
  }
  void add(std::uint64_t id) {
    auto stroke = std::make_shared<colortool::Stroke>();
    stroke->id = id;
    stroke->image = 7;
    stroke->colorClass = 1;
    stroke->tool = "brush";
    stroke->colors.resize(10 * id);
    samples.strokes.push_back(std::move(stroke));
  }
  QVariant at(int row, StrokeModel::Column column, int role = Qt::DisplayRole) const {
    return model.data(model.index(row, column), role);
  }

  colortool::Samples samples;
  StrokeModel model;
  std::string events;
};

TEST_F(StrokeModelTest, strokesAtTheEndComeAndGoWithoutAReset) {
  add(4);
  add(5);
  model.setSamples(samples);
  EXPECT_EQ(events, "insert ");
  EXPECT_EQ(model.rowCount(), 5);
  samples.strokes.pop_back();
  model.setSamples(samples);
  EXPECT_EQ(events, "insert remove ");
  samples.strokes.erase(samples.strokes.begin());
  model.setSamples(samples);
  EXPECT_EQ(events, "insert remove reset ");
  EXPECT_EQ(model.stroke(0).id, 2U);
}

TEST_F(StrokeModelTest, showsWhatAStrokeIs) {
  EXPECT_EQ(at(1, StrokeModel::kClass).toString().toStdString(), samples.classes.name(1));
  EXPECT_EQ(at(1, StrokeModel::kCamera).toString().toStdString(), "red1");
  EXPECT_EQ(at(1, StrokeModel::kMustNotBe, Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
  EXPECT_LT(at(0, StrokeModel::kPixels, StrokeModel::kSortRole).toInt(),
            at(1, StrokeModel::kPixels, StrokeModel::kSortRole).toInt());
}

TEST_F(StrokeModelTest, theShareOfARightStrokeIsUnknownAtFirst) {
  EXPECT_FALSE(at(1, StrokeModel::kRight, StrokeModel::kShareRole).isValid());
  model.setRight({{2, 0.75}});
  EXPECT_DOUBLE_EQ(at(1, StrokeModel::kRight, StrokeModel::kShareRole).toDouble(), 0.75);
  EXPECT_FALSE(at(0, StrokeModel::kRight, StrokeModel::kShareRole).isValid());
}

TEST_F(StrokeModelTest, editsAreSignalsAndOnlyWhereSomethingDiffers) {
  std::string wanted;
  QObject::connect(&model, &StrokeModel::weightWanted, &model, [&wanted](std::uint64_t id, double weight) {
    wanted += "weight " + std::to_string(id) + " " + std::to_string(int(weight)) + ";";
  });
  QObject::connect(&model, &StrokeModel::mustNotBeWanted, &model,
                   [&wanted](std::uint64_t id, bool mustNotBe) {
                     wanted += "not " + std::to_string(id) + (mustNotBe ? " on;" : " off;");
                   });
  QObject::connect(&model, &StrokeModel::lightingWanted, &model,
                   [&wanted](std::uint64_t id, const QString& light) {
                     wanted += "light " + std::to_string(id) + " " + light.toStdString() + ";";
                   });
  EXPECT_FALSE(model.setData(model.index(1, StrokeModel::kWeight), at(1, StrokeModel::kWeight, Qt::EditRole),
                             Qt::EditRole));
  EXPECT_FALSE(model.setData(model.index(1, StrokeModel::kTool), QStringLiteral("wand"), Qt::EditRole));
  EXPECT_TRUE(model.setData(model.index(1, StrokeModel::kWeight), 3.0, Qt::EditRole));
  EXPECT_TRUE(model.setData(model.index(2, StrokeModel::kMustNotBe), Qt::Checked, Qt::CheckStateRole));
  EXPECT_TRUE(model.setData(model.index(0, StrokeModel::kLighting), QStringLiteral(" dusk "), Qt::EditRole));
  EXPECT_EQ(wanted, "weight 2 3;not 3 on;light 1 dusk;");
}

}  // namespace
}  // namespace widgets
