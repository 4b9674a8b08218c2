// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/DrawingsModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QJsonArray>
#include <QSignalSpy>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

namespace widgets::test {
namespace {

/// The list of a view of the field, with the drawings and debug keys of a session.
class DrawingsModelTest : public testing::Test {
 protected:
  DrawingsModelTest() {
    session.setRobots({"red1", "blue1"});
    session.setRequestSink([this](const robotcontrol::Request& request) { requests.push_back(request); });
  }
  void draw(const std::string& path) {
    session.push(
        {path, robotlink::Instant(std::chrono::seconds(1)), std::make_shared<const foxglove::SceneUpdate>()});
    refresh();
  }
  void refresh(const std::string& robot = "red1") {
    session.tick();
    model.refresh(session, robot);
  }
  /// A key that draws on the field.
  void setKey(const char* name, robotcontrol::KeyMode::Kind kind, unsigned n = 0,
              const std::string& robot = "red1") {
    robotcontrol::KeyTable table;
    auto& key = *table.add_keys();
    key.set_name(name);
    key.set_stream(std::string("drawings/field/") + name);
    key.set_help("Where it is.");
    key.mutable_mode()->set_kind(kind);
    key.mutable_mode()->set_n(n);
    session.push({robot + "/tables/keys", robotlink::Instant(std::chrono::seconds(1)),
                  std::make_shared<const robotcontrol::KeyTable>(table)});
    refresh(robot);
  }
  void answer(bool accepted, const char* reason = "") {
    robotcontrol::RequestResult result;
    result.set_id(requests.back().id());
    result.set_accepted(accepted);
    result.set_reason(reason);
    session.pushResult(result);
    session.tick();
  }
  QVariant role(int row, int role) const { return model.data(model.index(row), role); }
  bool isChecked(int row) const { return role(row, Qt::CheckStateRole) == Qt::Checked; }
  std::string tip(int row) const { return role(row, Qt::ToolTipRole).toString().toStdString(); }
  bool check(int row, bool checked) {
    return model.setData(model.index(row), checked ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
  }

  robotlink::Session session;
  std::vector<robotcontrol::Request> requests;
  DrawingsModel model{{QStringLiteral("field"), QStringLiteral("robot")}};
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(DrawingsModelTest, drawingsOfAllRobotsAreListedOnceByTheirNames) {
  draw("red1/drawings/field/ball");
  draw("blue1/drawings/field/ball");
  draw("red1/drawings/robot/ball");
  draw("red1/drawings/image/lines");
  draw("red1/plots/ball");
  EXPECT_EQ(model.shown(), (QStringList{QStringLiteral("field/ball"), QStringLiteral("robot/ball")}));
  EXPECT_EQ(role(0, Qt::DisplayRole).toString(), QStringLiteral("ball"));
  EXPECT_EQ(role(1, Qt::DisplayRole).toString(), QStringLiteral("ball (robot)"));
  EXPECT_EQ(tip(0), "field/ball");
}

TEST_F(DrawingsModelTest, whatAShadowDrawsHasANameOfItsOwnAndTheSameKey) {
  draw("red1/shadow/kalman/drawings/field/ball/cloud");
  ASSERT_EQ(model.shown(), QStringList(QStringLiteral("field/shadow/kalman/ball/cloud")));
  model.switchKey(0, true);
  EXPECT_EQ(requests.at(0).set_key().name(), "ball/cloud");
}

TEST_F(DrawingsModelTest, aDrawingWhoseKeyIsOffIsSwitchedOnByItsCheckBox) {
  setKey("ball/path", robotcontrol::KeyMode::OFF);
  EXPECT_FALSE(isChecked(0));
  EXPECT_TRUE(role(0, DrawingsModel::kOffRole).toBool());
  EXPECT_EQ(tip(0), "field/ball/path: Where it is.\nThe robot does not draw it; check it to switch it on");
  EXPECT_TRUE(check(0, true));
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].robot(), "red1");
  EXPECT_EQ(requests[0].set_key().name(), "ball/path");
  EXPECT_EQ(requests[0].set_key().mode().kind(), robotcontrol::KeyMode::ALWAYS);
  EXPECT_TRUE(isChecked(0)) << "as soon as it was requested";
  EXPECT_EQ(tip(0), "field/ball/path: Where it is.\nThe robot was asked to draw it");
  setKey("ball/path", robotcontrol::KeyMode::ALWAYS);
  EXPECT_FALSE(role(0, DrawingsModel::kOffRole).toBool());
  EXPECT_TRUE(isChecked(0));
}

TEST_F(DrawingsModelTest, aRefusalTakesTheCheckBackAndSaysWhy) {
  setKey("ball/path", robotcontrol::KeyMode::OFF);
  check(0, true);
  answer(false, "no such key");
  EXPECT_FALSE(isChecked(0));
  EXPECT_EQ(tip(0), "field/ball/path: Where it is.\nThe robot refused to draw it: no such key");
  check(0, true);
  EXPECT_TRUE(isChecked(0)) << "one may try again";
  answer(true);
  EXPECT_EQ(tip(0), "field/ball/path: Where it is.\nThe robot was asked to draw it");
}

TEST_F(DrawingsModelTest, uncheckingHidesADrawingAndLeavesItsKey) {
  draw("red1/drawings/field/ball");
  QSignalSpy changes(&model, &DrawingsModel::shownChanged);
  EXPECT_TRUE(check(0, false));
  EXPECT_EQ(model.shown(), QStringList());
  EXPECT_EQ(changes.count(), 1);
  EXPECT_TRUE(requests.empty()) << "other views may show it";
  EXPECT_FALSE(model.setData(model.index(0), QStringLiteral("name"), Qt::EditRole));
}

TEST_F(DrawingsModelTest, aKeyWhoseTimesAreOverStillShowsItsLastDrawing) {
  setKey("ball", robotcontrol::KeyMode::OFF, 3);
  draw("red1/drawings/field/ball");
  EXPECT_TRUE(isChecked(0));
  EXPECT_FALSE(role(0, DrawingsModel::kOffRole).toBool());
}

TEST_F(DrawingsModelTest, keysAreThoseOfTheRobotThatIsShown) {
  setKey("ball", robotcontrol::KeyMode::OFF, 0, "blue1");
  setKey("ball", robotcontrol::KeyMode::ALWAYS, 0, "red1");
  EXPECT_FALSE(role(0, DrawingsModel::kOffRole).toBool());
  refresh("blue1");
  EXPECT_TRUE(role(0, DrawingsModel::kOffRole).toBool());
  refresh("green1");
  EXPECT_FALSE(role(0, DrawingsModel::kOffRole).toBool()) << "nothing is known of it";
}

TEST_F(DrawingsModelTest, rowsMoveUpAndDownButNotOverTheEnds) {
  for (const char* name : {"a", "b", "c", "d"}) draw(std::string("red1/drawings/field/") + name);
  const auto order = [this] { return model.names().join(QString()).toStdString(); };
  QSignalSpy changes(&model, &DrawingsModel::shownChanged);
  model.move(0, 2);
  EXPECT_EQ(order(), "bcad");
  model.move(3, -3);
  EXPECT_EQ(order(), "dbca");
  model.move(1, 1);
  EXPECT_EQ(order(), "dcba");
  EXPECT_EQ(changes.count(), 3);
  for (const auto& [row, by] : {std::pair(0, -1), {3, 1}, {-1, 1}, {4, -1}, {2, 0}}) model.move(row, by);
  EXPECT_EQ(order(), "dcba");
  EXPECT_EQ(changes.count(), 3);
}

TEST_F(DrawingsModelTest, orderAndChecksAreRestoredBeforeThereAreDrawings) {
  for (const char* name : {"a", "b", "c"}) draw(std::string("red1/drawings/field/") + name);
  model.move(2, -2);
  check(1, false);
  DrawingsModel other({QStringLiteral("field")});
  other.restoreState(model.saveState());
  EXPECT_EQ(other.names().join(QString()), QStringLiteral("cab"));
  EXPECT_EQ(other.shown(), (QStringList{QStringLiteral("field/c"), QStringLiteral("field/b")}));
  EXPECT_FALSE(other.data(other.index(0), DrawingsModel::kExistsRole).toBool());
  EXPECT_EQ(other.data(other.index(0), Qt::ToolTipRole).toString(),
            QStringLiteral("field/c\nNo robot has drawn it yet"));
  other.refresh(session, "red1");
  EXPECT_TRUE(other.data(other.index(0), DrawingsModel::kExistsRole).toBool());
  EXPECT_EQ(other.rowCount(), 3) << "what was restored is not new";
}

TEST_F(DrawingsModelTest, aDamagedStateIsTakenAsFarAsItGoes) {
  model.restoreState({{QStringLiteral("order"), QJsonArray{QStringLiteral("field/a"), 7, QStringLiteral(""),
                                                           QStringLiteral("field/a"), QJsonArray()}},
                      {QStringLiteral("hidden"), QStringLiteral("no list")}});
  EXPECT_EQ(model.shown(), QStringList(QStringLiteral("field/a")));
  model.restoreState({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(DrawingsModelTest, aDrawingIsShownByItsNameWithOrWithoutItsKind) {
  draw("red1/drawings/field/ball");
  draw("red1/drawings/robot/ball");
  EXPECT_TRUE(model.setShown(QStringLiteral("ball"), false));
  EXPECT_EQ(model.shown(), QStringList());
  EXPECT_TRUE(model.setShown(QStringLiteral("robot/ball"), true));
  EXPECT_EQ(model.shown(), QStringList(QStringLiteral("robot/ball")));
  EXPECT_FALSE(model.setShown(QStringLiteral("goal"), true));
}

TEST_F(DrawingsModelTest, allAreShownOrHiddenWithoutSwitchingKeys) {
  setKey("path", robotcontrol::KeyMode::OFF);
  draw("red1/drawings/field/ball");
  model.setAllShown(false);
  EXPECT_EQ(model.shown(), QStringList());
  model.setAllShown(true);
  EXPECT_EQ(model.shown().size(), 2);
  EXPECT_FALSE(isChecked(0)) << "its key is still off";
  EXPECT_TRUE(requests.empty());
}

TEST_F(DrawingsModelTest, streamsAreListedIfTheViewCanShowThem) {
  model.listStreams([](const std::string& path, const std::string&) { return path.ends_with("/scan"); });
  draw("red1/scan");
  draw("red1/cloud");
  ASSERT_EQ(model.shown(), QStringList(QStringLiteral("stream/red1/scan")));
  EXPECT_EQ(tip(0), "stream/red1/scan\nThe messages of this stream, in the frame that they name");
}

TEST_F(DrawingsModelTest, withoutARobotNoKeyIsSwitched) {
  draw("red1/drawings/field/ball");
  refresh("");
  model.switchKey(0, true);
  model.switchKey(7, true);
  model.switchKey(-1, true);
  EXPECT_TRUE(requests.empty());
}

}  // namespace
}  // namespace widgets::test
