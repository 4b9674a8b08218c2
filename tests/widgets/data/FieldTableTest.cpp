// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/FieldTable.h"

#include <gtest/gtest.h>

#include "tests/widgets/data/DataFixture.h"
#include "tests/widgets/timeline/MadeUpArchive.h"
#include "widgets/data/FieldTableModel.h"

namespace widgets::test {
namespace {

using robotlink::Instant;

Instant tableTime(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

robotlink::StreamStore storeOfJoints(int messages) {
  robotlink::StreamStore store{{}};
  for (int i = 0; i < messages; ++i) {
    store.add({"red1/joints/states", tableTime(1 + 0.5 * i),
               std::make_shared<const foxglove::JointStates>(joints(0.25 * i))});
  }
  return store;
}

const std::vector<FieldColumn> kPanAndKind{{"red1/joints/states", "joints[head.pan].position"},
                                           {"red1/motion/status", "executed.kind"}};

TEST(FieldTableTest, valuesOfSeveralStreamsAreInTheOrderOfTime) {
  robotlink::StreamStore store = storeOfJoints(2);
  robotcontrol::MotionStatus status;
  status.mutable_executed()->set_kind(robotcontrol::MotionRequest::WALK);
  store.add(
      {"red1/motion/status", tableTime(1.25), std::make_shared<const robotcontrol::MotionStatus>(status)});
  store.add({"red1/motion/status", tableTime(1.5), std::make_shared<const robotcontrol::MotionStatus>()});
  const auto table = makeTable(historyOf(store, nullptr, kPanAndKind), [](double) { return true; });
  ASSERT_TRUE(table);
  EXPECT_EQ(table->csv(tableTime(1)),
            "time_s,red1/joints/states.joints[head.pan].position,red1/motion/status.executed.kind\r\n"
            "0.000000000,0,\r\n"
            "0.250000000,,WALK\r\n"
            "0.500000000,0.25,\r\n");
}

TEST(FieldTableTest, whatIsOnDiskComesBeforeWhatIsInMemory) {
  MadeUpArchive archive(true);
  robotlink::StreamStore store{{.bytes = 100'000}};
  store.setArchive(&archive);
  for (int i = 0; i < 1000; ++i) {
    store.add({"red1/joints/states", tableTime(1 + 0.5 * i),
               std::make_shared<const foxglove::JointStates>(joints(0.25 * i))});
  }
  ASSERT_LT(store.find("red1/joints/states")->messages.size(), 1000U);
  const auto table = makeTable(historyOf(store, &archive, kPanAndKind), [](double) { return true; });
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 1000U);
  for (std::size_t i = 0; i < table->rows.size(); ++i)
    ASSERT_EQ(table->rows[i].time, tableTime(1 + 0.5 * static_cast<double>(i)));
  EXPECT_EQ(table->rows[4].cells.front(), "1");
  store.setArchive(nullptr);
}

TEST(FieldTableTest, makingItCanBeCanceled) {
  const robotlink::StreamStore store = storeOfJoints(100);
  FieldTableSource source = historyOf(store, nullptr, kPanAndKind);
  source.messages[0].resize(5000, source.messages[0].front());
  double last = 0;
  const auto table = makeTable(source, [&last](double share) {
    last = share;
    return share < 0.5;
  });
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().id, "log.given-up");
  EXPECT_EQ(last, 0.6);
}

TEST(FieldTableTest, aLogThatIsNotThereIsAnError) {
  FieldTableSource source;
  source.columns = kPanAndKind;
  source.logStreams = {"red1/joints/states", ""};
  source.log = "/nowhere/game.mcap";
  EXPECT_FALSE(makeTable(source, [](double) { return true; }));
}

TEST(FieldTableTest, theModelFindsTheRowOfAnInstant) {
  const robotlink::StreamStore store = storeOfJoints(3);
  FieldTableModel model;
  model.setTable(*makeTable(historyOf(store, nullptr, kPanAndKind), [](double) { return true; }),
                 tableTime(1));
  EXPECT_EQ(model.rowAt(tableTime(0.9)), -1);
  EXPECT_EQ(model.rowAt(tableTime(1)), 0);
  EXPECT_EQ(model.rowAt(tableTime(1.7)), 1);
  EXPECT_EQ(model.rowAt(tableTime(9)), 2);
  EXPECT_EQ(model.index(1, 0).data().toString().toStdString(), "0.500");
  EXPECT_EQ(model.index(1, 1).data().toString().toStdString(), "0.25");
  EXPECT_EQ(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString().toStdString(),
            "joints[head.pan].position");
}

}  // namespace
}  // namespace widgets::test
