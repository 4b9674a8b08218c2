// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/BaseStateView.h"

#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include "tests/widgets/FieldBench.h"
#include "tests/widgets/drive/DriveBench.h"
#include "widgets/Theme.h"
#include "widgets/drive/BatteryGauge.h"

namespace widgets::test {
namespace {

robotcontrol::LinkStatus connected() {
  robotcontrol::LinkStatus status;
  status.set_state(robotcontrol::LinkStatus::CONNECTED);
  status.set_address("tcp://localhost:8101");
  status.set_robot_name("MobileSim");
  status.set_robot_class("Pioneer");
  status.set_robot_subclass("p3at-sh");
  status.set_packets_per_second(70.2);
  status.set_bytes_per_second(10'720);
  status.set_packets(4210);
  status.set_round_trip(0.0042);
  status.set_longest_gap(0.104);
  return status;
}

QString text(QWidget& view, const char* name) {
  return child<QLabel>(view, name).text();
}

}  // namespace

class BaseStateViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aBatteryIsLowBelowTheVoltageOfItsDescription() {
    const robotlink::RobotDescription::Battery lead{11, 11.5, 13};
    QVERIFY(BatteryLevel::of(12.6, {}, false, lead).state == BatteryLevel::State::kGood);
    QVERIFY(BatteryLevel::of(11.4, {}, false, lead).state == BatteryLevel::State::kLow);
    QVERIFY(BatteryLevel::of(10.9, {}, false, lead).state == BatteryLevel::State::kEmpty);
    QVERIFY(BatteryLevel::of(12.6, 0.1, false, lead).state == BatteryLevel::State::kLow);
    QVERIFY(BatteryLevel::of(0, {}, false, lead).state == BatteryLevel::State::kUnknown);
    QCOMPARE(BatteryLevel::of(12, {}, false, lead).share.value_or(-1), 0.5);
    QVERIFY(BatteryLevel::of(11.4, {}, false, lead).warning().contains(QStringLiteral("low")));
    QVERIFY(BatteryLevel::of(11.4, {}, true, lead).warning().isEmpty());
  }

  void voltsOfARobotWhoseDescriptionSaysNothingOfThemMeanNothing() {
    const BatteryLevel level = BatteryLevel::of(7.4, {}, false, {});
    QVERIFY(level.state == BatteryLevel::State::kGood);
    QCOMPARE(level.text(), QStringLiteral("7.4 V"));
    QVERIFY(level.warning().isEmpty());
    QVERIFY(BatteryLevel::of(7.4, 0.1, false, {}).state == BatteryLevel::State::kLow);
  }

  void whatTheRobotSaysAboutItsBatteryCountsMoreThanItsDescription() {
    DriveBench world;
    auto state = DriveBench::state();
    state.set_battery(11.6);  // low below 11.5 by the description
    world.push("p3at1/drive/state", state, 1);
    auto view = world.open<widgets::BaseStateView>();
    const auto& battery = child<widgets::BatteryGauge>(*view, "baseBattery");
    QVERIFY(battery.level().state == BatteryLevel::State::kGood);
    state.set_battery_low(11.8);
    world.push("p3at1/drive/state", state, 2);
    world.tick(*view);
    QVERIFY(battery.level().state == BatteryLevel::State::kLow);
    state.set_battery_empty(11.7);
    world.push("p3at1/drive/state", state, 3);
    world.tick(*view);
    QVERIFY(battery.level().state == BatteryLevel::State::kEmpty);
  }

  void theStateIsShown() {
    DriveBench world;
    auto state = DriveBench::state();
    robotlink::assign(*state.mutable_odometry(), {1.25, -0.5, robotlink::kPi / 2});
    state.mutable_velocity()->set_x(0.3);
    state.set_left_speed(0.29);
    state.set_right_speed(0.31);
    state.set_temperature(31);
    state.set_rear_bumpers(1, true);
    state.set_left_stalled(true);
    world.push("p3at1/drive/state", state, 1);
    robotcontrol::DriveRequest request;
    request.mutable_velocity()->set_x(0.5);
    world.push("p3at1/drive/request", request, 1);
    auto view = world.open<widgets::BaseStateView>();
    QCOMPARE(text(*view, "baseMotorsState"), QStringLiteral("on"));
    QCOMPARE(text(*view, "baseStall"), QStringLiteral("left is stalled"));
    QCOMPARE(text(*view, "baseBumpers"), QStringLiteral("pressed: rear 2"));
    QCOMPARE(text(*view, "baseOdometry"), QStringLiteral("1.250 m, -0.500 m, 90.0°"));
    QCOMPARE(text(*view, "baseReal"), QStringLiteral("300 mm/s, 0.0°/s"));
    QCOMPARE(text(*view, "baseAsked"), QStringLiteral("500 mm/s, 0.0°/s"));
    QCOMPARE(text(*view, "baseWheels"), QStringLiteral("left 290, right 310 mm/s"));
    QCOMPARE(text(*view, "baseTemperature"), QStringLiteral("31 °C"));
    QCOMPARE(text(*view, "baseEmergency"), QStringLiteral("released"));
    QVERIFY(child<widgets::BatteryGauge>(*view, "baseBattery").level().state == BatteryLevel::State::kGood);
    robotcontrol::SimulationStatus simulation;
    simulation.add_stopped_robots("p3at1");
    world.push("simulation", simulation, 2);
    world.tick(*view);
    QVERIFY(text(*view, "baseEmergency").startsWith(QStringLiteral("STOP")));
  }

  void motorsAndSonarsAreSwitchedAtTheBase() {
    DriveBench world;
    world.push("p3at1/drive/state", DriveBench::state(), 1);
    auto view = world.open<widgets::BaseStateView>();
    auto& motors = child<QToolButton>(*view, "baseMotors");
    QVERIFY(motors.isChecked());
    click(motors);
    const auto asked = world.requests.back();
    QCOMPARE(asked.robot(), std::string("p3at1"));
    QVERIFY(asked.control_drive().has_motors() && !asked.control_drive().motors());
    QVERIFY(motors.isChecked());  // until the base says otherwise
    world.answer(asked, false, "the line is lost");
    world.tick(*view);
    QCOMPARE(text(*view, "baseProblem"), QStringLiteral("Refused: the line is lost"));
    auto state = DriveBench::state();
    state.set_motors_on(false);
    world.push("p3at1/drive/state", state, 2);
    world.tick(*view);
    QVERIFY(!motors.isChecked());
    click(child<QToolButton>(*view, "baseSonar"));
    QVERIFY(world.requests.back().control_drive().has_sonar() &&
            !world.requests.back().control_drive().sonar());
    click(child<QToolButton>(*view, "baseResetOdometry"));
    QVERIFY(world.requests.back().control_drive().reset_odometry());
  }

  void theLineIsDescribedInWords() {
    DriveBench world;
    auto status = connected();
    world.push("p3at1/link/status", status, 1);
    auto view = world.open<widgets::BaseStateView>();
    QCOMPARE(text(*view, "linkState"), QStringLiteral("connected"));
    QCOMPARE(text(*view, "linkRobot"), QStringLiteral("MobileSim, Pioneer, p3at-sh"));
    QCOMPARE(text(*view, "linkPackets"), QStringLiteral("70.2/s, 10.7 kB/s; 4210 in all"));
    QCOMPARE(text(*view, "linkErrors"), QStringLiteral("none"));
    QCOMPARE(text(*view, "linkRoundTrip"), QStringLiteral("4.2 ms"));
    QCOMPARE(text(*view, "linkGap"), QStringLiteral("104 ms"));
    status.set_state(robotcontrol::LinkStatus::LOST);
    status.set_checksum_errors(3);
    status.set_longest_gap(0.4);
    status.set_text("nothing was heard for 8 s; it is tried again in 2 s");
    world.push("p3at1/link/status", status, 2);
    world.tick(*view);
    QCOMPARE(text(*view, "linkState"), QStringLiteral("lost"));
    QCOMPARE(text(*view, "linkErrors"), QStringLiteral("3 checksums, 0 bytes lost"));
    QVERIFY(text(*view, "linkText").contains(QStringLiteral("tried again")));
    world.push("p3at1/drive/state", DriveBench::state(), 9);
    world.tick(*view);
    QCOMPARE(text(*view, "linkState"), QStringLiteral("lost; nothing new for 7 s"));
  }

  void whatTheBaseSaidTooLongAgoIsGrayWithItsAge() {
    DriveBench world;
    auto state = DriveBench::state();
    state.set_left_stalled(true);
    world.push("p3at1/drive/state", state, 1);
    world.push("p3at1/link/status", connected(), 1);
    auto view = world.open<widgets::BaseStateView>();
    auto& stall = child<QLabel>(*view, "baseStall");
    const QColor fresh = stall.palette().color(QPalette::WindowText);
    QVERIFY(child<QLabel>(*view, "baseAge").text().isEmpty());
    auto status = connected();
    status.set_state(robotcontrol::LinkStatus::LOST);
    world.push("p3at1/link/status", status, 8);
    world.tick(*view);
    const QColor muted = widgets::colorOf(widgets::Meaning::kMuted, view->palette());
    QVERIFY(fresh != muted);
    QCOMPARE(stall.palette().color(QPalette::WindowText), muted);
    QCOMPARE(child<QLabel>(*view, "baseMotorsState").palette().color(QPalette::WindowText), muted);
    QCOMPARE(child<QLabel>(*view, "baseOdometry").palette().color(QPalette::WindowText), muted);
    QCOMPARE(text(*view, "baseAge"),
             QStringLiteral("The base has been silent for 7 s: this is its last state."));
    const auto& battery = child<widgets::BatteryGauge>(*view, "baseBattery");
    QVERIFY(battery.level().text().endsWith(QStringLiteral("7 s ago")));
    QImage picture(200, 20, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    widgets::BatteryGauge::paint(painter, picture.rect(), battery.level(), view->palette());
    QCOMPARE(picture.pixelColor(8, 10).rgb(), muted.rgb());  // within the battery
    keepPicture(*view, "base-state-stale");
    // It is back.
    world.push("p3at1/drive/state", state, 9);
    world.tick(*view);
    QCOMPARE(stall.palette().color(QPalette::WindowText), fresh);
    QVERIFY(text(*view, "baseAge").isEmpty());
    QVERIFY(!battery.level().age);
  }

  void aLineThatIsLostIsTriedAtOnceWhenSomebodyWantsThat() {
    DriveBench world;
    int asked = 0;
    world.commands.add({"robot.connect-now", "", {}, [&](const auto&) -> robotlink::Result<void> {
                          ++asked;
                          return {};
                        }});
    auto status = connected();
    status.set_reconnects(1);
    world.push("p3at1/link/status", status, 1);
    auto view = world.open<widgets::BaseStateView>();
    auto& now = child<QPushButton>(*view, "linkConnectNow");
    QVERIFY(!now.isVisible());
    QCOMPARE(text(*view, "linkReconnects"), QStringLiteral("once"));
    status.set_state(robotcontrol::LinkStatus::LOST);
    status.set_reconnects(2);
    world.push("p3at1/link/status", status, 2);
    world.tick(*view);
    QVERIFY(now.isVisible());
    QCOMPARE(text(*view, "linkReconnects"), QStringLiteral("twice"));
    status.set_reconnects(3);
    world.push("p3at1/link/status", status, 2.1);
    world.tick(*view);
    QCOMPARE(text(*view, "linkReconnects"), QStringLiteral("3 times"));
    click(now);
    QCOMPARE(asked, 1);
  }

  void aRobotWithoutWheelsSaysSo() {
    DriveBench world;
    world.context.robots.erase("p3at1");
    auto view = world.open<widgets::BaseStateView>();
    QVERIFY(child<QLabel>(*view, "emptyHint").text().contains(QStringLiteral("p3at1 has no wheels")));
    QVERIFY(!child<QToolButton>(*view, "baseMotors").isEnabled());
  }

  void showsAWholePicture() {
    DriveBench world;
    auto state = DriveBench::state();
    state.set_battery(11.3);
    state.set_temperature(29);
    state.set_front_bumpers(2, true);
    robotlink::assign(*state.mutable_odometry(), {12.418, -3.077, 0.7});
    state.mutable_velocity()->set_x(0.312);
    world.push("p3at1/drive/state", state, 1);
    auto status = connected();
    status.set_checksum_errors(2);
    status.set_skipped_bytes(41);
    status.set_client("127.0.0.1:40712");
    status.set_commands_per_second(10.1);
    world.push("p3at1/link/status", status, 1);
    auto view = world.open<widgets::BaseStateView>({400, 560});
    keepPicture(*view, "base-state-view");
    QCOMPARE(text(*view, "baseBatteryWarning"), QStringLiteral("The battery is low: charge it soon."));
    QVERIFY(view->saveState().contains(QStringLiteral("robot")));
  }
};

const GuiTest<BaseStateViewTest> kBaseStateViewTest;

}  // namespace widgets::test

#include "BaseStateViewTest.moc"
