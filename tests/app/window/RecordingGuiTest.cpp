// SPDX-License-Identifier: GPL-3.0-or-later
// Recording as a person does it: the toolbar, its menu and its dialogs, in a window in which a robot plays.
#include <QAction>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>
#include <fstream>

#include "app/robotcontrol/actions/StreamChooser.h"
#include "app/robotcontrol/bars/RecordingToolBar.h"
#include "foxglove/Event.pb.h"
#include "logplayer/base/RecordedStreams.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/logplayer/RecordedMessages.h"
#include "tests/widgets/DialogAnswer.h"

namespace app::test {

using logplayer::tests::ReadLog;
using logplayer::tests::TestFolder;
using robotcontrol::ControlRecording;

namespace {

class RecordingDesk : public Desk {
 public:
  using Desk::Desk;

  bool plays() {
    if (workbench.loaded() == nullptr) return false;
    if (!started_) started_ = workbench.commands().runLine("simulation.start").has_value();
    return workbench.session().timeline().newest() > robotlink::Instant(std::chrono::milliseconds(200));
  }
  robotcontrol::RecordingStatus status() { return workbench.recording().status(); }
  void run(const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    QVERIFY2(done.has_value(), done ? "" : done.error().text.c_str());
  }
  QMenu& menu() { return find<QMenu>("recordingMenu"); }
  /// Clicks an entry of the record button's menu, or of one of its submenus.
  void choose(const char* action, const char* submenu = nullptr) {
    QMenu& in = submenu != nullptr ? find<QMenu>(submenu) : menu();
    auto* entry = window.findChild<QAction*>(QLatin1String(action));
    QVERIFY2(entry != nullptr && entry->isEnabled(), action);
    in.popup({10, 10});
    QVERIFY(QTest::qWaitForWindowExposed(&in));
    QTest::mouseClick(&in, Qt::LeftButton, {}, in.actionGeometry(entry).center());
  }
  void clickButton(const char* action) { click(action, "recordingToolBar"); }
  QString shown() { return find<QLabel>("recordingStatus").text(); }

 private:
  bool started_ = false;
};

std::string only(const TestFolder& folder) {
  const auto files = folder.files();
  return files.size() == 1 ? files[0] : "";
}

}  // namespace

class RecordingGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void theButtonStartsAndStopsAndShowsWhatIsDone() {
    const TestFolder folder;
    RecordingDesk desk(home_ / "button");
    desk.run("recording.folder " + folder.path().string());
    QTRY_VERIFY_WITH_TIMEOUT(desk.plays(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.shown().startsWith(QStringLiteral("keeps")), kWaitMs);
    QCOMPARE(desk.status().keep_last(), 30.0);
    auto& button = child<QToolButton>(desk.window, "recordButton");
    QTest::mouseClick(&button, Qt::LeftButton, {}, {10, button.height() / 2});
    QVERIFY(desk.status().recording());
    QTRY_VERIFY_WITH_TIMEOUT(desk.status().messages() > 500, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.shown().contains(QStringLiteral(" MB")) && desk.shown().startsWith(QStringLiteral("0:0")),
        kWaitMs);
    QVERIFY(button.isChecked());
    QCOMPARE(button.text(), QStringLiteral("End recording"));
    const QString file = QString::fromStdString(only(folder));
    auto& name = child<QLabel>(desk.window, "recordingFile");
    QVERIFY(name.isVisible());
    QVERIFY(name.toolTip().endsWith(file));
    QVERIFY(!child<QWidget>(desk.window, "recordedBar").isVisible());
    widgets::test::keepPicture(desk.window, "recording");
    QTest::mouseClick(&button, Qt::LeftButton, {}, {10, button.height() / 2});
    QVERIFY(!desk.status().recording());
    QTRY_VERIFY_WITH_TIMEOUT(child<QWidget>(desk.window, "recordedBar").isVisible(), kWaitMs);
    QVERIFY(child<QLabel>(desk.window, "recordedText").text().contains(file));
    QVERIFY(name.text().startsWith(QStringLiteral("last: ")) && name.toolTip().endsWith(file));
    QCOMPARE(button.text(), QStringLiteral("Record"));
    widgets::test::keepPicture(desk.window, "recorded");
    desk.workbench.recording().recorder().finish();
    const ReadLog log = logplayer::tests::readLog(folder / only(folder));
    QVERIFY(log.complete);
    QVERIFY(log.count("red1/joints/states") > 20);
    QVERIFY(log.count("red1/program") > 0);
    QVERIFY(log.count("simulation") > 0);
    QVERIFY(child<QLabel>(desk.window, "recordingStatus")
                .toolTip()
                .contains(QString::fromStdString(only(folder))));
  }

  void whatWasRecordedIsOpenedAndItsFolderShown() {
    const TestFolder folder;
    RecordingDesk desk(home_ / "recorded");
    desk.run("recording.folder " + folder.path().string());
    QTRY_VERIFY_WITH_TIMEOUT(desk.plays(), kWaitMs);
    desk.run("recording.start");
    QTRY_VERIFY_WITH_TIMEOUT(desk.status().messages() > 500, kWaitMs);
    desk.window.tick();
    desk.run("recording.stop");
    QTRY_VERIFY_WITH_TIMEOUT(child<QWidget>(desk.window, "recordedBar").isVisible(), kWaitMs);
    QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "showUrl");
    click(child<QToolButton>(desk.window, "recordedFolder"));
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    QCOMPARE(shown_, QUrl::fromLocalFile(QString::fromStdString(folder.path().string())));
    click(child<QToolButton>(desk.window, "recordedOpen"));
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.workbench.loaded() != nullptr && desk.workbench.loaded()->sources.size() == 1, kWaitMs);
    QVERIFY(!child<QWidget>(desk.window, "recordedBar").isVisible());
    QVERIFY(!child<QLabel>(desk.window, "errorText").isVisible());
  }

  void whatStopsRobotsStandsApartFromWhatEndsARecording() {
    const TestFolder folder;
    RecordingDesk desk(home_ / "apart");
    desk.window.resize(1280, 720);
    QTRY_VERIFY_WITH_TIMEOUT(desk.plays(), kWaitMs);
    desk.run("recording.start-file " + (folder.path() / "a-name-that-is-rather-long.mcap").string());
    desk.run("robot.stop true");
    auto& stop = child<QToolButton>(desk.window, "stopButton");
    QTRY_COMPARE_WITH_TIMEOUT(stop.text(), QStringLiteral("STOPPED: click to release"), kWaitMs);
    desk.window.tick();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QCoreApplication::processEvents();
    const auto& record = child<QToolButton>(desk.window, "recordButton");
    QCOMPARE(record.text(), QStringLiteral("End recording"));
    const QRect there(stop.mapTo(&desk.window, QPoint(0, 0)), stop.size());
    QVERIFY(there.width() >= stop.sizeHint().width());
    QVERIFY2(there.right() > 1280 - 40 && there.right() < 1280, qPrintable(QString::number(there.right())));
    const int end = record.mapTo(&desk.window, QPoint(record.width(), 0)).x();
    QVERIFY2(there.left() - end > 40, qPrintable(QStringLiteral("%1 to %2").arg(end).arg(there.left())));
    desk.run("recording.stop");
  }

  void theLastSecondsAreKeptUnlessOneDoesNotWantIt() {
    const auto home = home_ / "kept";
    {
      RecordingDesk desk(home, Desk::Opens::kNothing);
      QCOMPARE(desk.status().keep_last(), 30.0);
      desk.run("recording.keep 0");
    }
    RecordingDesk desk(home, Desk::Opens::kNothing);
    QCOMPARE(desk.status().keep_last(), 0.0);
    desk.window.tick();
    QCOMPARE(desk.shown(), QStringLiteral("not recording"));
  }

  void keysRecordMarkAndSaveTheLastSeconds() {
    const TestFolder folder;
    RecordingDesk desk(home_ / "keys");
    desk.run("recording.folder " + folder.path().string());
    QTRY_VERIFY_WITH_TIMEOUT(desk.plays(), kWaitMs);
    QTest::keyClick(&desk.window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(desk.status().recording());
    const std::string recorded = only(folder);
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.window.findChild<QAction*>(QStringLiteral("recording.bookmark"))->isEnabled(), kWaitMs);
    DialogAnswer answer([](QDialog& dialog) {
      QTest::keyClicks(dialog.findChild<QLineEdit*>(), QStringLiteral("ball missed"));
      QTest::keyClick(&dialog, Qt::Key_Return);
    });
    QTest::keyClick(&desk.window, Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(answer.asked());
    desk.choose("recording.keep.10", "recording.keep");
    QCOMPARE(desk.status().keep_last(), 10.0);
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.status().kept_seconds() > 0.1 && desk.shown().contains(QStringLiteral("keeps")), kWaitMs);
    QTest::keyClick(&desk.window, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(folder.files().size(), std::size_t{2}, kWaitMs);
    QTest::keyClick(&desk.window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!desk.status().recording());
    desk.workbench.recording().recorder().finish();
    const ReadLog log = logplayer::tests::readLog(folder / recorded);
    QCOMPARE(log.count("bookmarks"), std::size_t{1});
    for (const auto& entry : log.entries) {
      if (entry.path == "bookmarks") QVERIFY(entry.data.find("ball missed") != std::string::npos);
    }
    QVERIFY(logplayer::tests::readLog(desk.status().saved_path()).count("red1/joints/states") > 10);
  }

  void buttonsSaveAndMark() {
    const TestFolder folder;
    RecordingDesk desk(home_ / "buttons");
    desk.run("recording.folder " + folder.path().string());
    desk.run("recording.keep 5");
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.plays() && desk.window.findChild<QAction*>(QStringLiteral("recording.save-last"))->isEnabled(),
        kWaitMs);
    desk.clickButton("recording.save-last");
    desk.workbench.recording().recorder().finish();
    QCOMPARE(folder.files().size(), std::size_t{1});
    DialogAnswer answer([](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
    desk.clickButton("recording.bookmark");
    QVERIFY(answer.asked());
    desk.workbench.recording().recorder().finish();
    QCOMPARE(folder.files().size(), std::size_t{2});
    QCOMPARE(logplayer::tests::readLog(desk.status().saved_path()).count("bookmarks"), std::size_t{1});
  }

  void whatIsChosenInTheMenuHoldsAfterARestart() {
    const TestFolder folder;
    const auto home = home_ / "choices";
    {
      RecordingDesk desk(home, Desk::Opens::kNothing);
      desk.choose("recording.images.jpeg", "recording.images");
      desk.choose("recording.compression.zstd", "recording.compression");
      desk.choose("recording.keep.30", "recording.keep");
      DialogAnswer trigger([](QDialog& dialog) {
        auto* field = dialog.findChild<QLineEdit*>();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("*/plots/lost"));
        QTest::keyClick(&dialog, Qt::Key_Return);
      });
      desk.choose("recording.trigger");
      QVERIFY(trigger.asked());
      DialogAnswer streams([](QDialog& dialog) {
        QTest::keyClicks(&child<QLineEdit>(dialog, "streamPatterns"), QStringLiteral("red1/*,-*/log"));
        QTest::keyClick(&dialog, Qt::Key_Return);
      });
      desk.choose("recording.streams");
      QVERIFY(streams.asked());
      auto chosen = DialogAnswer::file(QString::fromStdString(folder.path().string()));
      desk.choose("recording.folder");
      QVERIFY(chosen.asked());
    }
    RecordingDesk desk(home, Desk::Opens::kNothing);
    const auto status = desk.status();
    QCOMPARE(status.image_coding(), ControlRecording::JPEG);
    QCOMPARE(status.compression(), ControlRecording::ZSTD);
    QCOMPARE(status.keep_last(), 30.0);
    QCOMPARE(status.trigger(), std::string("*/plots/lost"));
    QCOMPARE(logplayer::textOf(status.selection()), std::string("red1/*,-*/log"));
    QCOMPARE(desk.workbench.recording().folder(), folder.path());
    desk.window.tick();
    QVERIFY(desk.window.findChild<QAction*>(QStringLiteral("recording.images.jpeg"))->isChecked());
    QVERIFY(desk.window.findChild<QAction*>(QStringLiteral("recording.keep.30"))->isChecked());
    QVERIFY(desk.window.findChild<QAction*>(QStringLiteral("recording.compression.zstd"))->isChecked());
    QVERIFY(desk.window.findChild<QAction*>(QStringLiteral("recording.trigger"))
                ->text()
                .contains(QStringLiteral("lost")));
  }

  void whatCannotBeDoneIsSaid() {
    RecordingDesk desk(home_ / "refused", Desk::Opens::kNothing);
    QVERIFY(!desk.window.findChild<QAction*>(QStringLiteral("recording.save-last"))->isEnabled());
    QVERIFY(!desk.window.findChild<QAction*>(QStringLiteral("recording.bookmark"))->isEnabled());
    for (const char* line :
         {"recording.stop", "recording.save-last", "recording.bookmark x", "recording.images gif",
          "recording.compression zip", "recording.keep -1", "recording.streams a,,b",
          "recording.folder /no/such/folder", "recording.start-file /no/such/folder/a.mcap"}) {
      QVERIFY2(!desk.workbench.commands().runLine(line).has_value(), line);
    }
    desk.run("recording.folder " + home_.string());
    std::filesystem::create_directories(home_ / "gone");
    desk.run("recording.folder " + (home_ / "gone").string());
    std::filesystem::remove(home_ / "gone");
    std::ofstream(home_ / "gone") << "a file in its place";
    QTest::keyClick(&desk.window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(child<QLabel>(desk.window, "errorText").isVisible());
    desk.window.tick();
    QVERIFY(!child<QToolButton>(desk.window, "recordButton").isChecked());
  }

  void streamsAreTickedAndThePatternsSayTheSame() {
    const std::vector<std::string> known{"red1/camera/image", "red1/images/x", "red1/log", "scene"};
    app::StreamChooser chooser({}, known, nullptr);
    chooser.show();
    QVERIFY(QTest::qWaitForWindowExposed(&chooser));
    auto& list = child<QListWidget>(chooser, "streamList");
    auto& patterns = child<QLineEdit>(chooser, "streamPatterns");
    const auto ticked = [&list] {
      std::string rows;
      for (int row = 0; row < list.count(); ++row)
        rows += list.item(row)->checkState() == Qt::Checked ? 'x' : '-';
      return rows;
    };
    const auto tick = [&list](int row) {
      list.setCurrentRow(row);
      QTest::keyClick(&list, Qt::Key_Space);
    };
    QCOMPARE(ticked(), std::string("x-xx"));
    tick(2);
    QCOMPARE(patterns.text(), QStringLiteral("-red1/log"));
    tick(1);
    QCOMPARE(ticked(), std::string("xx-x"));
    QCOMPARE(patterns.text(), QStringLiteral("*,-red1/log"));
    patterns.clear();
    QTest::keyClicks(&patterns, QStringLiteral("red1/*"));
    QCOMPARE(ticked(), std::string("xxx-"));
    tick(3);
    QCOMPARE(patterns.text(), QStringLiteral("red1/*,scene"));
    tick(3);
    QCOMPARE(patterns.text(), QStringLiteral("red1/*"));
    QTest::keyClicks(&patterns, QStringLiteral(",,"));
    QVERIFY(!child<QLabel>(chooser, "streamProblem").text().isEmpty());
    QVERIFY(!chooser.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    widgets::test::keepPicture(chooser, "chooser");
  }

  void theTextBesideTheButtonSaysWhatWasLeftOut() {
    robotcontrol::RecordingStatus status;
    status.set_recording(true);
    status.set_seconds(75.9);
    status.set_bytes(12'340'000);
    status.set_keep_last(10);
    status.set_kept_seconds(7.7);
    status.set_dropped_messages(3);
    QCOMPARE(app::RecordingToolBar::statusText(status),
             QStringLiteral("1:15  12.3 MB  keeps 7 s  3 messages dropped"));
    status.set_dropped_messages(1);
    QVERIFY(app::RecordingToolBar::statusText(status).endsWith(QStringLiteral("1 message dropped")));
    status = {};
    status.set_failure("the disk is full");
    QCOMPARE(app::RecordingToolBar::statusText(status), QStringLiteral("recording failed"));
  }

 public Q_SLOTS:
  void showUrl(const QUrl& url) { shown_ = url; }

 private:
  QUrl shown_;
};

const widgets::test::GuiTest<RecordingGuiTest> kRecordingGuiTest;

}  // namespace app::test

#include "RecordingGuiTest.moc"
