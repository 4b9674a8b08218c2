// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/overview/RobotsView.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QListView>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/Bench.h"
#include "widgets/PackageSubscription.h"
#include "widgets/overview/RobotCardDelegate.h"

namespace widgets::test {

using robotcontrol::KeyMode;

namespace {

robotcontrol::KeyTable cameraKey(KeyMode::Kind kind, unsigned everyMs = 0) {
  robotcontrol::KeyTable table;
  auto& key = *table.add_keys();
  key.set_name("package/camera/image");
  key.mutable_mode()->set_kind(kind);
  key.mutable_mode()->set_n(everyMs);
  return table;
}

foxglove::RawImage cameraPicture(robotlink::Rgb color) {
  robotlink::Image image(40, 30, robotlink::PixelFormat::kRgb8);
  for (std::size_t i = 0; i < image.data.size(); i += 3) {
    image.data[i] = color.r;
    image.data[i + 1] = color.g;
    image.data[i + 2] = color.b;
  }
  foxglove::RawImage message;
  robotlink::assign(message, image.view(), robotlink::Instant(), "camera");
  return message;
}

/// Robots of a simulation that runs; red1 is selected.
struct Team : Bench {
  std::unique_ptr<RobotsView> view;
  QListView* list = nullptr;

  explicit Team(std::vector<std::string> names = {"red1", "red2", "blue1"}, QSize size = {900, 400})
      : Bench(Options{.robots = names, .field = true}) {
    robotcontrol::SimulationStatus status;
    status.set_running(true);
    for (const std::string& name : names) {
      status.add_robots(name);
      frame(name, 1);
    }
    push("simulation", status, 1);
    view = open<RobotsView>(size);
    list = &child<QListView>(*view, "robotsList");
  }
  void frame(const std::string& robot, double time) {
    robotcontrol::FrameInfo info;
    info.set_process("cognition");
    push(robot + "/frames/cognition", info, time);
  }
  QString text(int row) const { return list->model()->index(row, 0).data(Qt::AccessibleTextRole).toString(); }
  QPoint middle(int row) const { return list->visualRect(list->model()->index(row, 0)).center(); }
  QImage grab() { return list->viewport()->grab().toImage(); }
};

}  // namespace

class RobotsViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCardForEachRobotSaysWhatItDoesAndAClickSelectsIt() {
    Team team;
    QAbstractItemModelTester tester(team.list->model(),
                                    QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(team.list->model()->rowCount(), 3);
    QVERIFY(team.text(0).contains(QStringLiteral("running")));
    QVERIFY(team.text(0).contains(QStringLiteral("simulated here")));
    QTest::mouseClick(team.list->viewport(), Qt::LeftButton, {}, team.middle(2));
    QCOMPARE(team.session.selectedRobot(), std::string("blue1"));
  }

  void arrowKeysSelectAndTheCardFollowsTheSelectionElsewhere() {
    Team team;
    team.list->setFocus();
    QTest::keyClick(team.list, Qt::Key_Right);
    QCOMPARE(team.session.selectedRobot(), std::string("red2"));
    team.session.selectRobot("blue1");
    team.tick(*team.view);
    QCOMPARE(team.list->currentIndex().row(), 2);
    QTest::keyClick(team.list, Qt::Key_Left);
    QCOMPARE(team.session.selectedRobot(), std::string("red2"));
  }

  void imagesArePublishedTwiceASecondOnlyWhileTheViewIsSeen() {
    Team team({"red1"});
    team.push("red1/tables/keys", cameraKey(KeyMode::OFF), 1);
    team.tick(*team.view);
    QCOMPARE(team.requests.size(), std::size_t{1});
    QCOMPARE(team.requests[0].set_key().name(), std::string("package/camera/image"));
    QCOMPARE(team.requests[0].set_key().mode().kind(), KeyMode::EVERY_MS);
    QCOMPARE(team.requests[0].set_key().mode().n(), kGlanceMs);
    team.push("red1/tables/keys", cameraKey(KeyMode::EVERY_MS, kGlanceMs), 1.1);
    team.tick(*team.view);
    team.view->hide();
    QCOMPARE(team.requests.size(), std::size_t{2});
    QCOMPARE(team.requests[1].set_key().mode().kind(), KeyMode::OFF);
  }

  void whoWantsImagesMoreOftenGetsThem() {
    Team team({"red1"});
    team.push("red1/tables/keys", cameraKey(KeyMode::OFF), 1);
    team.tick(*team.view);
    team.push("red1/tables/keys", cameraKey(KeyMode::EVERY_MS, kGlanceMs), 1.1);
    team.session.tick();
    // Another view shows them all.
    PackageSubscription other;
    other.want(team.session, "red1", {"camera/image"});
    QCOMPARE(team.requests.back().set_key().mode().kind(), KeyMode::ALWAYS);
    team.push("red1/tables/keys", cameraKey(KeyMode::ALWAYS), 1.2);
    team.session.tick();
    const std::size_t before = team.requests.size();
    team.view->hide();
    QCOMPARE(team.requests.size(), before);
  }

  void theImageOfTheCameraIsOnTheCard() {
    Team team({"red1", "red2"});
    team.push("red1/camera/image", cameraPicture({250, 120, 10}), 1);
    team.tick(*team.view);
    QVERIFY(countNear(team.grab(), QColor(250, 120, 10)) > 2000);
    QVERIFY(team.list->model()->index(1, 0).isValid());
    keepPicture(*team.view, "robots");
  }

  void aRobotThatStandsSaysWhy() {
    Team team;
    robotcontrol::SimulationStatus status;
    for (const char* name : {"red1", "red2", "blue1"}) status.add_robots(name);
    status.add_stopped_robots("red2");
    team.push("simulation", status, 2);
    robotcontrol::HostingStatus hosting;
    hosting.set_state(robotcontrol::HostingStatus::ENDED);
    hosting.set_text("It crashed in task motion. Start it again in the view Processes.");
    team.push("red1/hosting", hosting, 2);
    team.tick(*team.view);
    QVERIFY(team.text(0).contains(QStringLiteral("program ended: It crashed in task motion")));
    QVERIFY(team.text(1).contains(QStringLiteral("STOP is engaged")));
    QVERIFY(team.text(2).contains(QStringLiteral("paused")));
  }

  void aRobotElsewhereSaysHowItIsConnected() {
    Team team;
    team.push("simulation", robotcontrol::SimulationStatus(), 1);
    team.session.setRemoteRobots({{"red1", {"ws://hall:1", true, "connected, 12 ms"}},
                                  {"red2", {"ws://hall:2", false, "silent for 3 s: the line is cut"}},
                                  {"blue1", {"ws://hall:3", false, "refused: it wants another token"}}});
    team.tick(*team.view);
    QVERIFY(team.text(0).contains(QStringLiteral("ws://hall:1: connected, 12 ms")));
    QVERIFY(team.text(1).contains(QStringLiteral("not connected")));
    QVERIFY(team.text(1).contains(QStringLiteral("silent for 3 s")));
    QVERIFY(team.text(2).contains(QStringLiteral("refused: it wants another token")));
  }

  void aLowBatteryIsReported() {
    Team team({"p3at1"});
    robotcontrol::DriveState drive;
    drive.set_battery(11.2);
    drive.set_state_of_charge(0.1);
    team.push("p3at1/drive/state", drive, 1);
    team.tick(*team.view);
    QVERIFY(team.text(0).contains(QStringLiteral("battery: 11.2 V, 10 %")));
    QVERIFY(team.text(0).contains(QStringLiteral("The battery is low")));
  }

  void eightRobotsFitIntoASmallView() {
    std::vector<std::string> names;
    for (int i = 1; i <= 8; ++i) names.push_back((i % 2 == 0 ? "red" : "blue") + std::to_string(i));
    Team team(names, {1000, 560});
    for (int row = 0; row < 8; ++row)
      QVERIFY(
          team.list->viewport()->rect().contains(team.list->visualRect(team.list->model()->index(row, 0))));
    keepPicture(*team.view, "robots-eight");
    team.view->resize(360, 260);
    team.tick(*team.view);
    QVERIFY(team.list->visualRect(team.list->model()->index(0, 0)).width() <= 360);
  }

  void cardsBecomeAsLargeAsTheRoomAllows() {
    const QFontMetrics font = QApplication::fontMetrics();
    const QSize one = RobotCardDelegate::sizeFor(1, {1200, 800}, font);
    const QSize four = RobotCardDelegate::sizeFor(4, {1200, 800}, font);
    QVERIFY(one.width() > 500);
    QVERIFY(four.width() <= 600 && four.height() <= 400);
    QVERIFY(RobotCardDelegate::sizeFor(8, {200, 100}, font).width() > 100);
  }

  void aLogOfAnotherProgramHasNoRobotOfOurs() {
    Team team(std::vector<std::string>{});
    team.push("/rosout", foxglove::Log(), 1);
    team.tick(*team.view);
    QVERIFY(
        child<QLabel>(*team.view, "emptyHint").text().contains(QStringLiteral("no description of this log")));
  }

  void withoutRobotsItSaysWhatToDo() {
    Team team(std::vector<std::string>{});
    QVERIFY(child<QLabel>(*team.view, "emptyHint").text().contains(QStringLiteral("Start a simulation")));
  }
};

const GuiTest<RobotsViewTest> kRobotsViewTest;

}  // namespace widgets::test

#include "RobotsViewTest.moc"
