// SPDX-License-Identifier: GPL-3.0-or-later
// Every entry of the workbench's menus, chosen by the mouse or its key, with the dialogs that it opens.
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolBar>
#include <QTreeWidget>
#include <fstream>

#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/bars/Tour.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/DialogAnswer.h"

namespace app::test {
namespace {

constexpr char kLayouts[] = ROBOTCONTROL_SOURCE_DIR "/resources/layouts/";

/// The shipped scene with a second robot, in a file of its own.
QString twoRobots(const std::filesystem::path& folder) {
  QFile scene(QStringLiteral(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf"));
  if (!scene.open(QIODevice::ReadOnly)) qFatal("the shipped scene is missing");
  QByteArray text = scene.readAll();
  text.replace("</world>",
               "<include><uri>model://ers210</uri><name>blue1</name><pose>1 0.8 0.1138 0 0 "
               "3.14</pose></include></world>");
  std::filesystem::create_directories(folder);
  QFile two(QString::fromStdString((folder / "two.sdf").string()));
  if (!two.open(QIODevice::WriteOnly) || two.write(text) != text.size())
    qFatal("the scene cannot be written");
  return two.fileName();
}

std::size_t docks(Desk& desk, const char* id) {
  return desk.window.docks().docks(QLatin1String(id)).size();
}

}  // namespace

class MenusGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aSceneIsOpenedByItsFileAndTheShippedOneInItsBox() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    DialogAnswer nothing([](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::RejectRole); });
    desk.choose("simulation.open");
    QVERIFY(nothing.asked());
    QVERIFY(!desk.workbench.loading());
    DialogAnswer two = DialogAnswer::file(twoRobots(home_));
    desk.choose("simulation.open");
    QVERIFY(two.asked());
    auto& scenes = desk.find<QComboBox>("sceneBox");
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").count(), 2, kWaitMs);
    QCOMPARE(scenes.currentText(), QStringLiteral("two.sdf"));
    scenes.setFocus();
    QTest::keyClick(&scenes, Qt::Key_F);
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("robotBox").count(), 1, kWaitMs);
    QCOMPARE(scenes.currentText(), QStringLiteral("field2002"));
  }

  void aLayoutIsOpenedByItsFile() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    DialogAnswer answer = DialogAnswer::file(QLatin1String(kLayouts) + QStringLiteral("balanced.yaml"));
    desk.choose("file.openLayout");
    QVERIFY(answer.asked());
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("layoutBox").currentText(), QStringLiteral("balanced"),
                              kWaitMs);
  }

  void aPerspectiveIsExportedAndImported() {
    const std::filesystem::path file = home_ / "mine.perspective.json";
    EmptyDesk desk(home_);
    QVERIFY(desk.workbench.commands().runLine("view.close image"));
    DialogAnswer out = DialogAnswer::file(QString::fromStdString(file.string()));
    desk.choose("exportPerspective");
    QVERIFY(out.asked());
    QVERIFY(std::filesystem::exists(file));
    QVERIFY(desk.workbench.commands().runLine("view.show image"));
    DialogAnswer in = DialogAnswer::file(QString::fromStdString(file.string()));
    desk.choose("importPerspective");
    QVERIFY(in.asked());
    QTRY_VERIFY(desk.find<QAction>("perspective.Play 2").isChecked());
    QVERIFY(!desk.window.docks().isOpen(QStringLiteral("image")));
    const std::filesystem::path other = home_ / "other.json";
    std::ofstream(other) << "# no JSON";
    DialogAnswer wrong = DialogAnswer::file(QString::fromStdString(other.string()));
    desk.choose("importPerspective");
    QVERIFY(wrong.asked());
    QVERIFY(desk.find<QLabel>("errorText").text().contains(QStringLiteral("no perspective")));
  }

  void whatWasChosenForASceneIsShownWithItAgain() {
    {
      Desk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
      desk.choose("perspective.Processes");
      QTRY_VERIFY(desk.find<QAction>("perspective.Processes").isChecked());
      desk.window.keep();
    }
    EmptyDesk desk(home_);
    desk.window.showPerspective(QStringLiteral("Play"));
    QTRY_VERIFY(desk.find<QAction>("perspective.Play").isChecked());
    desk.workbench.open(SimulationFeed::opening(defaultSimulation()));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QTRY_VERIFY(desk.find<QAction>("perspective.Processes").isChecked());
    // What is chosen before something is opened is chosen for it.
    EmptyDesk other(home_);
    other.choose("perspective.Motion");
    other.workbench.open(SimulationFeed::opening(defaultSimulation()));
    QTRY_VERIFY_WITH_TIMEOUT(other.loaded(), kWaitMs);
    other.window.tick();
    QVERIFY(other.find<QAction>("perspective.Motion").isChecked());
  }

  void aTourExplainsThePartsAndEndsWithItsLastStepOrByEscape() {
    EmptyDesk desk(home_);
    QVERIFY(desk.window.isFirstStart());
    desk.choose("help.tour");
    auto& tour = desk.find<app::Tour>("tour");
    auto& mark = desk.find<QWidget>("tourMark");
    QVERIFY(tour.isVisible() && mark.isVisible());
    QVERIFY(!desk.find<QPushButton>("tourBack").isEnabled());
    QStringList titles;
    for (int step = 0; step < tour.stepCount(); ++step) {
      QCOMPARE(tour.step(), step);
      QVERIFY(desk.window.rect().contains(tour.geometry()));
      titles << desk.find<QLabel>("tourTitle").text();
      click(desk.find<QPushButton>("tourNext"));
    }
    QCOMPARE(titles.removeDuplicates(), 0);
    QVERIFY(!tour.isVisible() && !mark.isVisible());
    desk.choose("help.tour");
    QCOMPARE(tour.step(), 0);
    click(desk.find<QPushButton>("tourNext"));
    click(desk.find<QPushButton>("tourBack"));
    QCOMPARE(tour.step(), 0);
    // The frame is around the toolbar, and does not keep clicks from it.
    click(desk.find<QPushButton>("tourNext"));
    QVERIFY(mark.geometry().contains(desk.find<QToolBar>("simulationToolBar").geometry().center()));
    QVERIFY(mark.testAttribute(Qt::WA_TransparentForMouseEvents));
    QTest::keyClick(&desk.find<QPushButton>("tourNext"), Qt::Key_Escape);
    QVERIFY(!tour.isVisible() && !mark.isVisible());
    desk.window.keep();
  }

  void thePictureOfTheWindowIsSavedOrItIsSaidWhyNot() {
    EmptyDesk desk(home_);
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    DialogAnswer answer = DialogAnswer::file(file);
    desk.choose("file.savePicture");
    QVERIFY(answer.asked());
    QCOMPARE(QImage(file).size(), desk.window.size());
    const QString nowhere = folder.filePath(QStringLiteral("missing/window.png"));
    DialogAnswer wrong = DialogAnswer::file(nowhere);
    desk.choose("file.savePicture");
    QVERIFY(wrong.asked());
    QVERIFY(desk.find<QLabel>("errorText").isVisible());
    QVERIFY2(desk.find<QLabel>("errorText").text().contains(nowhere),
             qPrintable(desk.find<QLabel>("errorText").text()));
  }

  void quitClosesTheWindow() {
    EmptyDesk desk(home_);
    desk.choose("file.quit");
    QVERIFY(!desk.window.isVisible());
  }

  void theSimulationIsControlledByItsMenuAndStopByThatOfTheRobot() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.choose("speed.5");
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->requested_speed(), 5.0, kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QComboBox>("speedBox").currentText(), QStringLiteral("5×"), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QAction>("simulation.start").isEnabled(), kWaitMs);
    desk.choose("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->running(), kWaitMs);
    auto& state = desk.find<QLabel>("statusState");
    QTRY_COMPARE_WITH_TIMEOUT(state.text(), QStringLiteral("running"), kWaitMs);
    auto& speed = desk.find<QLabel>("statusSpeed");
    QTRY_VERIFY_WITH_TIMEOUT(
        speed.text().startsWith(QStringLiteral("sim ")) && speed.text() != QStringLiteral("sim 0.0×"),
        kWaitMs);
    QCOMPARE(desk.find<QLabel>("statusDropped").text(), QStringLiteral("0 dropped"));
    QTest::keyClick(&desk.window, Qt::Key_F6);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.status()->running(), kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(state.text(), QStringLiteral("paused"), kWaitMs);
    desk.choose("robot.stop");
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->stopped_robots_size(), 1, kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(state.text(), QStringLiteral("STOP engaged"), kWaitMs);
  }

  void aRealRobotElsewhereIsShownAsOneHere() {
    EmptyDesk desk(home_);
    const auto status = std::make_shared<robotcontrol::SimulationStatus>();
    status->set_speed(1);
    status->set_running(true);
    status->set_is_real(true);
    status->add_robots("p3at1");
    desk.workbench.session().push(
        {robotlink::streams::kSimulation, robotlink::Instant(std::chrono::seconds(1)), status});
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QLabel>("statusSpeed").text(), QStringLiteral("real time"), kWaitMs);
    QCOMPARE(desk.find<QLabel>("statusState").text(), QStringLiteral("not connected"));
    QVERIFY(!desk.find<QAction>("simulation.pause").isEnabled());
  }

  void theLightIsChosenInTheSimulationsMenu() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.choose("light.dark-warm");
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->brightness(), 0.75, kWaitMs);
    QCOMPARE(desk.status()->warmth(), 0.25);
    desk.choose("light.scene");
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->brightness(), 1.0, kWaitMs);
    QCOMPARE(desk.status()->warmth(), 0.0);
  }

  void theLightHasSlidersWithMarksAndValues() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& menu = desk.find<QMenu>("lightMenu");
    menu.popup(desk.window.mapToGlobal(QPoint(20, 40)));
    auto& slider = desk.find<QSlider>("lightBrightnessSlider");
    auto& box = desk.find<QDoubleSpinBox>("lightBrightness");
    QCOMPARE(box.value(), 1.0);
    QVERIFY(slider.tickPosition() != QSlider::NoTicks);
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_PageDown);
    QCOMPARE(box.value(), 0.75);
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->brightness(), 0.75, kWaitMs);
    auto& warmth = desk.find<QSlider>("lightWarmthSlider");
    warmth.setFocus();
    QTest::keyClick(&warmth, Qt::Key_PageUp);
    QTRY_COMPARE_WITH_TIMEOUT(desk.status()->warmth(), 0.25, kWaitMs);
    QVERIFY(menu.isVisible());
    desk.find<QAction>("light.scene").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(box.value(), 1.0, kWaitMs);
    QCOMPARE(slider.value(), 100);
    QCOMPARE(warmth.value(), 0);
    menu.close();
  }

  void aPerspectiveThatIsAskedForAtTheStartLooksAsItWasLeft() {
    const auto sizes = [this](const char* perspective) {
      app::Workbench workbench(home_);
      app::MainWindow window(workbench, home_);
      if (perspective != nullptr) window.showPerspective(QLatin1String(perspective));
      window.show();
      if (!QTest::qWaitForWindowActive(&window)) qFatal("the window never became active");
      QList<QSize> found;
      for (const char* view : {"image", "solutions", "messages", "field"}) {
        for (const auto* dock : window.docks().docks(QLatin1String(view)))
          found << dock->dockAreaWidget()->size();
      }
      window.close();
      return found;
    };
    const auto play = sizes(nullptr);
    const auto log = sizes("Log");
    QVERIFY(log.front().width() > 300);
    QCOMPARE(sizes("Log"), log);
    QCOMPARE(sizes("Play"), play);
    QCOMPARE(sizes(nullptr), play);
  }

  void aPerspectiveIsNamedShownByItsKeyAndDeleted() {
    EmptyDesk desk(home_);
    desk.choose("perspective.Processes");
    QCOMPARE(docks(desk, "scene"), std::size_t{0});
    desk.choose("view.image");
    DialogAnswer answer([](QDialog& dialog) {
      QTest::keyClicks(dialog.findChild<QLineEdit*>(), QStringLiteral("Mine"));
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    desk.choose("savePerspective");
    QVERIFY(answer.asked());
    QVERIFY(desk.find<QAction>("perspective.Mine").isChecked());
    desk.window.activateWindow();  // no window manager does it when the dialog closes
    QVERIFY(QTest::qWaitForWindowActive(&desk.window));
    QTest::keyClick(&desk.window, Qt::Key_1, Qt::ControlModifier);
    QVERIFY(desk.find<QAction>("perspective.Play").isChecked());
    QCOMPARE(docks(desk, "scene"), std::size_t{1});
    QVERIFY(!desk.find<QAction>("deletePerspective").isEnabled());
    desk.choose("perspective.Mine");
    QCOMPARE(docks(desk, "scene"), std::size_t{0});
    QCOMPARE(docks(desk, "image"), std::size_t{1});
    desk.choose("deletePerspective");
    QVERIFY(!desk.has("perspective.Mine"));
    QVERIFY(desk.find<QAction>("perspective.Play").isChecked());
  }

  void aViewThatIsOpenedHasTheKeyboard() {
    EmptyDesk desk(home_);
    desk.choose("view.search");
    QCOMPARE(desk.window.focusWidget(), &desk.find<QWidget>("searchWanted"));
    desk.choose("view.timing");
    const QWidget* const now = desk.window.focusWidget();
    QVERIFY(now != nullptr && desk.find<QWidget>("timingView").isAncestorOf(now));
  }

  void aPerspectiveIsPutBackToWhatIsShipped() {
    EmptyDesk desk(home_);
    desk.choose("another.image");
    QCOMPARE(docks(desk, "image"), std::size_t{2});
    desk.choose("resetPerspective");
    QCOMPARE(docks(desk, "image"), std::size_t{1});
  }

  void everyCommandThatIsDeclaredDoesSomething() {
    EmptyDesk desk(home_);
    for (const std::string& name : desk.workbench.commands().unattached()) QFAIL(name.c_str());
  }

  void aRefusalNamesTheFileAndGoesWhenItIsNoLongerTrue() {
    EmptyDesk desk(home_);
    bool fails = true;
    desk.workbench.commands().add(
        {"test.load", "", {}, [&fails](const auto&) -> robotlink::Result<void> {
           if (!fails) return {};
           return robotlink::failure("test", "it is damaged", {"/tables/a.c64", 0, 0});
         }});
    auto& actions = *desk.window.findChild<app::CommandActions*>();
    actions.run(QStringLiteral("test.load"));
    auto& bar = desk.find<QWidget>("errorBar");
    QVERIFY(bar.isVisible());
    QVERIFY(bar.findChild<QLabel*>()->text().contains(QStringLiteral("/tables/a.c64")));
    fails = false;
    actions.run(QStringLiteral("view.show"), {std::string("messages")});
    QVERIFY2(bar.isVisible(), "another command does not change that");
    actions.run(QStringLiteral("test.load"));
    QVERIFY(!bar.isVisible());
  }

  void aViewGetsAllTheRoomAndGivesItBack() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    const auto areas = desk.window.findChildren<ads::CDockAreaWidget*>();
    QVERIFY(areas.size() > 2);
    std::vector<QRect> before;
    for (const auto* area : areas) before.push_back(area->geometry());
    desk.choose("maximizeView");
    int shown = 0;
    for (const auto* area : areas) shown += area->isVisible() ? 1 : 0;
    QCOMPARE(shown, 1);
    desk.choose("maximizeView");
    for (int i = 0; i < areas.size(); ++i) {
      QVERIFY(areas[i]->isVisible() == !areas[i]->dockWidgets().isEmpty());
      QVERIFY2((areas[i]->size() - before[static_cast<std::size_t>(i)].size()).width() < 4, "as it was");
    }
    desk.choose("maximizeView");
    QVERIFY(!desk.window.docks().save().isEmpty());
    shown = 0;
    for (const auto* area : areas) shown += area->isVisible() ? 1 : 0;
    QVERIFY2(shown > 2, "what is saved has all views in it");
  }

  void theAppearanceIsChosenAndGivenBackToTheSystem() {
    EmptyDesk desk(home_);
    const auto lightness = [&desk] { return desk.window.palette().color(QPalette::Window).lightness(); };
    const int system = lightness();
    desk.choose(system < 128 ? "appearance.light" : "appearance.dark");
    QVERIFY(std::abs(lightness() - system) > 80);
    desk.choose("appearance.system");
    QCOMPARE(lightness(), system);
    QVERIFY(desk.find<QAction>("appearance.system").isChecked());
  }

  void helpShowsTheKeysAndWhatThisIs() {
    EmptyDesk desk(home_);
    QString said;
    const auto read = [&said](QDialog& dialog) {
      said = dynamic_cast<QMessageBox&>(dialog).text();
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    };
    QVERIFY(QTest::qWaitForWindowActive(&desk.window));
    DialogAnswer keys([&said](QDialog& dialog) {
      const auto* list = dialog.findChild<QTreeWidget*>(QStringLiteral("shortcutsList"));
      for (const QTreeWidgetItem* row :
           list->findItems(QStringLiteral("F5"), Qt::MatchExactly | Qt::MatchRecursive, 1))
        said += row->text(0);
      DialogAnswer::press(dialog, QDialogButtonBox::RejectRole);
    });
    QTest::keyClick(&desk.window, Qt::Key_F1, Qt::ShiftModifier);
    QVERIFY(keys.asked());
    QCOMPARE(said, QStringLiteral("Start"));
    DialogAnswer about(read);
    desk.choose("help.about");
    QVERIFY(about.asked());
    QVERIFY(said.contains(QStringLiteral("General Public License")));
  }

  void whatACommandRefusesIsShown() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& robots = desk.find<QComboBox>("robotBox");
    robots.addItem(QStringLiteral("nobody"));
    robots.setFocus();
    QTest::keyClick(&robots, Qt::Key_End);
    QVERIFY(desk.find<QLabel>("errorText").isVisible());
    QCOMPARE(desk.find<QLabel>("errorText").text(),
             QStringLiteral("there is no robot nobody; there is red1"));
  }

  void aRequestThatIsRefusedIsReportedInTheStatusLineIfNobodyElseDoes() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    robotcontrol::Request request;
    request.set_robot("nobody");
    request.mutable_stop()->set_engaged(true);
    desk.workbench.session().request(request);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.window.statusBar()->currentMessage().isEmpty(), kWaitMs);
    QVERIFY2(
        desk.window.statusBar()->currentMessage().startsWith(QStringLiteral("Refused (stop of nobody): ")),
        qPrintable(desk.window.statusBar()->currentMessage()));
  }
};

const widgets::test::GuiTest<MenusGuiTest> kMenusGuiTest;

}  // namespace app::test

#include "MenusGuiTest.moc"
