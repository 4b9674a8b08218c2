// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/DataModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>

#include "foxglove/Image.pb.h"
#include "robotlink/decoding/JsonType.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/data/DataFixture.h"
#include "widgets/plots/PlotTreeModel.h"

namespace widgets::test {
namespace {

using robotlink::Instant;

/// A model on a store, in which everything on the way to what a test looks at is unfolded, as a tree does.
class DataModelTest : public testing::Test {
 protected:
  template <typename T>
  void push(const std::string& path, const T& message, double time = 1) {
    push(path, robotlink::PackagePtr(std::make_shared<const T>(message)), time);
  }
  void push(const std::string& path, robotlink::PackagePtr message, double time = 1) {
    store.add({path, at(time), std::move(message)});
    model.update(store, store.newest());
  }
  static Instant at(double time) { return Instant(robotlink::fromSeconds(time)); }

  void unfold(const QModelIndex& index) { model.setFollowed(index, true); }
  QModelIndex row(const char* path) {
    const QString text = QString::fromLatin1(path);
    for (const QString& robot : {QStringLiteral("red1"), QStringLiteral("blue1"), QString()}) {
      if (const QModelIndex index = model.find(robot); index.isValid()) unfold(index);
    }
    for (int end = 0; end >= 0; end = text.indexOf(QLatin1Char('.'), end + 1)) {
      const QModelIndex index = model.find(text.left(end));
      if (index.isValid()) unfold(index);
    }
    return model.find(text);
  }
  std::string cell(const char* path, DataModel::Column column = DataModel::kValue) {
    return row(path).siblingAtColumn(column).data().toString().toStdString();
  }
  QModelIndex child(const QModelIndex& index, int n) { return model.index(n, 0, index); }

  robotlink::StreamStore store{{}};
  DataModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

std::vector<std::string> namesBelow(const QAbstractItemModel& model, const QModelIndex& parent) {
  std::vector<std::string> names;
  for (int i = 0; i < model.rowCount(parent); ++i)
    names.push_back(model.index(i, 0, parent).data().toString().toStdString());
  return names;
}

TEST_F(DataModelTest, aStreamSaysThatItsPackageIsHeld) {
  push("red1/models/ball", robotcontrol::BallModel());
  EXPECT_EQ(cell("red1/models/ball").find("held"), std::string::npos);
  robotcontrol::ProcessTable table;
  auto& port = *table.add_processes()->add_senders();
  port.set_package("models/ball");
  port.set_held(true);
  push("red1/tables/processes", table, 2);
  EXPECT_EQ(cell("red1/models/ball").rfind("held", 0), 0U) << cell("red1/models/ball");
}

TEST_F(DataModelTest, streamsStandBelowTheirRobotsInTheNaturalOrder) {
  for (const char* path : {"red10/log", "red2/plots/10", "red2/plots/9", "red2/models/ball", "scene"})
    push(path, robotcontrol::PlotValue());
  EXPECT_EQ(namesBelow(model, {}), (std::vector<std::string>{"red2", "red10", "Session"}));
  EXPECT_EQ(namesBelow(model, model.index(0, 0)),
            (std::vector<std::string>{"the ball model (models/ball)", "plots/9", "plots/10"}));
}

TEST_F(DataModelTest, aStreamSaysItsRateAndItsAge) {
  for (int i = 0; i <= 40; ++i) push("red1/log", robotcontrol::PlotValue(), 1 + 0.04 * i);
  model.update(store, store.newest() + std::chrono::milliseconds(500));
  EXPECT_EQ(cell("red1/log"), "25.0 Hz, 0.50 s ago");
  model.update(store, at(0.5));
  EXPECT_EQ(cell("red1/log"), "no message yet");
}

TEST_F(DataModelTest, fieldsHaveValuesUnitsAndEnumerationsByName) {
  robotcontrol::MotionStatus status;
  status.mutable_executed()->set_kind(robotcontrol::MotionRequest::WALK);
  status.mutable_executed()->mutable_walk()->set_x(0.125);
  status.mutable_timestamp()->set_seconds(12);
  status.mutable_timestamp()->set_nanos(340'000'000);
  push("red1/motion/status", status);
  EXPECT_EQ(cell("red1/motion/status.executed.kind"), "WALK");
  EXPECT_EQ(cell("red1/motion/status.executed.walk.x"), "0.125");
  EXPECT_EQ(cell("red1/motion/status.executed.walk.x", DataModel::kUnit), "m/s");
  EXPECT_EQ(cell("red1/motion/status.timestamp"), "12.340");
  EXPECT_EQ(cell("red1/motion/status.stable"), "false");
  EXPECT_EQ(cell("red1/motion/status.odometry"), "not set");
  EXPECT_FALSE(model.hasChildren(row("red1/motion/status.odometry")));
}

TEST_F(DataModelTest, whatIsSetLaterCanBeUnfoldedThen) {
  push("red1/motion/status", robotcontrol::MotionStatus());
  ASSERT_FALSE(model.hasChildren(row("red1/motion/status.odometry")));
  robotcontrol::MotionStatus status;
  status.mutable_odometry()->set_x(2);
  push("red1/motion/status", status, 2);
  EXPECT_EQ(cell("red1/motion/status.odometry.x"), "2");
  push("red1/motion/status", robotcontrol::MotionStatus(), 3);
  EXPECT_FALSE(model.hasChildren(row("red1/motion/status.odometry")));
}

TEST_F(DataModelTest, elementsHaveTheirNamesAndPathsThatExpressionsTake) {
  push("red1/joints/states", joints(0.5));
  EXPECT_EQ(namesBelow(model, row("red1/joints/states.joints")),
            (std::vector<std::string>{"[0] head.tilt", "[1] head.pan", "[2] mouth"}));
  const QModelIndex element = child(row("red1/joints/states.joints"), 1);
  unfold(element);
  const QModelIndex position = child(element, 1);
  EXPECT_EQ(position.data(DataModel::kPathRole).toString().toStdString(),
            "red1/joints/states.joints[head.pan].position");
  EXPECT_EQ(position.data(DataModel::kSourceRole).toString().toStdString(),
            "red1/joints/states: joints[head.pan].position");
  EXPECT_EQ(position.siblingAtColumn(DataModel::kValue).data().toString().toStdString(), "0.5");
  EXPECT_EQ(position.siblingAtColumn(DataModel::kUnit).data().toString().toStdString(), "rad");
}

TEST_F(DataModelTest, anElementWithTheNameOfAnotherOneIsFoundByItsIndex) {
  foxglove::JointStates states = joints(0.5);
  states.mutable_joints(2)->set_name("head.pan");
  push("red1/joints/states", states);
  EXPECT_EQ(child(row("red1/joints/states.joints"), 2).data(DataModel::kPathRole).toString().toStdString(),
            "red1/joints/states.joints[2]");
}

TEST_F(DataModelTest, listsAreFoldedWithStatistics) {
  push("red1/range/laser", laserScan(5));
  EXPECT_EQ(cell("red1/range/laser.ranges"), "5 elements, 0 to 4, mean 2");
  EXPECT_EQ(cell("red1/range/laser.intensities"), "0 elements");
  push("red1/joints/states", joints(0.5));
  EXPECT_EQ(cell("red1/joints/states.joints"), "3 elements");
}

TEST_F(DataModelTest, longListsAreDividedIntoRanges) {
  push("red1/range/laser", laserScan(10'500));
  const QModelIndex list = row("red1/range/laser.ranges");
  unfold(list);
  ASSERT_EQ(model.rowCount(list), 11);
  EXPECT_EQ(child(list, 10).data().toString(), QStringLiteral("[10000 … 10499]"));
  const QModelIndex last = child(list, 10);
  unfold(last);
  EXPECT_EQ(model.rowCount(last), 500);
  EXPECT_EQ(child(last, 499).siblingAtColumn(DataModel::kValue).data().toString().toStdString(), "10499");
  EXPECT_EQ(child(last, 499).data(DataModel::kPathRole).toString().toStdString(),
            "red1/range/laser.ranges[10499]");
  push("red1/range/laser", laserScan(10'200), 2);
  EXPECT_EQ(model.rowCount(last), 200);
  push("red1/range/laser", laserScan(20), 3);
  EXPECT_EQ(model.rowCount(row("red1/range/laser.ranges")), 20);
  push("red1/range/laser", laserScan(0), 4);
  EXPECT_EQ(model.rowCount(row("red1/range/laser.ranges")), 0);
}

TEST_F(DataModelTest, newMessagesChangeValuesInPlace) {
  push("red1/joints/states", joints(0.5));
  const QPersistentModelIndex element = child(row("red1/joints/states.joints"), 1);
  unfold(element);
  const QPersistentModelIndex position = child(element, 1);
  const QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
  const QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
  push("red1/joints/states", joints(0.75), 2);
  EXPECT_TRUE(position.isValid());
  EXPECT_EQ(position.sibling(position.row(), DataModel::kValue).data().toString().toStdString(), "0.75");
  EXPECT_EQ(resets.count() + inserted.count(), 0);
}

TEST_F(DataModelTest, whatIsFoldedIsNotLookedAt) {
  push("red1/range/laser", laserScan(5));
  const QModelIndex stream = row("red1/range/laser");
  unfold(stream);
  model.setFollowed(stream, false);
  const QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  push("red1/range/laser", laserScan(7), 2);
  ASSERT_EQ(changes.count(), 1);  // the age of the stream
  EXPECT_EQ(changes.at(0).at(0).toModelIndex().parent(), model.index(0, 0));
  EXPECT_EQ(cell("red1/range/laser.ranges"), "7 elements, 0 to 6, mean 3");  // which unfolds it
}

TEST_F(DataModelTest, messagesOfAnUnknownTypeAreShownAlike) {
  const auto type = robotlink::JsonType::ofSchema(
      "their.Pose",
      R"({"type": "object", "properties": {"x": {"type": "number"}, "note": {"type": "string"}}})");
  const std::string json = R"({"x": 1.5, "note": "here"})";
  push("red1/their/pose",
       robotlink::JsonType::read(type, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()}));
  EXPECT_EQ(cell("red1/their/pose.x"), "1.5");
  EXPECT_EQ(cell("red1/their/pose.note"), "here");
}

TEST_F(DataModelTest, aStreamOfAnotherTypeGetsOtherFields) {
  push("red1/a", laserScan(3));
  row("red1/a.ranges");
  push("red1/a", joints(0.5), 2);
  EXPECT_EQ(cell("red1/a.joints"), "3 elements");
  EXPECT_FALSE(row("red1/a.ranges").isValid());
}

TEST_F(DataModelTest, imagesHaveAPictureAndBytesTheirLength) {
  foxglove::RawImage image;
  const robotlink::Image pixels(64, 48, robotlink::PixelFormat::kRgb8);
  robotlink::assign(image, pixels.view(), {}, "camera");
  push("red1/camera/image", image);
  const QModelIndex stream = row("red1/camera/image").siblingAtColumn(DataModel::kValue);
  EXPECT_EQ(stream.data(Qt::DecorationRole).value<QImage>().height(), DataModel::kThumbnailHeight);
  EXPECT_EQ(cell("red1/camera/image.data"), "9.2 kB");
}

TEST_F(DataModelTest, aStreamBehindAKeyThatIsOffIsListed) {
  push("red1/tables/keys", keyTable(false));
  const QModelIndex off = row("red1/models/ball");
  ASSERT_TRUE(off.isValid());
  EXPECT_EQ(off.data(DataModel::kKeyRole).toString().toStdString(), "package/models/ball");
  EXPECT_FALSE(model.hasChildren(off));
  push("red1/models/ball", robotcontrol::BallModel(), 2);
  push("red1/tables/keys", keyTable(true), 2);
  EXPECT_TRUE(row("red1/models/ball").data(DataModel::kKeyRole).toString().isEmpty());
  EXPECT_TRUE(model.hasChildren(row("red1/models/ball")));
}

TEST_F(DataModelTest, aSearchKeepsWhatStandsAboveAndBelow) {
  push("red1/joints/states", joints(0.5));
  push("red1/range/laser", laserScan(3));
  push("blue1/range/laser", laserScan(3));
  model.setWords(QStringLiteral("PAN position"));
  EXPECT_EQ(namesBelow(model, {}), (std::vector<std::string>{"red1"}));
  EXPECT_EQ(namesBelow(model, row("red1/joints/states.joints")), (std::vector<std::string>{"[1] head.pan"}));
  EXPECT_EQ(namesBelow(model, row("red1/joints/states.joints[head.pan]")),
            (std::vector<std::string>{"position"}));
  model.setWords(QStringLiteral("laser"));
  EXPECT_EQ(namesBelow(model, {}), (std::vector<std::string>{"blue1", "red1"}));
  EXPECT_EQ(model.rowCount(row("red1/range/laser")), foxglove::LaserScan::descriptor()->field_count());
  model.setWords(QStringLiteral("nothing of this"));
  EXPECT_EQ(model.rowCount(), 0);
  model.setWords({});
  EXPECT_EQ(model.rowCount(), 2);
}

TEST_F(DataModelTest, valuesAreComparedWithThoseOfAnotherRobot) {
  foxglove::JointStates other = joints(0.5);
  other.mutable_joints()->SwapElements(0, 1);
  other.mutable_joints(0)->set_position(0.25);  // head.pan, in another place
  other.mutable_timestamp()->set_seconds(13);
  push("red1/joints/states", joints(0.5));
  push("blue1/joints/states", other);
  model.setComparison({DataComparison::With::kRobot, "blue1"});
  const QModelIndex element = child(row("red1/joints/states.joints"), 1);
  unfold(element);
  const QModelIndex position = child(element, 1);
  EXPECT_EQ(position.siblingAtColumn(DataModel::kOther).data().toString().toStdString(), "0.25");
  EXPECT_TRUE(position.data(DataModel::kChangedRole).toBool());
  EXPECT_TRUE(element.data(DataModel::kChangedRole).toBool());
  EXPECT_TRUE(row("red1/joints/states").data(DataModel::kChangedRole).toBool());
  EXPECT_FALSE(child(row("red1/joints/states.joints"), 2).data(DataModel::kChangedRole).toBool());
  EXPECT_FALSE(row("red1/joints/states.timestamp").data(DataModel::kChangedRole).toBool());
  EXPECT_FALSE(row("blue1/joints/states").data(DataModel::kChangedRole).toBool());
}

TEST_F(DataModelTest, valuesAreComparedWithARememberedInstantAndWithTheLog) {
  push("red1/models/pose", robotcontrol::RobotPose());
  model.remember();
  robotcontrol::RobotPose pose;
  pose.set_position_deviation(0.5);
  push("red1/models/pose", pose, 2);
  pose.set_position_deviation(0.75);
  push("red1/logged/models/pose", pose, 2);
  model.setComparison({DataComparison::With::kRemembered});
  EXPECT_EQ(cell("red1/models/pose.position_deviation", DataModel::kOther), "0");
  EXPECT_TRUE(row("red1/models/pose.position_deviation").data(DataModel::kChangedRole).toBool());
  EXPECT_FALSE(row("red1/models/pose.heading_deviation").data(DataModel::kChangedRole).toBool());
  model.setComparison({DataComparison::With::kLogged});
  EXPECT_EQ(cell("red1/models/pose.position_deviation", DataModel::kOther), "0.75");
  model.setComparison({});
  EXPECT_EQ(cell("red1/models/pose.position_deviation", DataModel::kOther), "");
  EXPECT_FALSE(row("red1/models/pose").data(DataModel::kChangedRole).toBool());
}

TEST_F(DataModelTest, partsAreCopiedAsJson) {
  push("red1/joints/states", joints(0.5));
  EXPECT_EQ(model.json(child(row("red1/joints/states.joints"), 1)).toStdString(),
            "{\n  \"name\": \"head.pan\",\n  \"position\": 0.5\n}");
  push("red1/range/laser", laserScan(2));
  EXPECT_EQ(model.json(row("red1/range/laser.ranges")).toStdString(), "[\n  0,\n  1\n]");
  EXPECT_TRUE(model.json(row("red1/range/laser")).contains(QStringLiteral("\"start_angle\"")));
}

TEST_F(DataModelTest, numbersCanBeDraggedIntoAPlot) {
  push("red1/range/laser", laserScan(2));
  robotcontrol::PlotValue plot;
  plot.set_unit("m");
  push("red1/plots/x", plot);
  const QModelIndex angle = row("red1/range/laser.start_angle");
  const QModelIndex value = row("red1/plots/x.value");
  const QModelIndex text = row("red1/range/laser.frame_id");
  EXPECT_TRUE(angle.flags().testFlag(Qt::ItemIsDragEnabled));
  EXPECT_FALSE(text.flags().testFlag(Qt::ItemIsDragEnabled));
  EXPECT_EQ(cell("red1/plots/x.value", DataModel::kUnit), "m");
  const std::unique_ptr<QMimeData> data(model.mimeData({angle, value, text}));
  EXPECT_EQ(data->data(QLatin1String(PlotTreeModel::kMimeType)).toStdString(),
            "red1/range/laser: start_angle\nred1/plots/x");
}

TEST_F(DataModelTest, expandersStayWhereAListHasNothingForAWhile) {
  push("red1/range/laser", laserScan(3));
  const QPersistentModelIndex list = row("red1/range/laser.ranges");
  unfold(list);
  push("red1/range/laser", laserScan(0), 2);
  EXPECT_EQ(model.rowCount(list), 0);
  push("red1/range/laser", laserScan(2), 3);
  EXPECT_EQ(model.rowCount(list), 2);
}

TEST_F(DataModelTest, streamsThatAreGoneAreRemoved) {
  push("red1/a", laserScan(1));
  push("red1/b", laserScan(1));
  row("red1/a.ranges");
  store.clear();
  push("red1/b", laserScan(2));
  EXPECT_EQ(namesBelow(model, model.index(0, 0)), (std::vector<std::string>{"b"}));
}

}  // namespace
}  // namespace widgets::test
