// SPDX-License-Identifier: GPL-3.0-or-later
// The whole workbench as a person uses it: mouse and keys on a window in which a robot plays.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QTreeView>
#include <fstream>

#include "colortool/table/ColorTableFile.h"
#include "tests/app/ShortLog.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/Theme.h"
#include "widgets/solutions/SolutionModel.h"

namespace app::test {
namespace {

/// Pixels of the color that the disc around the ball is drawn in; nothing at the start of a game looks like
/// that.
int discPixels(QWidget& widget) {
  const QImage image = widget.grab().toImage();
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      count += color == QColor(250, 90, 170) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

class WorkbenchGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void theSimulationIsStartedPausedSteppedAndResetByTheToolBar() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(!desk.status()->running());
    desk.click("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->running() && desk.status()->time() > 0.2, kWaitMs);
    desk.click("simulation.pause");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.status()->running(), kWaitMs);
    const auto steps = desk.status()->steps();
    desk.click("simulation.step");
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->steps(), steps + 2, kWaitMs);
    QVERIFY(desk.find<QLabel>("statusTime").text().contains(QString::number(desk.status()->time(), 'f', 3)));
    desk.click("simulation.reset");
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->steps(), 0U, kWaitMs);
  }

  void theWorldIsPutBackAndRewoundByTheMenu() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& menu = desk.find<QMenu>("snapshotMenu");
    const auto choose = [&](const char* name) {
      Q_EMIT menu.aboutToShow();
      auto* action = menu.findChild<QAction*>(QLatin1String(name));
      if (action != nullptr && action->isEnabled()) action->trigger();
      return action != nullptr;
    };
    QVERIFY(choose("snapshot.take"));
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->snapshots_size(), 1, kWaitMs);
    for (int i = 0; i < 20; ++i) desk.click("simulation.step");
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->steps(), 40U, kWaitMs);
    QVERIFY(choose("rewind.0.1"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->world_time() < 0.07, kWaitMs);
    QVERIFY(choose("simulation.restore 1"));
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->world_time(), 0.0, kWaitMs);
    QVERIFY(desk.status()->time() > 0.15);
    QVERIFY(!desk.find<QAction>("simulation.rewind").isEnabled());
  }

  void theSpeedIsChosenInItsBoxAndStopIsAKey() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& speed = desk.find<QComboBox>("speedBox");
    speed.setFocus();
    QTest::keyClick(&speed, Qt::Key_Down);
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->requested_speed(), 2.0, kWaitMs);
    QTest::keyClick(&desk.window, Qt::Key_Escape, Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->stopped_robots_size(), 1, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QToolButton>("stopButton").isChecked(), kWaitMs);
    QTest::mouseClick(&desk.find<QToolButton>("stopButton"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->stopped_robots_size(), 0, kWaitMs);
  }

  void theLayoutIsChosenInItsBox() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& layout = desk.find<QComboBox>("layoutBox");
    QCOMPARE(layout.currentText(), QStringLiteral("compact"));
    const QString next = layout.itemText(layout.currentIndex() + 1);
    layout.setFocus();
    QTest::keyClick(&layout, Qt::Key_Down);
    QTRY_COMPARE_WITH_TIMEOUT(QString::fromStdString(desk.workbench.loaded()->layout.stem().string()), next,
                              kWaitMs);
    QCOMPARE(layout.currentText(), next);
  }

  void aLayoutIsListedOnceByItsFile() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& layout = desk.find<QComboBox>("layoutBox");
    const auto shipped = desk.workbench.loaded()->layout;
    // One of the user's own with the name of a shipped one is another one.
    std::filesystem::create_directories(home_ / "mine");
    const auto own = home_ / "mine" / shipped.filename();
    std::filesystem::copy_file(shipped, own);
    QVERIFY(desk.workbench.commands().runLine("layout.open '" + own.string() + "'"));
    QTRY_COMPARE_WITH_TIMEOUT(layout.currentData().toString(), QString::fromStdString(own.string()), kWaitMs);
    const int count = layout.count();
    QVERIFY(desk.workbench.commands().runLine("layout.open '" + own.string() + "'"));
    auto& session = desk.workbench.session();
    for (int i = 0; i < 2; ++i) {
      session.setRobots({"red1", "elsewhere"});
      for (const char* robot : {"elsewhere", "red1"}) {
        session.selectRobot(robot);
        desk.window.tick();
      }
    }
    QCOMPARE(layout.count(), count);
    QCOMPARE(layout.currentData().toString(), QString::fromStdString(own.string()));
  }

  void theColorTableInUseStandsBesideTheRobot() {
    Desk desk(home_);
    auto& button = desk.find<QToolButton>("colorTableButton");
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(button.text(), QStringLiteral("Colors: built-in"), kWaitMs);
    QTRY_VERIFY(button.isVisible());
    std::filesystem::create_directories(home_);
    const std::string file = (home_ / "game.c64").string();
    QVERIFY(colortool::ColorTableFile().save(file).has_value());
    QVERIFY(desk.workbench.commands().runLine("robot.color-table \"" + file + "\"").has_value());
    QTRY_COMPARE_WITH_TIMEOUT(button.text(), QStringLiteral("Colors: game.c64"), kWaitMs);
    QVERIFY2(button.toolTip().contains(QString::fromStdString(file)), qPrintable(button.toolTip()));
    QVERIFY(button.toolTip().contains(QStringLiteral("loaded 20")));
    QVERIFY(desk.workbench.commands().runLine("simulation.reset").has_value());
    QVERIFY(desk.workbench.commands().runLine("layout.open parallel").has_value());
    QTRY_COMPARE_WITH_TIMEOUT(desk.workbench.loaded()->layout.stem().string(), std::string("parallel"),
                              kWaitMs);
    desk.window.tick();
    QTRY_COMPARE_WITH_TIMEOUT(button.text(), QStringLiteral("Colors: game.c64"), kWaitMs);
    for (QAction* action : button.menu()->actions()) {
      if (action->objectName() == QLatin1String("robot.no-color-table")) action->trigger();
    }
    QTRY_COMPARE_WITH_TIMEOUT(button.text(), QStringLiteral("Colors: built-in"), kWaitMs);
  }

  void aSceneWithTwoRobotsLetsOneBeChosen() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QFile scene(QStringLiteral(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf"));
    QVERIFY(scene.open(QIODevice::ReadOnly));
    QByteArray text = scene.readAll();
    text.replace("</world>",
                 "<include><uri>model://ers210</uri><name>blue1</name><pose>1 0.8 0.1138 0 0 "
                 "3.14</pose></include></world>");
    std::filesystem::create_directories(home_);
    const QString file = QString::fromStdString((home_ / "two.sdf").string());
    QFile two(file);
    QVERIFY(two.open(QIODevice::WriteOnly) && two.write(text) == text.size());
    two.close();
    QVERIFY(desk.workbench.commands().runLine("simulation.open " + file.toStdString()));
    auto& robot = desk.find<QComboBox>("robotBox");
    QTRY_COMPARE_WITH_TIMEOUT(robot.count(), 2, kWaitMs);
    const std::string before = desk.workbench.session().selectedRobot();
    robot.setFocus();
    QTest::keyClick(&robot, robot.currentIndex() == 0 ? Qt::Key_Down : Qt::Key_Up);
    QVERIFY(desk.workbench.session().selectedRobot() != before);
    QTRY_COMPARE_WITH_TIMEOUT(robot.currentText().toStdString(), desk.workbench.session().selectedRobot(),
                              kWaitMs);
  }

  void aDebugKeyThatIsSwitchedOnDrawsIntoTheImage() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.click("simulation.start");
    auto& tree = desk.find<QTreeView>("keysTree");
    auto& canvas = desk.find<QWidget>("imageCanvas");
    QTRY_VERIFY_WITH_TIMEOUT(find(tree, QStringLiteral("disc")).isValid(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(discPixels(canvas) > 20,
                             kWaitMs);  // It is one of those that are on at the first start.
    tree.setCurrentIndex(find(tree, QStringLiteral("disc")));
    QTest::keyClick(&tree, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(discPixels(canvas) < 5, kWaitMs);
    QTest::keyClick(&tree, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(discPixels(canvas) > 20, kWaitMs);
  }

  void aSolutionIsSwitchedByAClickWhileTheRobotPlays() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.click("simulation.start");
    auto& tree = desk.find<QTreeView>("solutionsTree");
    QTRY_VERIFY_WITH_TIMEOUT(find(tree, QStringLiteral("circle-fit")).isValid(), kWaitMs);
    QCOMPARE(find(tree, QStringLiteral("ball-percept"), widgets::SolutionModel::kState).data().toString(),
             QStringLiteral("region"));
    const QModelIndex choice = find(tree, QStringLiteral("circle-fit"));
    tree.scrollTo(choice);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(choice).center());
    QTRY_COMPARE_WITH_TIMEOUT(
        find(tree, QStringLiteral("ball-percept"), widgets::SolutionModel::kState).data().toString(),
        QStringLiteral("circle-fit"), kWaitMs);
  }

  void theMotionTesterTakesOverAndDrives() {
    Desk desk(home_);
    desk.window.showPerspective(QStringLiteral("Motion"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.click("simulation.start");
    auto& take = desk.find<QToolButton>("motionTakeOver");
    QTRY_VERIFY_WITH_TIMEOUT(take.isEnabled(), kWaitMs);
    QTest::mouseClick(&take, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(take.isChecked(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.robot().has_value(), kWaitMs);
    auto& pad = desk.find<QWidget>("walkPad");
    QTRY_VERIFY_WITH_TIMEOUT(pad.isEnabled(), kWaitMs);
    const robotlink::Vector3 start = *desk.robot();
    QTest::mousePress(&pad, Qt::LeftButton, {}, QPoint(pad.width() / 2, pad.height() / 5));
    QTRY_VERIFY_WITH_TIMEOUT((*desk.robot() - start).norm() > 0.1, kWaitMs);
    QTest::mouseRelease(&pad, Qt::LeftButton, {}, QPoint(pad.width() / 2, pad.height() / 10));
  }

  void aPerspectiveIsSavedAndFoundAgainAfterARestart() {
    const auto home = home_ / "restart";
    {
      EmptyDesk desk(home);
      desk.window.showPerspective(QStringLiteral("Processes"));
      QVERIFY(desk.window.docks().docks(QStringLiteral("scene")).empty());
      desk.find<QAction>("view.image").trigger();
      desk.window.close();
    }
    EmptyDesk desk(home);
    QVERIFY(desk.find<QAction>("perspective.Processes").isChecked());
    QVERIFY(desk.window.docks().docks(QStringLiteral("scene")).empty());
    QCOMPARE(desk.window.docks().docks(QStringLiteral("image")).size(), std::size_t{1});
    desk.window.showPerspective(QStringLiteral("Play"));
    QCOMPARE(desk.window.docks().docks(QStringLiteral("scene")).size(), std::size_t{1});
  }

  void aBrokenWindowFileIsSetAsideAndReported() {
    const auto home = home_ / "broken";
    std::filesystem::create_directories(home);
    { std::ofstream(home / "window.json") << "{ this is no JSON"; }
    EmptyDesk desk(home);
    QVERIFY(desk.find<QLabel>("errorText").isVisible());
    QVERIFY(desk.find<QLabel>("errorText").text().contains(QStringLiteral("window.json")));
    QVERIFY(std::filesystem::exists(home / "window.json.broken"));
    QTest::mouseClick(&desk.find<QToolButton>("dismissErrors"), Qt::LeftButton);
    QVERIFY(!desk.find<QLabel>("errorText").isVisible());
  }

  void aBadSceneIsShownWithItsPlaceAndTheOldOneGoesOn() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.click("simulation.start");
    const auto file = home_ / "bad.sdf";
    {
      std::ofstream(file)
          << "<sdf version=\"1.9\">\n  <world name=\"w\">\n    <model/>\n  </world>\n</sdf>\n";
    }
    QVERIFY(desk.workbench.commands().runLine("simulation.open " + file.string()));
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>("errorText").isVisible(), kWaitMs);
    QVERIFY2(desk.find<QLabel>("errorText").text().contains(QStringLiteral("bad.sdf:3")),
             qPrintable(desk.find<QLabel>("errorText").text()));
    const double time = desk.status()->time();
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->time() > time, kWaitMs);
  }

  void aLogTakesTheSimulationsPlaceUntilASceneIsChosen() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    const auto file = home_ / "short.mcap";
    QCOMPARE(app::test::ShortLog::write(file), std::string());
    QVERIFY(desk.workbench.commands().runLine("log.open \"" + file.string() + "\""));
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>("statusTime").text().contains(QStringLiteral("frame 102")),
                             kWaitMs);
    QCOMPARE(desk.find<QLabel>("statusState").text(), QStringLiteral("paused"));
    QVERIFY(desk.window.windowTitle().startsWith(QStringLiteral("short.mcap")));
    QVERIFY(desk.status() == nullptr);
    QVERIFY(!desk.find<QAction>("simulation.start").isEnabled());
    QVERIFY(desk.find<QToolButton>("stopButton").isEnabled());
    auto& scene = desk.find<QComboBox>("sceneBox");
    QCOMPARE(scene.currentText(), QString());
    scene.setFocus();
    QTest::keyClick(&scene, Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(!desk.window.windowTitle().startsWith(QStringLiteral("short.mcap")));
    QVERIFY(!desk.find<QLabel>("errorText").isVisible());
  }

  void lightAndDarkReachEveryView() {
    EmptyDesk desk(home_ / "appearance");
    const auto lightness = [&desk] {
      return desk.find<QTreeView>("keysTree").palette().color(QPalette::Base).lightness();
    };
    desk.find<QAction>("appearance.dark").trigger();
    QVERIFY(lightness() < 100);
    desk.find<QAction>("appearance.light").trigger();
    QVERIFY(lightness() > 200);
  }

  void highContrastAndTheSizeOfTextsAreChosenAndRemembered() {
    const std::filesystem::path home = home_ / "contrast";
    const QFont before = QApplication::font();
    {
      EmptyDesk desk(home);
      desk.find<QAction>("appearance.high-contrast").trigger();
      const QPalette palette = desk.find<QTreeView>("keysTree").palette();
      QVERIFY(widgets::isHighContrast(palette));
      QVERIFY(widgets::colorOf(widgets::Meaning::kMuted, palette).lightness() > 180);
      QVERIFY(palette.color(QPalette::Disabled, QPalette::Text).lightness() > 150);
      desk.find<QAction>("textSize.150").trigger();
      QCOMPARE(QApplication::font().pointSizeF(), before.pointSizeF() * 1.5);
      QCOMPARE(desk.find<QTreeView>("keysTree").font().pointSizeF(), before.pointSizeF() * 1.5);
      QVERIFY(!desk.workbench.commands().runLine("view.text-size 20"));
      QVERIFY(!desk.workbench.commands().runLine("view.text-size 1000"));
      QVERIFY(desk.workbench.commands().runLine("view.text-size 120"));
      QVERIFY(!desk.find<QAction>("textSize.150").isChecked());
      desk.window.keep();
      QApplication::setFont(before);
    }
    EmptyDesk desk(home);
    QVERIFY(desk.find<QAction>("appearance.high-contrast").isChecked());
    QCOMPARE(QApplication::font().pointSizeF(), before.pointSizeF() * 1.2);
    desk.find<QAction>("appearance.light").trigger();
    desk.find<QAction>("textSize.100").trigger();
    QCOMPARE(QApplication::font().pointSizeF(), before.pointSizeF());
  }

  void everyViewOfTheMenuOpens() {
    EmptyDesk desk(home_ / "views");
    for (const auto& type : widgets::ViewRegistry::all()) {
      desk.find<QAction>((std::string("view.") + type.id).c_str()).trigger();
      QVERIFY2(!desk.window.docks().docks(QLatin1String(type.id)).empty(), type.id);
    }
    QVERIFY(widgets::ViewRegistry::all().size() >= 10);
    desk.window.tick();
  }

  void withinAMinuteOfItsTimeTheRobotHasKickedTheBall() {
    Desk desk(home_ / "minute");
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(desk.workbench.commands().runLine("simulation.speed 0"));
    desk.click("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->ball_contacts() > 0, 60000);
    QVERIFY(desk.status()->time() <= 60);
    desk.click("simulation.pause");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.status()->running(), kWaitMs);
    QTRY_VERIFY(desk.find<QLabel>("statusContacts").text() != QStringLiteral("0 ball contacts"));
  }
};

const widgets::test::GuiTest<WorkbenchGuiTest> kWorkbenchGuiTest;

}  // namespace app::test

#include "WorkbenchGuiTest.moc"
