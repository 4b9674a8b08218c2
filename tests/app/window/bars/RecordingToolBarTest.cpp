// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/RecordingToolBar.h"

#include <QtTest>

#include "robotcontrol/Logging.pb.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {

using robotcontrol::RecordingStatus;

class RecordingToolBarTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whileNothingIsRecordedThatIsSaidOnce() {
    RecordingStatus status;
    QCOMPARE(RecordingToolBar::statusText(status), QStringLiteral("not recording"));
    status.set_failure("the disk is full");
    QCOMPARE(RecordingToolBar::statusText(status), QStringLiteral("recording failed"));
  }

  void aRecordingHasItsLengthAndSize() {
    RecordingStatus status;
    status.set_recording(true);
    status.set_seconds(72.9);
    status.set_bytes(8'400'000);
    QCOMPARE(RecordingToolBar::statusText(status), QStringLiteral("1:12  8.4 MB"));
    QCOMPARE(RecordingToolBar::lengthText(status), QStringLiteral("1:12 (8.4 MB)"));
    status.set_seconds(3600 + 60 + 1);
    QCOMPARE(RecordingToolBar::lengthText(status), QStringLiteral("61:01 (8.4 MB)"));
  }

  void whatIsKeptInMemoryIsSaidOnceThereIsSomething() {
    RecordingStatus status;
    status.set_keep_last(30);
    QCOMPARE(RecordingToolBar::statusText(status), QStringLiteral("not recording"));
    status.set_kept_seconds(9.99);
    QCOMPARE(RecordingToolBar::statusText(status), QStringLiteral("keeps 9 s"));
    status.set_keep_last(0);
    QVERIFY2(RecordingToolBar::statusText(status) == QStringLiteral("not recording"),
             "what is left of before is not kept");
  }

  void whatWasDroppedIsCounted() {
    RecordingStatus status;
    status.set_dropped_messages(1);
    QCOMPARE(RecordingToolBar::statusText(status), QStringLiteral("1 message dropped"));
    status.set_recording(true);
    status.set_dropped_messages(20);
    QVERIFY(RecordingToolBar::statusText(status).endsWith(QStringLiteral("  20 messages dropped")));
    status.set_failure("the disk is full");
    QVERIFY(!RecordingToolBar::statusText(status).contains(QStringLiteral("failed")));
  }
};

const widgets::test::GuiTest<RecordingToolBarTest> kRecordingToolBarTest;

}  // namespace app::test

#include "RecordingToolBarTest.moc"
