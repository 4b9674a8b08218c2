// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that run remotely in the workbench, and a session that is offered to others: what a
// person does, over a line of this machine that is cut and found again.
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <algorithm>

#include "colortool/table/ColorTableFile.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "tests/app/served/OfferedHall.h"
#include "tests/app/window/RemoteDesk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/logplayer/RecordedMessages.h"

namespace app::test {

using logplayer::tests::ReadLog;
using logplayer::tests::TestFolder;

class RemoteGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aRobotElsewhereIsARobotLikeTheOthers() {
    OfferedHall hall;
    RemoteDesk desk(home_);
    desk.join(hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QDialog>("remoteDialog").isVisible(), kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(desk.robot(), QStringLiteral("red1"), kWaitMs);
    QVERIFY(desk.window.windowTitle().contains(QStringLiteral("red1")));
    QVERIFY(desk.state().contains(QString::fromStdString(hall.url())));
    // What views show they get; a preset switches drawings on, as for other robots.
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest<foxglove::RawImage>("red1/camera/image") != nullptr, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(hall.drawsDisc(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.count("red1/drawings/image/ball-percept/disc") > 2, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.window.context().robots.count("red1") == 1, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.window.context().field != nullptr, kWaitMs);
    widgets::test::keepPicture(desk.window, "remote");
    // A key, a solution, a color table.
    desk.run("robot.key ball-percept/disc off");
    QTRY_VERIFY_WITH_TIMEOUT(!hall.drawsDisc(), kWaitMs);
    desk.run("robot.solution ball-percept circle-fit");
    QTRY_VERIFY_WITH_TIMEOUT(hall.fitsCircles(), kWaitMs);
    const auto file = home_ / "hall.c64";
    QVERIFY(colortool::ColorTableFile().save(file).has_value());
    desk.run("robot.color-table " + file.string());
    QTRY_VERIFY_WITH_TIMEOUT(hall.hasTable(), kWaitMs);
    // STOP is for all robots.
    QTest::mouseClick(&desk.find<QToolButton>("stopButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hall.isStopped(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QAction>("robot.stop").isChecked(), kWaitMs);
    // A robot that is disconnected leaves the window.
    desk.choose("remote.connect");
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTreeWidget>("remoteConnections").topLevelItemCount() == 1, kWaitMs);
    QTest::mouseClick(&desk.find<QPushButton>("remoteDisconnect"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").count(), 0, kWaitMs);
    QCOMPARE(desk.state(), QString());
  }

  void twoConnectionsHaveRoomForWhatCounts() {
    OfferedHall first, second;
    RemoteDesk desk(home_);
    desk.run("remote.connect " + first.url() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(desk.robot(), QStringLiteral("red1"), kWaitMs);
    desk.run("remote.connect " + second.url() + " ''");
    const auto hasRate = [&](const char* name) {
      auto* button = desk.window.findChild<QToolButton*>(QLatin1String(name));
      return button != nullptr && button->text().contains(QStringLiteral("B/s"));
    };
    QTRY_VERIFY_WITH_TIMEOUT(hasRate("statusRemote1") && hasRate("statusRemote2"), kWaitMs);
    QVERIFY(!desk.find<QToolButton>("statusRemote1").text().contains(QStringLiteral("connected")));
    QVERIFY(desk.state().contains(QStringLiteral("connected")));
    QTRY_VERIFY_WITH_TIMEOUT(desk.state().contains(QStringLiteral("waiting behind other data")), kWaitMs);
  }

  void whatIsBeingEnteredStaysWhileARobotConnects() {
    OfferedHall hall;
    RemoteDesk desk(home_);
    desk.choose("remote.connect");
    auto& urls = desk.find<QComboBox>("remoteUrl");
    auto* address = urls.lineEdit();
    address->setFocus();
    address->setText(QStringLiteral("ws://elsewhere"));
    address->setCursorPosition(5);
    QTest::keyClick(address, Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(address->selectedText(), QStringLiteral("/"));
    const int known = urls.count();
    desk.run("remote.connect " + hall.url() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(urls.count(), known + 1, kWaitMs);
    QCOMPARE(address->text(), QStringLiteral("ws://elsewhere"));
    QCOMPARE(address->selectedText(), QStringLiteral("/"));
    QCOMPARE(address->cursorPosition(), 4);
    QTest::keyClicks(address, QStringLiteral("x"));
    QCOMPARE(address->text(), QStringLiteral("ws:/xelsewhere"));
  }

  void withoutASimulationTheStatusBarKnowsThatSomethingIsConnected() {
    const auto server = robotlink::websocket::Server::make({.name = "bridge"}, {});
    robotlink::websocket::Listener::Options listening;
    listening.address.port = 0;
    const auto listener = *robotlink::websocket::Listener::open(server, listening);
    RemoteDesk desk(home_);
    const auto state = [&] { return desk.find<QLabel>("statusState").text(); };
    QTRY_COMPARE_WITH_TIMEOUT(state(), QStringLiteral("nothing is open"), kWaitMs);
    desk.run("remote.connect ws://127.0.0.1:" + std::to_string(listener->address().port) + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(state(), QStringLiteral("connected"), kWaitMs);
  }

  void aSceneThatIsOpenedLaterSharesNoNameWithARobotElsewhere() {
    OfferedHall hall;
    RemoteDesk desk(home_);
    desk.join(hall.url());
    QTRY_COMPARE_WITH_TIMEOUT(desk.robot(), QStringLiteral("red1"), kWaitMs);
    desk.run("simulation.open field2002");
    const std::vector<std::string> both{"red1", "red1-2"};
    QTRY_VERIFY_WITH_TIMEOUT(desk.workbench.session().robots() == both, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest<foxglove::RawImage>("red1-2/camera/image") != nullptr, kWaitMs);
    // STOP is for both.
    QTest::mouseClick(&desk.find<QToolButton>("stopButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hall.isStopped(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.status() != nullptr && std::ranges::count(desk.status()->stopped_robots(), "red1") > 0, kWaitMs);
  }

  void whatALineCarriesIsLimitedBeforeAndWhileItIsConnectedAndRemembered() {
    OfferedHall hall;
    {
      RemoteDesk desk(home_);
      limitAndConnect(desk, hall);
    }
    RemoteDesk desk(home_);
    desk.run("remote.connect " + hall.url() + " ''");
    const LinkLimits limits = desk.workbench.remote().connections().at(0).limits;
    QVERIFY((limits == LinkLimits{300e3, LinkLimits::Images::kPng, 5}));
    QVERIFY2(desk.workbench.remote().connections().at(0).text.ends_with(
                 ", at most 300 kB/s, images as PNG, 5 images a second"),
             desk.workbench.remote().connections().at(0).text.c_str());
  }

  static void limitAndConnect(RemoteDesk& desk, OfferedHall& hall) {
    const auto limits = [&] { return desk.workbench.remote().connections().at(0).limits; };
    desk.choose("remote.connect");
    desk.find<QComboBox>("remoteUrl").setEditText(QString::fromStdString(hall.url()));
    auto& images = desk.find<QComboBox>("remoteImages");
    auto& limit = desk.find<QDoubleSpinBox>("remoteLimit");
    images.setFocus();
    QTest::keyClick(&images, Qt::Key_End);
    desk.find<QDoubleSpinBox>("remoteImageRate").setValue(5);
    limit.setFocus();
    limit.selectAll();
    QTest::keyClicks(&limit, QStringLiteral("200"));
    QTest::mouseClick(&desk.find<QPushButton>("remoteConnect"), Qt::LeftButton);
    QCOMPARE(limits().bytesPerSecond, 200e3);
    QCOMPARE(limits().images, LinkLimits::Images::kPng);
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest<foxglove::RawImage>("red1/camera/image") != nullptr, kWaitMs);
    QVERIFY2(desk.state().contains(QStringLiteral("at most 200 kB/s, images as PNG")),
             qPrintable(desk.state()));
    // They are shown again, and changed at once.
    desk.choose("remote.connect");
    desk.find<QComboBox>("remoteUrl").setEditText(QStringLiteral("ws://127.0.0.1:1"));
    limit.setValue(0);
    QCOMPARE(limits().bytesPerSecond, 200e3);
    desk.find<QComboBox>("remoteUrl").setEditText(QString::fromStdString(hall.url()));
    QCOMPARE(limit.value(), 200.0);
    QCOMPARE(images.currentText(), QStringLiteral("as PNG"));
    limit.setFocus();
    QTest::keyClick(&limit, Qt::Key_Up);
    QCOMPARE(limits().bytesPerSecond, 300e3);
    // What was left out is shown for each stream.
    auto* row = desk.find<QTreeWidget>("remoteConnections").topLevelItem(0);
    row->setExpanded(true);
    const auto isShown = [&] {
      for (int i = 0; i < row->childCount(); ++i)
        if (row->child(i)->text(1) == QStringLiteral("red1/camera/image")) return true;
      return false;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isShown(), kWaitMs);
  }

  void theLineIsLostAndFoundWithoutAClick() {
    OfferedHall hall;
    RemoteDesk desk(home_);
    desk.run("remote.connect " + hall.url() + " ''");
    const std::string images = "red1/camera/image";
    QTRY_VERIFY_WITH_TIMEOUT(desk.count(images) > 5, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.count("red1/drawings/image/ball-percept/disc") > 0, kWaitMs);
    hall.unplug(true);
    const auto remote = [&]() -> const robotlink::RemoteRobot& {
      return desk.workbench.session().remoteRobots().at("red1");
    };
    QTRY_VERIFY_WITH_TIMEOUT(!remote().isConnected, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.robot().startsWith(QStringLiteral("red1 (")), kWaitMs);
    QVERIFY(desk.count(images) > 5);
    widgets::test::keepPicture(desk.window, "remote-lost");
    const std::uint64_t before = desk.count(images);
    hall.unplug(false);
    QTRY_VERIFY_WITH_TIMEOUT(remote().isConnected, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.count(images) > before + 3, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(hall.drawsDisc(), kWaitMs);
    QCOMPARE(desk.robot(), QStringLiteral("red1"));
    QCOMPARE(remote().gaps.size(), std::size_t{1});
    QVERIFY(remote().gaps.front().to.has_value());
    // The history goes on behind the gap.
    const auto& history = desk.workbench.session().store().find(images)->messages;
    QVERIFY(history.front().time < remote().gaps.front().from);
    QVERIFY(history.back().time > *remote().gaps.front().to);
  }

  void robotsElsewhereStandBesideTheSimulatedOnes() {
    OfferedHall hall;
    RemoteDesk desk(home_);
    desk.workbench.open(SimulationFeed::opening(defaultSimulation()));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.run("remote.connect " + hall.url() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").count(), 2, kWaitMs);
    QCOMPARE(desk.workbench.session().robots(), (std::vector<std::string>{"red1", "red1-2"}));
    QVERIFY(!desk.status()->running());  // the local simulation, while the one elsewhere runs
    desk.run("robot.select red1-2");
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest<foxglove::RawImage>("red1-2/camera/image") != nullptr, kWaitMs);
    desk.run("robot.stop true");
    QTRY_VERIFY_WITH_TIMEOUT(hall.isStopped(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->stopped_robots_size() == 1, kWaitMs);
  }

  void whatIsReceivedIsRecorded() {
    const TestFolder folder;
    OfferedHall hall;
    RemoteDesk desk(home_);
    desk.run("recording.folder " + folder.path().string());
    desk.run("remote.connect " + hall.url() + " ''");
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest<robotcontrol::KeyTable>("red1/tables/keys") != nullptr, kWaitMs);
    desk.run("recording.start");
    // Not only what views show.
    QTRY_VERIFY_WITH_TIMEOUT(desk.count("red1/joints/states") > 20, kWaitMs);
    desk.run("recording.stop");
    desk.workbench.recording().recorder().finish();
    QCOMPARE(folder.files().size(), std::size_t{1});
    const ReadLog log = logplayer::tests::readLog(folder / folder.files().front());
    QVERIFY(log.complete);
    QVERIFY(log.count("red1/joints/states") > 10);
    QVERIFY(log.count("red1/tables/keys") > 0);
    QVERIFY(log.count("red1/program") > 0);
  }

  void whyNothingIsConnectedIsSaidAndCanBeCanceled() {
    std::string url;
    {
      OfferedHall gone;
      url = gone.url();
    }
    RemoteDesk desk(home_);
    desk.join("http://nowhere");
    QVERIFY(desk.find<QLabel>("remoteState").text().contains(QStringLiteral("ws://")));
    desk.join(url);
    auto& state = desk.find<QLabel>("remoteState");
    QTRY_VERIFY_WITH_TIMEOUT(state.text().contains(QStringLiteral("--listen")), kWaitMs);
    widgets::test::keepPicture(desk.find<QDialog>("remoteDialog"), "remote-nobody");
    auto& cancel = desk.find<QPushButton>("remoteDisconnect");
    QCOMPARE(cancel.text().remove(QLatin1Char('&')), QStringLiteral("Cancel"));
    QTest::mouseClick(&cancel, Qt::LeftButton);
    QVERIFY(desk.workbench.remote().empty());
    QVERIFY(state.text().isEmpty());
  }

  void oneSteersTheOtherSeesItAndTakesOverByAClick() {
    OfferedHall hall;
    RemoteDesk anna(home_ / "anna"), ben(home_ / "ben");
    for (RemoteDesk* desk : {&anna, &ben}) {
      desk->run("remote.connect " + hall.url() + " ''");
      QTRY_COMPARE_WITH_TIMEOUT(desk->robot(), QStringLiteral("red1"), kWaitMs);
    }
    const auto bar = [](RemoteDesk& desk) -> QToolButton& {
      return desk.find<QToolButton>("statusSteering");
    };
    QVERIFY(!bar(anna).isVisible());
    anna.run("robot.steer red1 true");
    QTRY_VERIFY_WITH_TIMEOUT(bar(anna).text().startsWith(QStringLiteral("You steer red1")), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(bar(ben).toolTip().contains(QStringLiteral("RobotControl")), kWaitMs);
    widgets::test::keepPicture(ben.window, "remote-steered-by-other");
    QTest::mouseClick(&bar(ben), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(bar(ben).text().startsWith(QStringLiteral("You steer red1")), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(bar(anna).toolTip().contains(QStringLiteral("steers red1")), kWaitMs);
    // STOP is anyone's.
    QTest::mouseClick(&anna.find<QToolButton>("stopButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hall.isStopped(), kWaitMs);
    QTest::mouseClick(&bar(ben), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!bar(ben).isVisible() && !bar(anna).isVisible(), kWaitMs);
  }

  void whoOffersASessionTakesOverFromGuests() {
    RemoteDesk host(home_ / "host");
    host.workbench.open(SimulationFeed::opening(defaultSimulation()));
    QTRY_VERIFY_WITH_TIMEOUT(host.loaded(), kWaitMs);
    host.run("session.offer 127.0.0.1:0");
    RemoteDesk guest(home_ / "guest");
    guest.run("remote.connect " + host.workbench.offer().url() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(guest.robot(), QStringLiteral("red1"), kWaitMs);
    guest.run("robot.steer red1 true");
    auto& button = host.find<QToolButton>("statusSteering");
    QTRY_VERIFY_WITH_TIMEOUT(button.isVisible(), kWaitMs);
    QVERIFY(button.toolTip().contains(QStringLiteral("steers red1")));
    QTest::mouseClick(&button, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(button.text(), QStringLiteral("You steer red1."), kWaitMs);
    auto& theirs = guest.find<QToolButton>("statusSteering");
    QTRY_VERIFY_WITH_TIMEOUT(theirs.toolTip().contains(QStringLiteral("own computer steers")), kWaitMs);
  }

  void whoSteersARobotElsewhereIsSaidOnceAlsoWhereItIsOfferedOn() {
    OfferedHall hall;
    RemoteDesk host(home_ / "host"), guest(home_ / "guest"), other(home_ / "other");
    host.run("remote.connect " + hall.url() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(host.robot(), QStringLiteral("red1"), kWaitMs);
    host.run("session.offer 127.0.0.1:0");
    guest.run("remote.connect " + host.workbench.offer().url() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(guest.robot(), QStringLiteral("red1"), kWaitMs);
    other.run("remote.connect " + hall.url() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(other.robot(), QStringLiteral("red1"), kWaitMs);
    const auto bar = [](RemoteDesk& desk) { return desk.find<QToolButton>("statusSteering").text(); };
    guest.run("robot.steer red1 true");
    QTRY_COMPARE_WITH_TIMEOUT(bar(guest), QStringLiteral("You steer red1."), kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(bar(host), QStringLiteral("You steer red1."), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(bar(other).contains(QStringLiteral("Steer instead")), kWaitMs);
    // The robot has said it, and nobody else: once, since it has changed once.
    QCOMPARE(host.count("red1/steering"), std::uint64_t{1});
    QCOMPARE(guest.newest<robotcontrol::SteeringStatus>("red1/steering")->own(), true);
    other.run("robot.steer red1 true");
    QTRY_COMPARE_WITH_TIMEOUT(bar(other), QStringLiteral("You steer red1."), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(bar(host).contains(QStringLiteral("Steer instead")), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(bar(guest).contains(QStringLiteral("Steer instead")), kWaitMs);
    QCOMPARE(host.count("red1/steering"), std::uint64_t{2});
  }

  void aSessionIsOfferedToASecondPerson() {
    RemoteDesk first(home_ / "first");
    first.workbench.open(SimulationFeed::opening(defaultSimulation()));
    QTRY_VERIFY_WITH_TIMEOUT(first.loaded(), kWaitMs);
    first.choose("session.offer");
    first.find<QSpinBox>("offerPort").setValue(0);
    QTest::mouseClick(&first.find<QPushButton>("offerButton"), Qt::LeftButton);
    const QString url = first.find<QLineEdit>("offerUrl").text();
    QVERIFY2(url.startsWith(QStringLiteral("ws://127.0.0.1:")), qPrintable(url));
    auto& offered = first.find<QToolButton>("statusOffer");
    QTRY_VERIFY_WITH_TIMEOUT(offered.isVisible(), kWaitMs);
    RemoteDesk second(home_ / "second");
    second.run("remote.connect " + url.toStdString() + " ''");
    QTRY_COMPARE_WITH_TIMEOUT(second.robot(), QStringLiteral("red1"), kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(first.find<QTreeWidget>("offerClients").topLevelItemCount(), 1, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(offered.text().contains(QStringLiteral("1 client")), kWaitMs);
    widgets::test::keepPicture(first.find<QDialog>("offerDialog"), "offer");
    // Both steer the same simulation.
    QTRY_VERIFY_WITH_TIMEOUT(second.status() != nullptr, kWaitMs);
    second.run("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(first.status()->running(), kWaitMs);
    QTest::mouseClick(&first.find<QPushButton>("offerButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!second.workbench.session().remoteRobots().at("red1").isConnected, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!offered.isVisible(), kWaitMs);
  }
};

const widgets::test::GuiTest<RemoteGuiTest> kRemoteGuiTest;

}  // namespace app::test

#include "RemoteGuiTest.moc"
