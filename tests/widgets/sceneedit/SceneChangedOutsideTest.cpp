// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files that another program changes while they are open in the editor.
#include <QSignalSpy>
#include <chrono>
#include <optional>

#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/sceneedit/RoomBench.h"

namespace widgets::test {

class SceneChangedOutsideTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aFileThatAnotherProgramHasChangedIsReadAgain() {
    RoomBench bench;
    bench.show();
    const std::string other = kRoom + "<!-- other -->\n";
    bench.folder.write("room.sdf", other);
    std::filesystem::last_write_time(bench.room,
                                     std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
    for (int i = 0; i < 40; ++i) bench.tick(*bench.view);
    QCOMPARE(bench.shown(), other);
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("room.sdf"));
  }

  void whoeverOpensAFileIsToldThatItWasChanged() {
    RoomBench bench;
    bench.show();
    const QSignalSpy reported(&bench.bench(), &SceneBench::reported);
    bench.folder.write("room.sdf", kRoom + "<!-- other -->\n");
    QVERIFY(bench.bench().ensure(bench.room).has_value());
    QCOMPARE(reported.size(), 1);
    QVERIFY(reported[0][0].toString().contains(QStringLiteral("reloaded")));
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" "));
    bench.folder.write("room.sdf", kRoom);
    for (int i = 0; i < 2; ++i) QVERIFY(bench.bench().open(bench.room).has_value());
    QVERIFY2(reported.size() == 2, "once");
    QVERIFY(reported[1][0].toString().contains(QStringLiteral("unsaved changes")));
  }

  void aTextFromOutsideIsReadOnceTheOwnChangesAreUndone() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" "));
    const std::string other = kRoom + "<!-- other -->\n";
    bench.folder.write("room.sdf", other);
    QVERIFY(bench.bench().ensure(bench.room).has_value());
    QVERIFY2(bench.shown() != other, "there are unsaved changes");
    bench.text().undo();
    QVERIFY(bench.bench().ensure(bench.room).has_value());
    QCOMPARE(bench.shown(), other);
  }

  void aFileInAnotherEncodingIsOverwrittenIfThatIsWanted() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" "));
    const std::string mine = bench.shown();
    bench.folder.write("room.sdf", "\xe4\xf6");
    DialogAnswer answer(
        [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::DestructiveRole); });
    click(*bench.view, "sceneSave");
    QVERIFY(answer.asked());
    QCOMPARE(bench.saved(), mine);
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("room.sdf"));
  }

  void savingUnderItsOwnNameAsksWhichTextToKeep() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" "));
    const std::string mine = bench.shown();
    bench.folder.write("room.sdf", kRoom + "<!-- other -->\n");
    std::optional<DialogAnswer> whether, which;
    const DialogAnswer name([&](QDialog& dialog) {
      dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(QStringLiteral("room.sdf"));
      // The file dialog asks whether to replace the file.
      whether.emplace([&](QDialog& box) {
        which.emplace([](QDialog& last) { DialogAnswer::press(last, QDialogButtonBox::DestructiveRole); });
        DialogAnswer::press(box, QDialogButtonBox::YesRole);
      });
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    child<QAction>(*bench.view, "sceneSaveAsAction").trigger();
    QVERIFY(which && which->asked());
    QCOMPARE(bench.saved(), mine);
  }

  void whatAnotherProgramHasWrittenIsNotOverwrittenUnasked() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" "));
    const std::string mine = bench.shown(), other = kRoom + "<!-- other -->\n";
    bench.folder.write("room.sdf", other);
    QCOMPARE(bench.refusal("scene.save"), std::string("scene.changed-outside"));
    QCOMPARE(bench.saved(), other);
    const auto answer = [&bench](QDialogButtonBox::ButtonRole role) {
      DialogAnswer given([role](QDialog& dialog) { DialogAnswer::press(dialog, role); });
      click(*bench.view, "sceneSave");
      QVERIFY(given.asked());
    };
    answer(QDialogButtonBox::RejectRole);
    QCOMPARE(bench.saved(), other);
    QCOMPARE(bench.shown(), mine);
    answer(QDialogButtonBox::AcceptRole);
    QCOMPARE(bench.shown(), other);
    bench.text().undo();
    QCOMPARE(bench.shown(), mine);
    bench.folder.write("room.sdf", kRoom);
    answer(QDialogButtonBox::DestructiveRole);
    QCOMPARE(bench.saved(), mine);
    QCOMPARE(bench.refusal("scene.save"), std::string());
  }
};

const GuiTest<SceneChangedOutsideTest> kSceneChangedOutsideTest;

}  // namespace widgets::test

#include "SceneChangedOutsideTest.moc"
