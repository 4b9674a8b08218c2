// SPDX-License-Identifier: GPL-3.0-or-later
// Rows, cells and sorting; StreamsViewTest has what a session publishes.
#include "widgets/streams/StreamListModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "robotlink/session/Session.h"
#include "tests/widgets/streams/StoredMessages.h"
#include "widgets/log/LogOverview.h"

namespace widgets::test {
namespace {

StreamRow streamRow(const char* path, std::uint64_t bytes = 0, const char* log = "") {
  StreamRow row;
  row.log = log;
  row.path = path;
  row.type = "robotcontrol.BallModel";
  row.bytes = bytes;
  return row;
}

class StreamListModelTest : public testing::Test {
 protected:
  std::string cell(int row, int column) const {
    return model.index(row, column).data().toString().toStdString();
  }
  QVariant role(int row, int column, int role) const { return model.data(model.index(row, column), role); }

  StreamListModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(StreamListModelTest, whatIsNotKnownIsADashAndNotAZero) {
  model.setRows({streamRow("red1/a")});
  for (const int column : {StreamListModel::kRate, StreamListModel::kByteRate, StreamListModel::kMeanSize,
                           StreamListModel::kBytes, StreamListModel::kShare})
    EXPECT_EQ(cell(0, column), "–") << column;
  EXPECT_EQ(cell(0, StreamListModel::kCount), "0");
  EXPECT_EQ(cell(0, StreamListModel::kLeftOut), "");
  EXPECT_EQ(cell(0, StreamListModel::kLog), "");
}

TEST_F(StreamListModelTest, numbersHaveUnitsAndAreSortedAsNumbers) {
  StreamRow row = streamRow("red1/a", 2'500'000, "/logs/game.mcap");
  row.count = 1000;
  row.rate = 29.96;
  row.byteRate = 74'900;
  row.meanSize = 2500;
  model.setRows({row});
  EXPECT_EQ(cell(0, StreamListModel::kRate), "30.0");
  EXPECT_EQ(cell(0, StreamListModel::kByteRate), "74.9 kB");
  EXPECT_EQ(cell(0, StreamListModel::kMeanSize), "2.5 kB");
  EXPECT_EQ(cell(0, StreamListModel::kBytes), "2.5 MB");
  EXPECT_EQ(cell(0, StreamListModel::kShare), "100.0 %");
  EXPECT_EQ(cell(0, StreamListModel::kLog), "game.mcap");
  EXPECT_EQ(role(0, StreamListModel::kRate, StreamListModel::kSortRole), 29.96);
  EXPECT_EQ(role(0, StreamListModel::kBytes, StreamListModel::kSortRole), 2'500'000ULL);
  EXPECT_EQ(role(0, StreamListModel::kPath, StreamListModel::kSortRole), QStringLiteral("red1/a"));
}

TEST_F(StreamListModelTest, sharesAreOfAllStreamsAlsoOfThoseThatAreNotListed) {
  StreamRow read = streamRow("red1/read", 300);
  read.asked.views << QStringLiteral("Plots");
  model.setRows({streamRow("red1/unread", 100), read}, StreamListModel::Which::kUnread);
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(cell(0, StreamListModel::kPath), "red1/unread");
  EXPECT_EQ(cell(0, StreamListModel::kShare), "25.0 %");
}

TEST_F(StreamListModelTest, lossesAreTheOnesThatAreRed) {
  StreamRow thinned = streamRow("red1/thinned"), lost = streamRow("red1/lost");
  thinned.missing = {12, 0};
  lost.missing = {12, 3};
  model.setRows({streamRow("red1/whole"), thinned, lost}, StreamListModel::Which::kLeftOut);
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(cell(0, StreamListModel::kLeftOut), "12 thinned");
  EXPECT_EQ(cell(1, StreamListModel::kLeftOut), "12 thinned, 3 lost");
  EXPECT_EQ(role(1, StreamListModel::kLeftOut, StreamListModel::kSortRole), 15ULL);
  EXPECT_FALSE(role(0, StreamListModel::kLeftOut, Qt::ForegroundRole).isValid());
  EXPECT_TRUE(role(1, StreamListModel::kLeftOut, Qt::ForegroundRole).isValid());
}

TEST_F(StreamListModelTest, whoAskedIsNamedAndCanBeSearched) {
  StreamRow read = streamRow("red1/read"), keyed = streamRow("red1/keyed");
  read.asked = {{QStringLiteral("Plots"), QStringLiteral("Data")}, {QStringLiteral("Foxglove")}, {}};
  keyed.asked.key = QStringLiteral("ball: always");
  model.setRows({read, keyed, streamRow("red1/other")});
  EXPECT_EQ(cell(0, StreamListModel::kAskedBy), "Plots, Data, Foxglove");
  EXPECT_EQ(role(0, StreamListModel::kAskedBy, Qt::ToolTipRole).toString(),
            QStringLiteral("Views: Plots, Data\nClients: Foxglove"));
  EXPECT_EQ(cell(1, StreamListModel::kAskedBy), "nobody; key ball: always");
  EXPECT_EQ(role(1, StreamListModel::kAskedBy, Qt::ToolTipRole).toString(),
            QStringLiteral("Debug key ball: always"));
  EXPECT_EQ(cell(2, StreamListModel::kAskedBy), "");
  EXPECT_FALSE(role(2, StreamListModel::kAskedBy, Qt::ToolTipRole).isValid());
  EXPECT_EQ(role(0, 0, StreamListModel::kFilterRole).toString(),
            QStringLiteral("red1/read robotcontrol.BallModel Plots, Data, Foxglove"));
}

TEST_F(StreamListModelTest, onlyStreamsOfLogsHaveACheckBox) {
  model.setRows({streamRow("red1/live"), streamRow("red1/logged", 0, "/logs/game.mcap")});
  EXPECT_FALSE(role(0, StreamListModel::kPath, Qt::CheckStateRole).isValid());
  EXPECT_FALSE(model.flags(model.index(0, 0)).testFlag(Qt::ItemIsUserCheckable));
  EXPECT_EQ(role(1, StreamListModel::kPath, Qt::CheckStateRole), Qt::Checked);
  EXPECT_FALSE(role(1, StreamListModel::kRate, Qt::CheckStateRole).isValid());
  std::vector<std::string> changed;
  QObject::connect(&model, &StreamListModel::shownChanged, &model,
                   [&](const std::string& log, const std::string& stream, bool shown) {
                     changed.push_back(log + " " + stream + (shown ? " on" : " off"));
                   });
  EXPECT_TRUE(model.setData(model.index(1, 0), Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_FALSE(model.setData(model.index(1, 1), Qt::Checked, Qt::CheckStateRole));
  EXPECT_FALSE(model.setData(model.index(1, 0), QStringLiteral("name"), Qt::EditRole));
  EXPECT_EQ(changed, std::vector<std::string>{"/logs/game.mcap red1/logged off"});
  EXPECT_EQ(role(1, StreamListModel::kPath, Qt::CheckStateRole), Qt::Unchecked);
}

TEST_F(StreamListModelTest, selectionsSurviveOtherNumbersButNotOtherStreams) {
  QSignalSpy resets(&model, &QAbstractItemModel::modelReset),
      changes(&model, &QAbstractItemModel::dataChanged);
  model.setRows({streamRow("red1/a", 1), streamRow("red1/b", 1)});
  EXPECT_EQ(resets.count(), 1);
  model.setRows({streamRow("red1/a", 2), streamRow("red1/b", 2)});
  EXPECT_EQ(resets.count(), 1);
  EXPECT_EQ(changes.count(), 1);
  model.setRows({streamRow("red1/a", 2), streamRow("red1/b", 2)});
  EXPECT_EQ(changes.count(), 1) << "nothing is painted again";
  model.setRows({streamRow("red1/a", 2), streamRow("red1/b", 2, "/logs/game.mcap")});
  EXPECT_EQ(resets.count(), 2) << "the same path in a log is another stream";
}

TEST_F(StreamListModelTest, aSteppedStreamIsBoldAndSaysSo) {
  StreamRow row = streamRow("red1/a");
  row.stepped = true;
  model.setRows({row});
  EXPECT_TRUE(role(0, StreamListModel::kRate, Qt::FontRole).isValid());
  EXPECT_EQ(role(0, StreamListModel::kPath, Qt::ToolTipRole).toString(),
            QStringLiteral("red1/a: its messages are stepped"));
}

TEST(StreamRows, aLogHasThemWithTheRatesOfItsMessages) {
  LogOverview overview;
  overview.streams.push_back({"nao/a", "t.A", 101, 20'200, atSeconds(10), atSeconds(20)});
  overview.streams.push_back({"nao/b", "t.B", 1, 50, atSeconds(10), atSeconds(10)});
  overview.streams.push_back({"nao/c", "t.C", 0, 0, {}, {}});
  const auto rows = StreamListModel::rowsOf("/logs/game.mcap", overview, {"nao/b"});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_DOUBLE_EQ(rows[0].rate, 10);
  EXPECT_DOUBLE_EQ(rows[0].meanSize, 200);
  EXPECT_DOUBLE_EQ(rows[0].byteRate, 2000);
  EXPECT_TRUE(rows[0].shown);
  EXPECT_EQ(rows[1].rate, 0) << "a single message has no rate";
  EXPECT_FALSE(rows[1].shown);
  EXPECT_EQ(rows[2].meanSize, 0);
}

TEST(StreamRows, liveStreamsAreThoseOfTheChosenRobots) {
  robotlink::Session session;
  robotcontrol::PlotValue value;
  for (const char* path : {"red1/plots/a", "blue1/plots/a", "simulation"})
    session.push({path, atSeconds(1), std::make_shared<const robotcontrol::PlotValue>(value)});
  session.tick();
  session.setRemoteRobots({{"red1", {.url = "ws://hall", .missing = {{"red1/plots/a", {4, 5}}}}}});
  EXPECT_EQ(StreamListModel::rowsOf(session).size(), 3U);
  const std::set<std::string> robots{"red1"};
  const auto rows = StreamListModel::rowsOf(session, &robots);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].path, "red1/plots/a");
  EXPECT_EQ(rows[0].type, "robotcontrol.PlotValue");
  EXPECT_EQ(rows[0].count, 1U);
  EXPECT_EQ(rows[0].missing, (robotlink::MissingMessages{4, 5}));
  EXPECT_EQ(rows[0].log, "");
}

}  // namespace
}  // namespace widgets::test
