// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/StatusLine.h"

#include <QLabel>
#include <QStatusBar>
#include <future>

#include "app/core/Workbench.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/app/open/FakeFeed.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/Bench.h"

namespace app::test {
namespace {

using robotcontrol::LinkStatus;
using robotcontrol::SimulationStatus;
using std::chrono::milliseconds;

/// A status bar and what is published to it.
struct ShownStatus {
  explicit ShownStatus(const std::filesystem::path& home) : workbench(home), line(workbench, bar) {}
  template <typename T>
  void publish(const std::string& path, const T& message, milliseconds time = milliseconds(1000)) {
    workbench.session().push({path, robotlink::Instant(time), std::make_shared<const T>(message)});
    workbench.session().tick();
  }
  /// Opens the real robot p3at1.
  void openRobot(const robotlink::RobotDescription& description) {
    LoadedPlatform loaded = fakePlatform("tcp://robot:8101");
    loaded.robots = {{"p3at1", std::make_shared<const robotlink::RobotDescription>(description)}};
    workbench.open(fakeOpening(loaded, std::make_shared<FeedNotes>()));
    QTRY_VERIFY((workbench.tick(), workbench.loaded() != nullptr));
  }
  QString text(const char* label) {
    line.refresh();
    return widgets::test::child<QLabel>(bar, label).text();
  }
  QString state() { return text("statusState"); }

  Workbench workbench;
  QStatusBar bar;
  StatusLine line;
};

SimulationStatus simulationStatus(bool isRunning) {
  SimulationStatus status;
  status.set_running(isRunning);
  status.set_time(12.3456);
  status.set_speed(0.96);
  status.add_robots("p3at1");
  return status;
}

LinkStatus linkStatus(LinkStatus::State state) {
  LinkStatus status;
  status.set_state(state);
  return status;
}

}  // namespace

class StatusLineTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void withoutAnythingNothingIsOpen() {
    ShownStatus shown(home_);
    QCOMPARE(shown.state(), QStringLiteral("nothing is open"));
    for (const char* label : {"statusTime", "statusSpeed", "statusContacts"})
      QCOMPARE(shown.text(label), QString());
    QCOMPARE(shown.text("statusDropped"), QStringLiteral("0 dropped"));
  }

  void aSimulationHasItsTimeAndSpeed() {
    ShownStatus shown(home_);
    shown.publish("simulation", simulationStatus(true));
    QCOMPARE(shown.state(), QStringLiteral("running"));
    QCOMPARE(shown.text("statusTime"), QStringLiteral("12.346 s"));
    QCOMPARE(shown.text("statusSpeed"), QStringLiteral("sim 1.0×"));
    QCOMPARE(shown.text("statusContacts"), QString());
    shown.publish("simulation", simulationStatus(false));
    QCOMPARE(shown.state(), QStringLiteral("paused"));
  }

  void stopIsSaidWhateverElseGoesOn() {
    ShownStatus shown(home_);
    SimulationStatus status = simulationStatus(true);
    status.add_stopped_robots("p3at1");
    shown.publish("simulation", status);
    QCOMPARE(shown.state(), QStringLiteral("STOP engaged"));
  }

  void contactsAreCountedWhereThereIsABall() {
    ShownStatus shown(home_);
    SimulationStatus status = simulationStatus(true);
    status.set_ball_contacts(1);
    shown.publish("simulation", status);
    QCOMPARE(shown.text("statusContacts"), QString());
    status.add_models("ball");
    shown.publish("simulation", status);
    QCOMPARE(shown.text("statusContacts"), QStringLiteral("1 ball contact"));
    status.set_ball_contacts(2);
    shown.publish("simulation", status);
    QCOMPARE(shown.text("statusContacts"), QStringLiteral("2 ball contacts"));
  }

  void aRealRobotIsAsItsLineIs() {
    ShownStatus shown(home_);
    SimulationStatus status = simulationStatus(true);
    status.set_is_real(true);
    shown.publish("simulation", status);
    QCOMPARE(shown.state(), QStringLiteral("not connected"));
    QCOMPARE(shown.text("statusSpeed"), QStringLiteral("real time"));
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::CONNECTED));
    QCOMPARE(shown.state(), QStringLiteral("running"));  // It may have no base that sends.
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::LOST));
    QCOMPARE(shown.state(), QStringLiteral("not connected"));
  }

  void aRobotOnWheelsRunsOnceItsBaseWasHeard() {
    ShownStatus shown(home_);
    robotlink::RobotDescription wheels;
    wheels.drive = robotlink::RobotDescription::Drive();
    shown.openRobot(wheels);
    SimulationStatus status = simulationStatus(true);
    status.set_is_real(true);
    shown.publish("simulation", status);
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::CONNECTING));
    QCOMPARE(shown.state(), QStringLiteral("connecting"));
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::CONNECTED));
    QCOMPARE(shown.state(), QStringLiteral("connected"));
    shown.publish("p3at1/drive/state", robotcontrol::DriveState());
    QCOMPARE(shown.state(), QStringLiteral("running"));
  }

  void aRobotOnLegsRunsOnceItIsConnected() {
    ShownStatus shown(home_);
    robotlink::RobotDescription legs;
    legs.joints.emplace_back();
    shown.openRobot(legs);
    SimulationStatus status = simulationStatus(true);
    status.set_is_real(true);
    shown.publish("simulation", status);
    QCOMPARE(shown.state(), QStringLiteral("not connected"));
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::CONNECTED));
    QCOMPARE(shown.state(), QStringLiteral("running"));
  }

  void aCameraRunsWithoutALine() {
    ShownStatus shown(home_);
    robotlink::RobotDescription camera;
    camera.camera = robotlink::RobotDescription::Camera();
    shown.openRobot(camera);
    SimulationStatus status = simulationStatus(true);
    status.set_is_real(true);
    shown.publish("simulation", status);
    QCOMPARE(shown.state(), QStringLiteral("running"));
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::LOST));  // one that is offered elsewhere
    QCOMPARE(shown.state(), QStringLiteral("not connected"));
  }

  void aRobotThatIsNotHeardIsSilentLostOrBeingConnected() {
    ShownStatus shown(home_);
    SimulationStatus status = simulationStatus(true);
    status.set_is_real(true);
    shown.publish("simulation", status);
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::CONNECTED));
    shown.publish("p3at1/drive/state", robotcontrol::DriveState());
    shown.publish("simulation", status, milliseconds(2400));
    QCOMPARE(shown.state(), QStringLiteral("running"));
    shown.publish("simulation", status, milliseconds(5000));
    QCOMPARE(shown.state(), QStringLiteral("silent, last heard 4 s ago"));
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::LOST), milliseconds(5000));
    QCOMPARE(shown.state(), QStringLiteral("lost, last heard 4 s ago"));
    shown.publish("p3at1/link/status", linkStatus(LinkStatus::CONNECTING), milliseconds(6000));
    QCOMPARE(shown.state(), QStringLiteral("connecting, last heard 5 s ago"));
  }

  void whatCameOverALineThatIsLostIsNotCalledRunning() {
    ShownStatus shown(home_);
    shown.publish("simulation", simulationStatus(true));
    shown.workbench.session().setRemoteRobots({{"p3at1", {.url = "ws://robot:8765", .isConnected = false}}});
    QCOMPARE(shown.state(), QStringLiteral("not connected"));
    QCOMPARE(shown.text("statusSpeed"), QString());
    shown.workbench.session().setRemoteRobots({{"p3at1", {.url = "ws://robot:8765", .isConnected = true}}});
    QCOMPARE(shown.state(), QStringLiteral("running"));
  }

  void aRobotElsewhereThatSaysNothingIsConnected() {
    ShownStatus shown(home_);
    shown.workbench.session().setRemoteRobots({{"p3at1", {.url = "ws://robot:8765", .isConnected = true}}});
    QCOMPARE(shown.state(), QStringLiteral("connected"));
  }

  void aLogHasItsFrameAndSpeed() {
    ShownStatus shown(home_);
    shown.workbench.session().timeline().setOrigin(robotlink::Instant(milliseconds(10'000)));
    robotcontrol::ReplayStatus status;
    status.set_time(10'250'000'000);
    status.set_frame(309);
    status.set_speed(0.05);
    shown.publish("simulation", simulationStatus(true));
    shown.publish("replay", status);
    QCOMPARE(shown.state(), QStringLiteral("paused"));
    QCOMPARE(shown.text("statusTime"), QStringLiteral("0.250 s  frame 309"));
    QCOMPARE(shown.text("statusSpeed"), QStringLiteral("log 0.05×"));
    QCOMPARE(shown.text("statusContacts"), QString());
    status.set_playing(true);
    shown.publish("replay", status);
    QCOMPARE(shown.state(), QStringLiteral("playing"));
  }

  void whileSomethingIsOpenedThatIsWhatIsSaid() {
    ShownStatus shown(home_);
    std::promise<void> mayGoOn;
    PlatformOpening opening = failingOpening("", "");
    opening.make = [going = mayGoOn.get_future().share()](const PlatformContext&) {
      going.wait();
      return PlatformOpening::Made(tl::unexpected(robotlink::Errors{{"none", "not opened", {}, {}}}));
    };
    shown.workbench.open(std::move(opening));
    QCOMPARE(shown.state(), QStringLiteral("loading…"));
    shown.publish("simulation", simulationStatus(true));
    QCOMPARE(shown.state(), QStringLiteral("loading…"));
    mayGoOn.set_value();
    QTRY_VERIFY((shown.workbench.tick(), !shown.workbench.loading()));
    QCOMPARE(shown.state(), QStringLiteral("running"));
  }
};

const widgets::test::GuiTest<StatusLineTest> kStatusLineTest;

}  // namespace app::test

#include "StatusLineTest.moc"
