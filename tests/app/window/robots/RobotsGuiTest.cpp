// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of robots in the window: opened, edited, saved, connected, compared and deployed to.
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "app/core/deploy/RobotSet.h"
#include "colortool/table/ColorTableFile.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "tests/app/served/ServedHall.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/EmptyHint.h"

namespace app::test {
namespace {

/// A desk with the dialog of robots.
class RobotsDesk : public EmptyDesk {
 public:
  explicit RobotsDesk(const std::filesystem::path& home) : EmptyDesk(home) { choose("remote.robots"); }
  void press(const char* button) { QTest::mouseClick(&find<QPushButton>(button), Qt::LeftButton); }
  void open(const std::filesystem::path& file) {
    const auto answer = DialogAnswer::file(QString::fromStdString(file.string()));
    press("robotsOpen");
  }
  QTreeWidgetItem& robot(int row = 0) { return *find<QTreeWidget>("robotsTable").topLevelItem(row); }
  int robots() { return find<QTreeWidget>("robotsTable").topLevelItemCount(); }
  QString report() {
    const auto& tree = find<QTreeWidget>("robotsReport");
    return tree.topLevelItemCount() == 0 ? QString() : tree.topLevelItem(0)->text(1);
  }
  /// The layout in which the robot's program runs, as it says.
  QString layout() {
    const auto* setup = workbench.session().store().latestAs<robotcontrol::ProgramSetup>(
        "red1/program", robotlink::Instant::max());
    return setup == nullptr ? QString() : QString::fromStdString(setup->layout().name());
  }
  QString state() { return find<QLabel>("robotsState").text(); }
};

}  // namespace

class RobotsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aSetIsConnectedComparedAndDeployed() {
    const TestFolder robot;
    ServeOptions options;
    options.resources = robot.path();
    const ServedHall hall(options);
    RobotSet set{"Home game", {{"red1", "red", "goalie", hall.url()}}};
    std::filesystem::copy(robotlink::resource("layouts/compact.yaml"), home_ / "own.yaml");
    set.robots[0].layout = "own.yaml";
    set.robots[0].parameters = robotlink::resource("parameters/ers210").string();
    set.robots[0].motions = robotlink::resource("motions").string();
    set.robots[0].colorTable = "hall.c64";
    const auto file = home_ / "set.yaml";
    QVERIFY(robotlink::writeFileAtomically(file, toText(set)).has_value());
    QVERIFY(colortool::ColorTableFile().save(home_ / "hall.c64").has_value());
    RobotsDesk desk(home_ / "desk");
    auto& hint = desk.find<widgets::EmptyHint>("robotsHint");
    QVERIFY(hint.isVisible() && hint.text().contains(QStringLiteral("Add")));
    desk.open(file);
    QCOMPARE(desk.robots(), 1);
    QVERIFY(!hint.isVisible());
    QCOMPARE(desk.robot().text(2), QStringLiteral("goalie"));
    desk.press("robotsDeploy");
    QVERIFY(desk.state().contains(QStringLiteral("not connected")));
    desk.press("robotsConnect");
    QTRY_VERIFY_WITH_TIMEOUT(desk.robot().text(9).startsWith(QStringLiteral("connected")), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.workbench.remote().robots().empty(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.workbench.remote().connections().front().hasResources, kWaitMs);
    desk.press("robotsCheck");
    QTRY_VERIFY_WITH_TIMEOUT(desk.report().contains(QStringLiteral("files differ")), kWaitMs);
    QVERIFY(robot.files().empty());
    widgets::test::keepPicture(desk.find<QDialog>("robotsDialog"), "robots-differ");
    desk.press("robotsDeploy");
    QTRY_VERIFY_WITH_TIMEOUT(desk.report().startsWith(QStringLiteral("deployed: all of")), kWaitMs);
    widgets::test::keepPicture(desk.find<QDialog>("robotsDialog"), "robots-deployed");
    QVERIFY(std::filesystem::exists(robot / "motions/sit.mof"));
    // What its program reads at its start takes effect with the next one; choices and STOP stay.
    QVERIFY2(desk.report().contains(QStringLiteral("take effect")), qPrintable(desk.report()));
    QVERIFY(desk.workbench.commands().runLine("robot.stop true").has_value());
    QTRY_VERIFY_WITH_TIMEOUT(desk.status() != nullptr && desk.status()->stopped_robots_size() == 1, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QPushButton>("robotsRestart").isEnabled(), kWaitMs);
    desk.press("robotsRestart");
    QTRY_VERIFY_WITH_TIMEOUT(desk.report().startsWith(QStringLiteral("restarted: all of")), kWaitMs);
    QVERIFY2(!desk.report().contains(QStringLiteral("take effect")), qPrintable(desk.report()));
    QTRY_COMPARE_WITH_TIMEOUT(desk.layout(), QStringLiteral("own.yaml"), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QPushButton>("robotsRestart").isEnabled(), kWaitMs);
    QCOMPARE(desk.status()->stopped_robots_size(), 1);
    widgets::test::keepPicture(desk.find<QDialog>("robotsDialog"), "robots-restarted");
    // The robot uses the color table at once.
    QTRY_VERIFY_WITH_TIMEOUT(
        [&] {
          const auto* table = desk.workbench.session().store().latestAs<robotcontrol::ColorTable>(
              "red1/tables/colors", robotlink::Instant::max());
          return table != nullptr && table->source().ends_with("colortables/red1.c64");
        }(),
        kWaitMs);
    desk.press("robotsDisconnect");
    QTRY_COMPARE_WITH_TIMEOUT(desk.robot().text(9), QStringLiteral("not connected"), kWaitMs);
  }

  void aSetIsEditedAndSavedAsText() {
    const auto file = home_ / "set.yaml";
    QVERIFY(robotlink::writeFileAtomically(file, toText({"Home", {{"red1", "", "", "ws://10.0.0.1"}}}))
                .has_value());
    RobotsDesk desk(home_ / "desk");
    desk.open(file);
    desk.robot().setText(2, QStringLiteral("striker"));
    QVERIFY(desk.find<QDialog>("robotsDialog").isWindowModified());
    desk.press("robotsAdd");
    QCOMPARE(desk.robots(), 2);
    desk.press("robotsSave");
    auto read = readRobotSet(file);
    QVERIFY(read.has_value());
    QCOMPARE(read->robots.size(), std::size_t{2});
    QCOMPARE(read->robots[0].role, std::string("striker"));
    QVERIFY(!desk.find<QDialog>("robotsDialog").isWindowModified());
    // What could not be read again is not saved.
    desk.robot(1).setText(3, QStringLiteral("nowhere"));
    desk.press("robotsSave");
    QVERIFY2(desk.state().contains(QStringLiteral("Not saved")), qPrintable(desk.state()));
    desk.find<QTreeWidget>("robotsTable").setCurrentItem(&desk.robot(1));
    desk.press("robotsRemove");
    desk.press("robotsSave");
    QCOMPARE(readRobotSet(file)->robots.size(), std::size_t{1});
  }

  void mistakesOfAFileAreSaidWithTheirLines() {
    const auto file = home_ / "set.yaml";
    QVERIFY(
        robotlink::writeFileAtomically(file, "robot-set: 1\nname: a\nrobots:\n  - nmae: red1\n").has_value());
    RobotsDesk desk(home_ / "desk");
    desk.open(file);
    QVERIFY2(desk.state().contains(QStringLiteral("set.yaml:4")), qPrintable(desk.state()));
    QCOMPARE(desk.robots(), 0);
  }

  void aRobotThatTakesNoFilesSaysWhatToDo() {
    const ServedHall hall;
    RobotsDesk desk(home_);
    QVERIFY(desk.workbench.commands().run("remote.connect", {hall.url(), std::string()}).has_value());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.workbench.remote().robots().empty(), kWaitMs);
    desk.press("robotsAdd");
    QCOMPARE(desk.robot().text(0), QStringLiteral("red1"));
    QCOMPARE(desk.robot().text(3), QString::fromStdString(hall.url()));
    desk.press("robotsCheck");
    QVERIFY(desk.state().contains(QStringLiteral("--resources")));
  }
};

const widgets::test::GuiTest<RobotsGuiTest> kRobotsGuiTest;

}  // namespace app::test

#include "RobotsGuiTest.moc"
