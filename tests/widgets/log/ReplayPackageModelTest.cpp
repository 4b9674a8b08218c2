// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/ReplayPackageModel.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

using robotcontrol::ControlReplay;

class ReplayPackageModelTest : public testing::Test {
 protected:
  ReplayPackageModelTest() {
    auto& ball = *status.add_packages();
    ball.set_package("ball");
    ball.set_logged(true);
    ball.set_can_recompute(true);
    ball.set_source(ControlReplay::RECOMPUTED);
    auto& image = *status.add_packages();
    image.set_package("image");
    image.set_logged(true);
    image.set_why_not("it is a sensor's");
    image.set_source(ControlReplay::AS_LOGGED);
    image.set_chosen(true);
    auto& difference = *status.add_differences();
    difference.set_package("ball");
    difference.set_compared(20);
    difference.set_different(3);
    difference.set_only_logged(1);
    difference.set_first_time(1'500'000'000);
    difference.set_largest_field("x");
    difference.set_largest(0.25);
    difference.set_largest_time(2'000'000'000);
    QObject::connect(&model, &QAbstractItemModel::modelReset, &model, [this] { ++resets; });
    QObject::connect(&model, &QAbstractItemModel::dataChanged, &model,
                     [this](const QModelIndex& index) { changed.push_back(index.row()); });
    show();
  }
  void show(double origin = 1) {
    model.setStatus(status, robotlink::Instant(robotlink::fromSeconds(origin)));
  }
  std::string text(int row, ReplayPackageModel::Column column, int role = Qt::DisplayRole) const {
    return model.data(model.index(row, column), role).toString().toStdString();
  }

  robotcontrol::ReplayStatus status;
  ReplayPackageModel model;
  int resets = 0;
  std::vector<int> changed;
};

TEST_F(ReplayPackageModelTest, showsSourceAndDifferences) {
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(text(0, ReplayPackageModel::kSource), "recomputed (automatic)");
  EXPECT_EQ(text(0, ReplayPackageModel::kCompared), "20");
  EXPECT_EQ(text(0, ReplayPackageModel::kDifferent), "3 + 1 alone");
  EXPECT_EQ(text(0, ReplayPackageModel::kFirst), "0.500") << "counted from the origin";
  EXPECT_EQ(text(0, ReplayPackageModel::kLargest), "x: 0.25");
  EXPECT_EQ(text(1, ReplayPackageModel::kSource), "as logged");
  EXPECT_EQ(text(1, ReplayPackageModel::kDifferent), "–") << "what was not compared has no figures";
  EXPECT_EQ(text(1, ReplayPackageModel::kLargest), "–");
}

TEST_F(ReplayPackageModelTest, whereASourceIsNotPossibleItSaysWhy) {
  EXPECT_TRUE(model.allows(0, ControlReplay::RECOMPUTED));
  EXPECT_FALSE(model.allows(1, ControlReplay::RECOMPUTED));
  EXPECT_EQ(model.reason(1, ControlReplay::RECOMPUTED).toStdString(), "it is a sensor's");
  EXPECT_EQ(model.reason(0, ControlReplay::AS_LOGGED).toStdString(), "");
  status.mutable_packages(1)->clear_why_not();
  status.mutable_packages(1)->set_logged(false);
  show();
  EXPECT_EQ(model.reason(1, ControlReplay::RECOMPUTED).toStdString(), "no task of the program produces it");
  EXPECT_EQ(model.reason(1, ControlReplay::AS_LOGGED).toStdString(), "the log does not hold it");
  EXPECT_EQ(text(1, ReplayPackageModel::kSource), "not available");
}

TEST_F(ReplayPackageModelTest, onlyAPossibleSourceIsRequested) {
  std::vector<std::pair<std::string, int>> wanted;
  QObject::connect(
      &model, &ReplayPackageModel::sourceWanted, &model,
      [&wanted](const QString& package, int source) { wanted.emplace_back(package.toStdString(), source); });
  EXPECT_FALSE(model.setData(model.index(1, ReplayPackageModel::kSource), int(ControlReplay::RECOMPUTED),
                             Qt::EditRole));
  EXPECT_FALSE(model.setData(model.index(0, ReplayPackageModel::kPackage), int(ControlReplay::AS_LOGGED),
                             Qt::EditRole));
  EXPECT_TRUE(model.setData(model.index(0, ReplayPackageModel::kSource), int(ControlReplay::AS_LOGGED),
                            Qt::EditRole));
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted[0].first, "ball");
  EXPECT_EQ(wanted[0].second, int(ControlReplay::AS_LOGGED));
}

TEST_F(ReplayPackageModelTest, figuresAreSortedAsNumbers) {
  EXPECT_EQ(
      model.data(model.index(0, ReplayPackageModel::kDifferent), ReplayPackageModel::kSortRole).toULongLong(),
      4U);
  EXPECT_EQ(
      model.data(model.index(0, ReplayPackageModel::kFirst), ReplayPackageModel::kFirstRole).toLongLong(),
      1'500'000'000);
  EXPECT_EQ(
      model.data(model.index(0, ReplayPackageModel::kLargest), ReplayPackageModel::kLargestRole).toLongLong(),
      2'000'000'000);
  EXPECT_FALSE(
      model.data(model.index(1, ReplayPackageModel::kFirst), ReplayPackageModel::kFirstRole).isValid());
}

TEST_F(ReplayPackageModelTest, onlyRowsThatChangedAreAnnounced) {
  show();
  EXPECT_TRUE(changed.empty());
  status.mutable_differences(0)->set_compared(21);
  show();
  EXPECT_EQ(changed, std::vector<int>{0});
  show(2);
  EXPECT_EQ(changed, (std::vector<int>{0, 0, 1})) << "all times count from another origin";
  EXPECT_EQ(resets, 1);
  status.mutable_packages()->RemoveLast();
  show(2);
  EXPECT_EQ(resets, 2);
}

}  // namespace
}  // namespace widgets
