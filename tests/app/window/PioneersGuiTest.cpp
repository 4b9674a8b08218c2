// SPDX-License-Identifier: GPL-3.0-or-later
// Pioneers in the workbench: set up as a person does, connected over TCP, stopped, and driven by a program
// outside.
#include <qtadvanceddocking/DockWidget.h>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/arcos/PioneerRobot.h"
#include "tests/app/served/ServedWorld.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/DialogAnswer.h"

namespace app::test {
namespace {

/// A port that nobody listens at; the next one is most likely free as well.
int freePort() {
  const auto ports = robotlink::arcos::RobotPorts::open({.firstPort = 0, .robots = 1});
  if (!ports) qFatal("no port is free");
  return (*ports)->port(0);
}

void showPackage(Desk& desk, const char* package) {
  robotcontrol::Request request;
  request.set_robot("p3at1");
  request.mutable_set_key()->set_name(std::string("package/") + package);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  desk.workbench.session().request(std::move(request));
}

template <typename T>
const T* newest(Desk& desk, const std::string& stream) {
  auto& session = desk.workbench.session();
  return session.store().latestAs<T>(stream, session.timeline().newest());
}

}  // namespace

class PioneersGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aWorldIsSetUpWithRobotsThatProgramsOutsideCanDrive() {
    const int port = freePort();
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    DialogAnswer setUp([port](QDialog& dialog) {
      dialog.findChild<QComboBox*>(QStringLiteral("setupScene"))->setEditText(QStringLiteral("pioneer"));
      dialog.findChild<QSpinBox*>(QStringLiteral("setupRobots"))->setValue(1);
      QTest::mouseClick(dialog.findChild<QCheckBox*>(QStringLiteral("setupKinematic")), Qt::LeftButton);
      QTest::mouseClick(dialog.findChild<QCheckBox*>(QStringLiteral("setupPortOn")), Qt::LeftButton);
      dialog.findChild<QSpinBox*>(QStringLiteral("setupPort"))->setValue(port);
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    desk.choose("file.simulate");
    QVERIFY(setUp.asked());
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").count(), 2, kWaitMs);
    showPackage(desk, "link/status");
    desk.click("simulation.start");
    robotlink::arcos::PioneerRobot robot("tcp://127.0.0.1:" + std::to_string(port));
    std::thread client([&] {
      if (!robot.begin()) qFatal("the robot cannot be reached");
    });
    QTRY_VERIFY_WITH_TIMEOUT(
        newest<robotcontrol::LinkStatus>(desk, "p3at1/link/status") != nullptr &&
            !newest<robotcontrol::LinkStatus>(desk, "p3at1/link/status")->client().empty(),
        kWaitMs);
    client.join();
    // The same once more, at the same ports; what was chosen is there again.
    QVERIFY(desk.workbench.commands().run("simulation.setup",
                                          {std::string("pioneer"), std::string("p3at"), 2.0, true,
                                           static_cast<double>(port), false, std::string("both")}));
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").count(), 3, kWaitMs);
    DialogAnswer again([port](QDialog& dialog) {
      QCOMPARE(dialog.findChild<QComboBox*>(QStringLiteral("setupScene"))->currentText(),
               QStringLiteral("pioneer"));
      QCOMPARE(dialog.findChild<QSpinBox*>(QStringLiteral("setupPort"))->value(), port);
      DialogAnswer::press(dialog, QDialogButtonBox::RejectRole);
    });
    desk.choose("file.simulate");
    QVERIFY(again.asked());
  }

  void ersRobotsOfTwoTeamsAreAddedToAField() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    DialogAnswer setUp([](QDialog& dialog) {
      auto* kind = dialog.findChild<QComboBox*>(QStringLiteral("setupKind"));
      auto* teams = dialog.findChild<QComboBox*>(QStringLiteral("setupTeams"));
      dialog.findChild<QSpinBox*>(QStringLiteral("setupRobots"))->setValue(3);
      dialog.findChild<QComboBox*>(QStringLiteral("setupScene"))->setEditText(QStringLiteral("pioneer"));
      QCOMPARE(kind->currentText(), QStringLiteral("Pioneer 3-AT"));
      QVERIFY(!teams->isEnabled());
      dialog.findChild<QComboBox*>(QStringLiteral("setupScene"))->setEditText(QStringLiteral("field2002"));
      QCOMPARE(kind->currentText(), QStringLiteral("Sony Aibo ERS-210"));  // more of those that the scene has
      QVERIFY(teams->isEnabled());
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    desk.choose("file.simulate");
    QVERIFY(setUp.asked());
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").count(), 4, kWaitMs);
    QCOMPARE(desk.workbench.session().robots(), (std::vector<std::string>{"blue1", "blue2", "red1", "red2"}));
  }

  void aViewIsBroughtToTheFrontByACommand() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(desk.workbench.commands().run("view.show", {std::string("packets")}));
    const auto packets = desk.window.docks().docks(QStringLiteral("packets"));
    QCOMPARE(packets.size(), std::size_t{1});
    QVERIFY(desk.workbench.commands().run("view.show", {std::string("packets")}));
    QCOMPARE(desk.window.docks().docks(QStringLiteral("packets")), packets);
    QVERIFY(packets.front()->isCurrentTab());
    QCOMPARE(desk.workbench.commands().run("view.show", {std::string("parrot")}).error().id,
             std::string("view.unknown"));
  }

  void aRobotAtTheEndOfALineIsARobotLikeTheOthers() {
    ServedWorld world;
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.window.showPerspective(QStringLiteral("Drive"));
    desk.choose("robot.connect");
    auto* address = desk.find<QComboBox>("connectAddress").lineEdit();
    address->setFocus();
    address->selectAll();
    QTest::keyClicks(address, QString::fromStdString(world.url()));
    QTest::mouseClick(&desk.find<QPushButton>("connectButton"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").currentText(), QStringLiteral("p3at1"),
                              kWaitMs);
    QVERIFY(desk.window.windowTitle().contains(QString::fromStdString(world.url())));
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QDialog>("connectDialog").isVisible(), kWaitMs);  // the robot answers
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QLabel>("linkState").text(), QStringLiteral("connected"), kWaitMs);
    const auto state = [&] { return newest<robotcontrol::DriveState>(desk, "p3at1/drive/state"); };
    QTRY_VERIFY_WITH_TIMEOUT(state() != nullptr, kWaitMs);
    QVERIFY(!desk.find<QAction>("simulation.pause").isVisible());  // its time cannot be stopped
    QVERIFY(!state()->motors_on());                                // a real robot waits for a person
    click(desk.find<QToolButton>("baseMotors"));
    QTRY_VERIFY_WITH_TIMEOUT(state()->motors_on(), kWaitMs);
    QTest::mouseClick(&desk.find<QToolButton>("stopButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!state()->motors_on(), kWaitMs);
    // All of it went over the line as packets.
    desk.window.docks().open(QStringLiteral("packets"));
    const auto* packets = desk.find<QTableView>("packetsTable").model();
    QTRY_VERIFY_WITH_TIMEOUT(packets->rowCount() > 20, kWaitMs);
  }
};

const widgets::test::GuiTest<PioneersGuiTest> kPioneersGuiTest;

}  // namespace app::test

#include "PioneersGuiTest.moc"
