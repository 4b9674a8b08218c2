// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that announce themselves stand in the dialogs without typing.
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>

#include "robotlink/dds/LocalAddresses.h"
#include "tests/app/MadeUpRobots.h"
#include "tests/app/served/OfferedHall.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/EmptyHint.h"

namespace app::test {
namespace {

using robotlink::dds::AnnouncedRobots;

/// A desk in a network whose robots the test makes up.
class NetworkDesk : public EmptyDesk {
 public:
  NetworkDesk(const std::filesystem::path& home, MadeUpRobots& robots) : EmptyDesk(home) {
    workbench.search().listenBy(robots.source());
  }
  QTreeWidget& list(const char* dialog) { return child<QTreeWidget>(find<QDialog>(dialog), "foundRobots"); }
  QString hint(const char* dialog) {
    auto& hint = child<widgets::EmptyHint>(find<QDialog>(dialog), "foundHint");
    return hint.isVisible() ? hint.text() : QString();
  }
  void clickRow(QTreeWidget& list, int row) {
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                      list.visualItemRect(list.topLevelItem(row)).center());
  }
};

AnnouncedRobots robotsAt(const std::string& address, std::uint16_t port,
                         std::vector<robotlink::dds::AnnouncedRobot> robots) {
  return {.robots = std::move(robots), .address = address, .port = port};
}

AnnouncedRobots announcedAs(const std::string& url) {
  const std::string port = url.substr(url.rfind(':') + 1);
  return robotsAt("127.0.0.1", static_cast<std::uint16_t>(std::stoi(port)), {{"red1", "ers210", "compact"}});
}

}  // namespace

class FoundRobotsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void theyComeAndGoWhileTheDialogIsOpen() {
    MadeUpRobots robots;
    NetworkDesk desk(home_, robots);
    QCOMPARE(robots.listeners(), 0);
    desk.choose("remote.connect");
    QTRY_COMPARE_WITH_TIMEOUT(robots.listeners(), 1, kWaitMs);
    auto& list = desk.list("remoteDialog");
    auto& dialog = desk.find<QDialog>("remoteDialog");
    const QRect buttons = dialog.findChild<QDialogButtonBox*>()->geometry();
    QVERIFY(
        !dialog.findChild<QTreeWidget*>(QStringLiteral("remoteConnections"))->geometry().intersects(buttons));
    QTRY_VERIFY_WITH_TIMEOUT(desk.hint("remoteDialog").contains(QStringLiteral("Listening")), kWaitMs);
    robots.set({robotsAt("10.0.0.7", 8765, {{"red1", "ers210", "compact"}, {"red2", "ers210", "compact"}}),
                robotsAt("10.0.0.8", 8766, {{"<b>p3at1</b>", "p3at", "drive"}})});
    QTRY_COMPARE_WITH_TIMEOUT(list.topLevelItemCount(), 2, kWaitMs);
    QCOMPARE(desk.hint("remoteDialog"), QString());
    QCOMPARE(list.topLevelItem(0)->text(0), QStringLiteral("<b>p3at1</b>"));
    QVERIFY(list.topLevelItem(0)->toolTip(0).contains(QStringLiteral("&lt;b&gt;")));
    const QTreeWidgetItem& red = *list.topLevelItem(1);
    QCOMPARE(red.text(0), QStringLiteral("red1, red2"));
    QCOMPARE(red.text(1), QStringLiteral("ers210"));
    QCOMPARE(red.text(2), QStringLiteral("layout compact"));
    QCOMPARE(red.text(3), QStringLiteral("ws://10.0.0.7:8765"));
    QVERIFY(red.text(4).endsWith(QStringLiteral(" s")));
    widgets::test::keepPicture(desk.find<QDialog>("remoteDialog"), "connect-found");
    desk.clickRow(list, 1);
    auto& url = desk.find<QComboBox>("remoteUrl");
    QCOMPARE(url.currentText(), QStringLiteral("ws://10.0.0.7:8765"));
    // What goes leaves the list; the selection stays with its robots.
    robots.set({robotsAt("10.0.0.7", 8765, {{"red1", "ers210", "compact"}})});
    QTRY_COMPARE_WITH_TIMEOUT(list.topLevelItemCount(), 1, kWaitMs);
    QVERIFY(list.topLevelItem(0)->isSelected());
    QTest::keyClick(&desk.find<QDialog>("remoteDialog"), Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(robots.listeners(), 0, kWaitMs);
  }

  void aDoubleClickConnects() {
    OfferedHall hall;
    MadeUpRobots robots;
    robots.set({announcedAs(hall.url())});
    NetworkDesk desk(home_, robots);
    desk.choose("remote.connect");
    auto& list = desk.list("remoteDialog");
    QTRY_COMPARE_WITH_TIMEOUT(list.topLevelItemCount(), 1, kWaitMs);
    list.setCurrentItem(list.topLevelItem(0));
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").currentText(), QStringLiteral("red1"),
                              kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QDialog>("remoteDialog").isVisible(), kWaitMs);
  }

  void forABodyTheProgramIsToRunHere() {
    MadeUpRobots robots;
    robots.set({robotsAt("10.0.0.7", 8765, {{.name = "red1", .kind = "ers210", .isBody = true}}),
                robotsAt("10.0.0.8", 8765, {{"red2", "ers210", "compact"}})});
    NetworkDesk desk(home_, robots);
    desk.choose("remote.connect");
    auto& list = desk.list("remoteDialog");
    QTRY_COMPARE_WITH_TIMEOUT(list.topLevelItemCount(), 2, kWaitMs);
    QVERIFY(list.topLevelItem(0)->text(2).contains(QStringLiteral("body only")));
    desk.clickRow(list, 0);
    QCOMPARE(desk.find<QComboBox>("remoteProgram").currentIndex(), 1);
    desk.clickRow(list, 1);
    QCOMPARE(desk.find<QComboBox>("remoteProgram").currentIndex(), 0);
  }

  void whyThereAreNoneIsSaid() {
    MadeUpRobots robots;
    robots.setProblem("This computer is in no network.");
    NetworkDesk desk(home_, robots);
    desk.choose("remote.connect");
    QTRY_COMPARE_WITH_TIMEOUT(desk.hint("remoteDialog"), QStringLiteral("This computer is in no network."),
                              kWaitMs);
    robots.setProblem("");
    QTRY_VERIFY_WITH_TIMEOUT(desk.hint("remoteDialog").contains(QStringLiteral("--listen")), kWaitMs);
  }

  void theSessionThatIsOfferedHereIsNotListed() {
    MadeUpRobots robots;
    NetworkDesk desk(home_, robots);
    QVERIFY(desk.workbench.offerSession("127.0.0.1:0").has_value());
    robots.set({announcedAs(desk.workbench.offer().url()), robotsAt("10.0.0.7", 1, {{"red2"}})});
    desk.choose("remote.connect");
    auto& list = desk.list("remoteDialog");
    QTRY_COMPARE_WITH_TIMEOUT(list.topLevelItemCount(), 1, kWaitMs);
    QCOMPARE(list.topLevelItem(0)->text(0), QStringLiteral("red2"));
  }

  void theyAreAddedToSetsOfRobots() {
    MadeUpRobots robots;
    robots.set({robotsAt("10.0.0.7", 8765, {{"red1", "ers210", "compact"}, {"red2", "ers210", "compact"}})});
    NetworkDesk desk(home_, robots);
    desk.choose("remote.robots");
    auto& list = desk.list("robotsDialog");
    QTRY_COMPARE_WITH_TIMEOUT(list.topLevelItemCount(), 1, kWaitMs);
    desk.clickRow(list, 0);
    widgets::test::keepPicture(desk.find<QDialog>("robotsDialog"), "robots-found");
    QTest::mouseClick(&desk.find<QPushButton>("robotsAdd"), Qt::LeftButton);
    auto& table = desk.find<QTreeWidget>("robotsTable");
    QCOMPARE(table.topLevelItemCount(), 2);
    QCOMPARE(table.topLevelItem(1)->text(0), QStringLiteral("red2"));
    QCOMPARE(table.topLevelItem(1)->text(3), QStringLiteral("ws://10.0.0.7:8765"));
    // Those that have moved get their new address.
    robots.set({robotsAt("10.0.0.9", 8765, {{"red1", "ers210", "compact"}})});
    QTRY_VERIFY_WITH_TIMEOUT(list.topLevelItem(0)->text(3).contains(QStringLiteral("10.0.0.9")), kWaitMs);
    list.setCurrentItem(list.topLevelItem(0));
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Return);
    QCOMPARE(table.topLevelItemCount(), 2);
    QCOMPARE(table.topLevelItem(0)->text(3), QStringLiteral("ws://10.0.0.9:8765"));
  }
};

const widgets::test::GuiTest<FoundRobotsGuiTest> kFoundRobotsGuiTest;

}  // namespace app::test

#include "FoundRobotsGuiTest.moc"
