// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does with a log in the main window: toolbar, menu, keys, opening. The test tells what the
// replay says.
#include <qtadvanceddocking/DockWidget.h>
#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>
#include <QUrl>
#include <QtTest>

#include "app/robotcontrol/bars/LogToolBar.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "colortool/table/ColorTableFile.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/app/ShortLog.h"
#include "tests/app/window/ReplayDesk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/log/OpenLogs.h"

namespace app::test {

using robotcontrol::ControlReplay;

namespace {

struct LogDesk : ReplayDesk {
  using ReplayDesk::ReplayDesk;

  void click(const char* action) { Desk::click(action, "logToolBar"); }
  std::vector<robotcontrol::Request> tables() const {
    std::vector<robotcontrol::Request> found;
    std::copy_if(requests.begin(), requests.end(), std::back_inserter(found),
                 [](const auto& request) { return request.has_set_color_table(); });
    return found;
  }
  void dropFile(const QString& file) {
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({200, 200}, Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &drop);
  }
};

}  // namespace

class LogWindowTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void theToolBarIsThereWhileALogIsOpen() {
    LogDesk desk(home_ / "bar");
    auto& bar = desk.find<QToolBar>("logToolBar");
    desk.window.tick();
    QVERIFY(!bar.isVisible());
    desk.openLog();
    QVERIFY(bar.isVisible());
    QCOMPARE(desk.find<QLineEdit>("logTime").text(), QStringLiteral("10.000"));
    QCOMPARE(desk.find<QLabel>("statusTime").text(), QStringLiteral("10.000 s  frame 309"));
    QCOMPARE(desk.find<QLineEdit>("logFrame").text(), QStringLiteral("309"));
    QVERIFY(desk.find<QLabel>("logFrames").text().contains(QStringLiteral("101 / 434")));
    QVERIFY(desk.find<QLabel>("logEnd").text().contains(QStringLiteral("30.000")));
    desk.status.clear_logs();
    desk.publish();
    QVERIFY(!bar.isVisible());
  }

  void allTimesAreSinceTheBeginningOrTimeStamps() {
    LogDesk desk(home_ / "stamps");
    desk.openLog();
    QCOMPARE(desk.workbench.session().timeline().origin(), robotlink::Instant(robotlink::fromSeconds(10)));
    desk.click("log.timeStamps");
    desk.window.tick();
    QCOMPARE(desk.workbench.session().timeline().origin(), robotlink::Instant());
    QCOMPARE(desk.find<QLineEdit>("logTime").text(), QStringLiteral("20.000"));
    QVERIFY(desk.find<QLabel>("logEnd").text().contains(QStringLiteral("40.000")));
    QCOMPARE(desk.find<QLabel>("statusTime").text(), QStringLiteral("20.000 s  frame 309"));
    auto& time = desk.find<QLineEdit>("logTime");
    time.setFocus();
    time.selectAll();
    QTest::keyClicks(&time, QStringLiteral("25.5"));
    QTest::keyClick(&time, Qt::Key_Return);
    QCOMPARE(desk.last().time(), ReplayDesk::at(25.5));
    desk.status.clear_logs();
    desk.publish();
    QCOMPARE(desk.workbench.session().timeline().origin(), robotlink::Instant());
  }

  void homeGoesToTheFirstImage() {
    LogDesk desk(home_ / "first");
    desk.status.set_start(ReplayDesk::at(11));
    desk.openLog();
    QTest::keyClick(&desk.window, Qt::Key_Home);
    QCOMPARE(desk.last().time(), ReplayDesk::at(11));
  }

  void itsButtonsPlayStopAndStep() {
    LogDesk desk(home_ / "buttons");
    desk.openLog();
    desk.click("log.playOrPause");
    QCOMPARE(desk.last().action(), ControlReplay::PLAY);
    desk.status.set_playing(true);
    desk.publish();
    desk.click("log.playOrPause");
    QCOMPARE(desk.last().action(), ControlReplay::PAUSE);
    desk.click("log.stop");
    QCOMPARE(desk.last().action(), ControlReplay::STOP);
    desk.click("log.frameOn");
    QCOMPARE(desk.last().action(), ControlReplay::STEP_FRAME);
    QCOMPARE(desk.last().count(), 1);
    desk.click("log.frameBack");
    QCOMPARE(desk.last().count(), -1);
    desk.click("log.loop");
    QVERIFY(desk.last().loop());
    desk.click("log.skipGaps");
    QVERIFY(desk.last().skip_gaps());
  }

  void itIsPausedByTheStopOfAllRobotsWhichNeedsNoRelease() {
    LogDesk desk(home_ / "stop");
    desk.workbench.session().setRobots({"nao"});
    desk.status.set_playing(true);
    desk.openLog();
    auto& stop = desk.find<QToolButton>("stopButton");
    for (int i = 0; i < 2; ++i) {
      desk.requests.clear();
      QTest::mouseClick(&stop, Qt::LeftButton);
      QCOMPARE(desk.requests.size(), std::size_t{1});
      QCOMPARE(desk.requests.front().robot(), std::string("nao"));
      QVERIFY(desk.requests.front().stop().engaged());
      desk.window.tick();
      QVERIFY(!stop.isChecked());
    }
  }

  void speedAndProcessAreChosenInTheirBoxes() {
    LogDesk desk(home_ / "boxes");
    desk.openLog();
    auto& speed = desk.find<QComboBox>("logSpeed");
    QCOMPARE(speed.currentText(), QStringLiteral("1×"));
    speed.setFocus();
    QTest::keyClick(&speed, Qt::Key_Down);
    QCOMPARE(desk.last().speed(), 2.0);
    auto& process = desk.find<QComboBox>("logProcess");
    process.setFocus();
    QTest::keyClick(&process, Qt::Key_Down);
    QCOMPARE(desk.last().step_process(), std::string("nao/motion"));
  }

  void timesAndFramesAreTyped() {
    LogDesk desk(home_ / "typed");
    desk.openLog();
    const auto type = [&](const char* field, const char* text) {
      auto& edit = desk.find<QLineEdit>(field);
      edit.setFocus();
      edit.selectAll();
      QTest::keyClicks(&edit, QLatin1String(text));
      QTest::keyClick(&edit, Qt::Key_Return);
    };
    type("logTime", "12.5");
    QCOMPARE(desk.last().action(), ControlReplay::JUMP_TO_TIME);
    QCOMPARE(desk.last().time(), ReplayDesk::at(22.5));
    type("logFrame", "17");
    QCOMPARE(desk.last().action(), ControlReplay::JUMP_TO_FRAME);
    QCOMPARE(desk.last().frame(), 17U);
    const auto requests = desk.asked.size();
    type("logTime", "soon");
    QCOMPARE(desk.asked.size(), requests);
    QVERIFY(desk.find<QLabel>("errorText").text().contains(QStringLiteral("soon")));
  }

  void keysPlayWhereverTheFocusDoesNotNeedThem() {
    LogDesk desk(home_ / "keys");
    desk.openLog();
    desk.window.setFocus();
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
      QTest::keyClick(&desk.window, key, modifiers);
    };
    press(Qt::Key_Space);
    QCOMPARE(desk.last().action(), ControlReplay::PLAY);
    press(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(desk.last().count(), 10);
    press(Qt::Key_I);
    QCOMPARE(desk.last().range().from(), ReplayDesk::at(20));
    press(Qt::Key_Home);
    QCOMPARE(desk.last().time(), ReplayDesk::at(10));
    const auto requests = desk.asked.size();
    auto& search = desk.find<QLineEdit>("keysSearch");
    search.setFocus();
    for (const auto key : {Qt::Key_Space, Qt::Key_Left, Qt::Key_Right, Qt::Key_Home, Qt::Key_End,
                           Qt::Key_Comma, Qt::Key_Period}) {
      QTest::keyClick(&search, key);
    }
    QTest::keyClicks(&search, QStringLiteral("bio.,"));
    QCOMPARE(desk.asked.size(), requests);
    QVERIFY(search.text().contains(QStringLiteral("bio.,")));
  }

  void keysPlayFromAFloatedDock() {
    LogDesk desk(home_ / "floated");
    desk.openLog();
    auto* dock = desk.window.docks().docks(QStringLiteral("field")).front();
    dock->setFloating();
    QVERIFY(dock->isFloating());
    QTest::keyClick(dock->widget(), Qt::Key_Space);
    QCOMPARE(desk.last().action(), ControlReplay::PLAY);
  }

  void everyKeyIsInTheMenuAndInATip() {
    LogDesk desk(home_ / "menu");
    desk.openLog();
    auto& menu = desk.find<QMenu>("logMenu");
    QStringList keys;
    for (const QAction* action : menu.actions()) {
      if (action->shortcut().isEmpty()) continue;
      keys << action->shortcut().toString();
      QVERIFY2(action->toolTip().contains(action->shortcut().toString(QKeySequence::NativeText)),
               qPrintable(action->text()));
    }
    for (const char* key : {"Space", "Left", "Right", "Shift+Left", "Shift+Right", "Home", "End", "I", "O",
                            "Ctrl+B", ",", "."}) {
      QVERIFY2(keys.contains(QLatin1String(key)), key);
    }
    desk.find<QAction>("log.toEnd").trigger();
    QCOMPARE(desk.last().time(), ReplayDesk::at(40));
    desk.find<QAction>("log.tenFramesBack").trigger();
    QCOMPARE(desk.last().count(), -10);
    desk.find<QAction>("log.rangeEnd").trigger();
    QCOMPARE(desk.last().range().from(), ReplayDesk::at(10));
  }

  void droppedFilesAreOpened() {
    LogDesk desk(home_ / "drop");
    desk.dropFile(QLatin1String(ReplayDesk::kFile));
    QTRY_VERIFY(desk.find<QLabel>("errorText").isVisible());  // it is not there, and that is said
    QVERIFY2(desk.find<QLabel>("errorText").text().contains(QLatin1String(ReplayDesk::kFile)),
             qPrintable(desk.find<QLabel>("errorText").text()));
  }

  void recentLogsAreRememberedOverRestarts() {
    const auto home = home_ / "recent";
    {
      LogDesk desk(home);
      QVERIFY(!desk.find<QMenu>("recentLogs").isEnabled());
      desk.openLog();
      QCOMPARE(desk.find<QMenu>("recentLogs").actions().size(), 1);
      desk.window.close();
    }
    LogDesk desk(home);
    auto& recent = desk.find<QMenu>("recentLogs");
    QCOMPARE(recent.actions().size(), 1);
    QCOMPARE(recent.actions().first()->toolTip(), QLatin1String(ReplayDesk::kFile));
    recent.actions().first()->trigger();
    QTRY_VERIFY(desk.find<QLabel>("errorText").text().contains(QLatin1String(ReplayDesk::kFile)));
  }

  void theDialogOpensWhatIsChosen() {
    LogDesk desk(home_ / "dialog");
    const QString file = QString::fromStdString((home_ / "empty.mcap").string());
    std::filesystem::create_directories(home_);
    QFile empty(file);
    QVERIFY(empty.open(QIODevice::WriteOnly));
    empty.close();
    desk.find<QAction>("openLog").trigger();
    auto& dialog = desk.find<QFileDialog>("openLogDialog");
    dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
    QTest::keyClick(dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit")), Qt::Key_Return);
    QTRY_VERIFY(desk.find<QLabel>("errorText").text().contains(QStringLiteral("empty.mcap")));
  }

  void aColorTableIsLoadedFromTheMenuOrDroppedAndTakenBack() {
    LogDesk desk(home_ / "table");
    const QString file = QString::fromStdString((home_ / "table/some.c64").string());
    QVERIFY(colortool::ColorTableFile().save(file.toStdString()).has_value());
    DialogAnswer early = DialogAnswer::file(file);
    desk.find<QAction>("robot.color-table").trigger();
    QVERIFY(desk.find<QLabel>("errorText").text().contains(QStringLiteral("there is no robot")));
    desk.workbench.session().setRobots({"nao"});
    DialogAnswer answer = DialogAnswer::file(file);
    desk.find<QAction>("robot.color-table").trigger();
    QCOMPARE(desk.tables().size(), std::size_t{1});
    QCOMPARE(desk.tables().back().robot(), std::string("nao"));
    QVERIFY(!desk.tables().back().set_color_table().table().cells().empty());
    desk.find<QAction>("robot.no-color-table").trigger();
    QCOMPARE(desk.tables().size(), std::size_t{2});
    QVERIFY(desk.tables().back().set_color_table().table().cells().empty());
    desk.dropFile(file);
    QCOMPARE(desk.tables().size(), std::size_t{3});
  }

  void theLogPerspectiveHasWhatOneNeeds() {
    LogDesk desk(home_ / "perspective");
    desk.find<QAction>("perspective.Log").trigger();
    for (const char* view :
         {"image", "time-line", "replay-packages", "log-streams", "bookmarks", "solutions", "messages"}) {
      QVERIFY2(desk.window.docks().docks(QLatin1String(view)).size() == 1, view);
    }
  }

  void bookmarksAreRenamedAndRemovedByTheirTexts() {
    LogDesk desk(home_ / "texts");
    const std::filesystem::path file = home_ / "texts" / "short.mcap";
    std::filesystem::create_directories(file.parent_path());
    QCOMPARE(ShortLog::write(file), std::string());
    desk.status.set_begin(ShortLog::time(0).time_since_epoch().count());
    desk.status.set_end(ShortLog::time(ShortLog::kFrames - 1).time_since_epoch().count());
    desk.status.add_logs()->set_path(file.string());
    desk.publish();
    const auto& logs = *desk.window.context().logs;
    QTRY_VERIFY_WITH_TIMEOUT((desk.window.tick(), logs.logs().front()->bookmarks.has_value()), kWaitMs);
    const auto text = [&logs](std::size_t i) { return logs.logs().front()->bookmarks->all()[i].text; };
    const auto& commands = desk.workbench.commands();
    QVERIFY(commands.runLine("log.bookmark 1 goal"));
    QVERIFY(commands.runLine("log.bookmark 2 corner"));
    QVERIFY(commands.runLine("log.rename-bookmark goal 'first goal'"));
    QCOMPARE(text(0), std::string("first goal"));
    const auto unknown = commands.runLine("log.remove-bookmark korner");
    QVERIFY(!unknown);
    QVERIFY(unknown.error().text.find("'corner'") != std::string::npos);
    QVERIFY(commands.runLine("log.remove-bookmark 'first goal'"));
    QCOMPARE(logs.logs().front()->bookmarks->all().size(), std::size_t{1});
    QCOMPARE(text(0), std::string("corner"));
  }

  void aBookmarkWithoutItsLogIsRefusedInWords() {
    LogDesk desk(home_ / "bookmark");
    const auto refused = desk.workbench.commands().runLine("log.bookmark 1 here");
    QVERIFY(!refused);
    QVERIFY(refused.error().text.find("open one first") != std::string::npos);
  }
};

const widgets::test::GuiTest<LogWindowTest> kLogWindowTest;

}  // namespace app::test

#include "LogWindowTest.moc"
