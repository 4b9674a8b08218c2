// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in the storage of a remote robot, as a person handles them.
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "tests/app/served/ServedHall.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/DialogAnswer.h"

namespace app::test {
namespace {

/// A desk that shows the recordings of a robot.
class RecordingsDesk : public EmptyDesk {
 public:
  explicit RecordingsDesk(const std::filesystem::path& home, const std::string& url) : EmptyDesk(home) {
    if (!url.empty() && !workbench.commands().run("remote.connect", {url, std::string()}))
      qFatal("cannot connect");
    choose("remote.recordings");
    find<QLineEdit>("recordingsFolder").setText(QString::fromStdString(home.string()));
  }
  void press(const char* button) { QTest::mouseClick(&find<QPushButton>(button), Qt::LeftButton); }
  bool isEnabled(const char* button) { return find<QPushButton>(button).isEnabled(); }
  QTreeWidget& list() { return find<QTreeWidget>("recordingsList"); }
  QString cell(int column) {
    return list().topLevelItemCount() == 0 ? QString() : list().topLevelItem(0)->text(column);
  }
  QString hint() {
    const auto& label = find<QLabel>("recordingsHint");
    return label.isVisible() ? label.text() : QString();
  }
  QString state() { return find<QLabel>("recordingsState").text(); }
};

}  // namespace

class RecordingsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aRobotRecordsAndItsRecordingIsFetchedOpenedAndDeleted() {
    const TestFolder robot;
    ServeOptions options;
    options.recordings = robot.path();
    const ServedHall hall(options);
    RecordingsDesk desk(home_, hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("recordingsStart"), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.hint().contains(QStringLiteral("no recordings yet")), kWaitMs);
    QVERIFY(desk.find<QComboBox>("recordingsRobot").currentText().contains(QStringLiteral("red1")));
    desk.press("recordingsStart");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(3), QStringLiteral("is being recorded"), kWaitMs);
    QVERIFY(!desk.isEnabled("recordingsStart"));
    QTRY_COMPARE_WITH_TIMEOUT(desk.hint(), QString(), kWaitMs);
    widgets::test::keepPicture(desk.find<QDialog>("recordingsDialog"), "recordings-running");
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("recordingsStop"), kWaitMs);
    desk.press("recordingsStop");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(3), QStringLiteral("whole"), kWaitMs);
    desk.list().setCurrentItem(desk.list().topLevelItem(0));
    QVERIFY(!desk.isEnabled("recordingsOpen"));
    desk.press("recordingsFetch");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(4), QStringLiteral("fetched"), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.state().contains(QStringLiteral("checksum")), kWaitMs);
    widgets::test::keepPicture(desk.find<QDialog>("recordingsDialog"), "recordings-fetched");
    DialogAnswer no([](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::NoRole); });
    desk.press("recordingsDelete");
    QVERIFY(no.asked());
    QCOMPARE(robot.files().size(), std::size_t{1});
    DialogAnswer yes([](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::YesRole); });
    const QString name = desk.cell(0);
    desk.press("recordingsDelete");
    QTRY_COMPARE_WITH_TIMEOUT(desk.list().topLevelItemCount(), 0, kWaitMs);
    QVERIFY(robot.files().empty());
    QVERIFY(std::filesystem::exists(home_ / name.toStdString()));
  }

  void whatWasFetchedIsOpenedAsALog() {
    const TestFolder robot;
    ServeOptions options;
    options.recordings = robot.path();
    const ServedHall hall(options);
    RecordingsDesk desk(home_, hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("recordingsStart"), kWaitMs);
    desk.press("recordingsStart");
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("recordingsStop"), kWaitMs);
    desk.press("recordingsStop");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(3), QStringLiteral("whole"), kWaitMs);
    desk.list().setCurrentItem(desk.list().topLevelItem(0));
    desk.press("recordingsFetch");
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("recordingsOpen"), kWaitMs);
    desk.press("recordingsOpen");
    QTRY_VERIFY_WITH_TIMEOUT(desk.workbench.loaded() != nullptr && desk.workbench.loaded()->isLogged(),
                             kWaitMs);
    QVERIFY(!desk.find<QDialog>("recordingsDialog").isVisible());
  }

  void whatIsMissingIsSaid() {
    RecordingsDesk alone(home_ / "alone", {});
    QTRY_VERIFY_WITH_TIMEOUT(alone.hint().contains(QStringLiteral("Connect")), kWaitMs);
    const ServedHall hall;
    RecordingsDesk desk(home_ / "desk", hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(desk.state().contains(QStringLiteral("--recordings")), kWaitMs);
    QVERIFY(!desk.isEnabled("recordingsStart"));
    QVERIFY(!desk.isEnabled("recordingsFetch"));
  }
};

const widgets::test::GuiTest<RecordingsGuiTest> kRecordingsGuiTest;

}  // namespace app::test

#include "RecordingsGuiTest.moc"
