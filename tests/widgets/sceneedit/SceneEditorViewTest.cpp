// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEditorView.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSplitter>
#include <QTabBar>
#include <QTableView>
#include <QTextBlock>
#include <QToolButton>

#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/sceneedit/RoomBench.h"
#include "widgets/text/FindBar.h"
#include "widgets/world/SceneSelection.h"

namespace widgets::test {

class SceneEditorViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutAFileTheViewSaysHowToGetOne() {
    RoomBench bench;
    bench.view = bench.open<SceneEditorView>();
    QVERIFY(!child<QToolButton>(*bench.view, "sceneSave").isEnabled());
    QVERIFY(bench.text().isReadOnly());
    QCOMPARE(bench.refusal("scene.save"), std::string("scene.none"));
    QCOMPARE(bench.refusal("scene.edit"), std::string("scene.none"));
  }

  void aFileIsShownEditedAndSaved() {
    RoomBench bench;
    bench.show();
    QCOMPARE(bench.shown(), kRoom);
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("room.sdf"));
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" x"));
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("room.sdf*"));
    while (bench.text().document()->isUndoAvailable())
      QTest::keyClick(&bench.text(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.shown(), kRoom);
    QTest::keyClicks(&bench.text(), QStringLiteral("y"));
    QCOMPARE(bench.saved(), kRoom);
    click(*bench.view, "sceneSave");
    QCOMPARE(bench.saved(), bench.shown());
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("room.sdf"));
    keepPicture(*bench.view, "scene-editor");
  }

  void elementsAreProposedAndWrittenWhole() {
    RoomBench bench;
    bench.show();
    bench.setCursor("</model>\n");
    QTest::keyClicks(&bench.text(), QStringLiteral("<mod"));
    QCOMPARE(bench.proposals().currentIndex().data().toString(), QStringLiteral("model"));
    QTest::keyClick(&bench.proposals(), Qt::Key_Return);
    QVERIFY(QApplication::activePopupWidget() == nullptr);
    QTest::keyClicks(&bench.text(), QStringLiteral("chair"));
    QVERIFY2(bench.shown().find("</model>\n<model name=\"chair\"></model>  </world>") != std::string::npos,
             bench.shown().c_str());
  }

  void attributesAndModelsAreProposed() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<model name=\"desk\"");
    QTest::keyClicks(&bench.text(), QStringLiteral(" f"));
    QTest::keyClick(&bench.proposals(), Qt::Key_Return);
    QVERIFY(bench.shown().find("<model name=\"desk\" fixed=\"\">") != std::string::npos);
    bench.setCursor("<uri>model://");
    QTest::keyClick(&bench.text(), Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(bench.proposals().model()->rowCount(), 2);
    QTest::keyClick(&bench.proposals(), Qt::Key_Escape);
  }

  void tagsCloseThemselvesAndLinesAreIndented() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<link name=\"top\"/>");
    QTest::keyClick(&bench.text(), Qt::Key_Return);
    QTest::keyClicks(&bench.text(), QStringLiteral("<link name=\"leg\">"));
    QTest::keyClick(&bench.text(), Qt::Key_Return);
    QVERIFY2(bench.shown().find("      <link name=\"leg\">\n        \n      </link>\n") != std::string::npos,
             bench.shown().c_str());
    QTest::keyClick(&bench.text(), Qt::Key_Tab);
    QCOMPARE(bench.text().textCursor().block().text(), QString(10, QLatin1Char(' ')));
    QTest::keyClick(&bench.text(), Qt::Key_Backtab);
    QCOMPARE(bench.text().textCursor().block().text(), QString(8, QLatin1Char(' ')));
  }

  void errorsAndWarningsAreUnderlinedAndListed() {
    RoomBench bench;
    bench.show();
    QVERIFY(bench.waitForProblems(0));
    QVERIFY2(!bench.problems().isVisible(), "an empty table takes no room");
    const QAbstractItemModelTester tester(bench.problems().model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    bench.setCursor("<link name=\"top");
    QTest::keyClicks(&bench.text(), QStringLiteral(" wrong"));
    bench.setCursor("<world name=\"room");
    QTest::keyClicks(&bench.text(), QStringLiteral(" foreign"));
    QVERIFY(bench.waitForProblems(2));
    const auto marks = bench.text().extraSelections();
    QCOMPARE(marks.size(), 3);  // the current line, too
    QCOMPARE(marks[1].cursor.selectedText(), QStringLiteral("<world name=\"room foreign\">"));
    QCOMPARE(marks[2].cursor.selectedText(), QStringLiteral("<link name=\"top wrong\"/>"));
    QCOMPARE(marks[2].format.underlineStyle(), QTextCharFormat::WaveUnderline);
    QCOMPARE(child<QLabel>(*bench.view, "sceneProblemCount").text(),
             QStringLiteral("Errors: 1, warnings: 1"));
    keepPicture(*bench.view, "scene-editor-errors");
    const QRect cell = bench.problems().visualRect(bench.problems().model()->index(1, 1));
    QTest::mouseClick(bench.problems().viewport(), Qt::LeftButton, {}, cell.center());
    QCOMPARE(bench.line(), 8);
  }

  void fewProblemsTakeLittleOfALowView() {
    RoomBench bench;
    bench.show();
    bench.view->resize(700, 380);
    QVERIFY(bench.waitForProblems(0));
    const auto& halves = child<QSplitter>(*bench.view, "sceneHalves");
    QTRY_VERIFY(halves.sizes()[1] < halves.height() / 5);
    bench.setCursor("<link name=\"top");
    QTest::keyClicks(&bench.text(), QStringLiteral(" wrong"));
    QVERIFY(bench.waitForProblems(1));
    QTRY_VERIFY(bench.problems().isVisible());
    QTRY_VERIFY2(halves.sizes()[1] <= halves.height() / 3 + 1,
                 qPrintable(QStringLiteral("%1 of %2").arg(halves.sizes()[1]).arg(halves.height())));
    QVERIFY(bench.problems().viewport()->height() >= bench.problems().rowHeight(0) / 2);
  }

  void theMouseShowsErrorsAndWhatElementsMean() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<world name=\"room");
    QTest::keyClicks(&bench.text(), QStringLiteral(" foreign"));
    QVERIFY(bench.waitForProblems(1));
    const auto placeOf = [&](const char* word) {
      bench.setCursor(word);
      return bench.text().cursorRect().center() - QPoint(2, 0);
    };
    QCOMPARE(bench.text().errorAt(placeOf("<world")), QStringLiteral("this is ignored"));
    QVERIFY(shownTip(*bench.text().viewport(), placeOf("<link")).contains(QStringLiteral("rigid body")));
  }

  void textIsFoundAndReplaced() {
    RoomBench bench;
    bench.show();
    child<QAction>(*bench.view, "sceneFindAction").trigger();
    auto& bar = child<FindBar>(*bench.view, "findBar");
    QVERIFY(bar.isVisible());
    auto& sought = child<QLineEdit>(bar, "findText");
    QTest::keyClicks(&sought, QStringLiteral("NAME="));
    QTest::keyClick(&sought, Qt::Key_Return);
    QCOMPARE(bench.text().textCursor().selectedText(), QStringLiteral("name="));
    QCOMPARE(bench.line(), 2);
    QTest::keyClick(&sought, Qt::Key_Return);
    QCOMPARE(bench.line(), 7);
    QTest::keyClick(&sought, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(bench.line(), 2);
    QTest::keyClicks(&child<QLineEdit>(bar, "replaceText"), QStringLiteral("id="));
    child<QAction>(bar, "replaceAllAction").trigger();
    QCOMPARE(child<QLabel>(bar, "findOutcome").text(), QStringLiteral("Replaced: 3"));
    QVERIFY(bench.shown().find("name=") == std::string::npos);
    bench.text().undo();
    QCOMPARE(bench.shown(), kRoom);
    QTest::keyClick(&sought, Qt::Key_Escape);
    QVERIFY(!bar.isVisible());
  }

  void theSelectedObjectIsFoundInTheFileThatHasIt() {
    RoomBench bench;
    bench.simulate();
    bench.view = bench.open<SceneEditorView>({1000, 700});
    sceneSelection(bench.context).select("desk/link:top");
    child<QAction>(*bench.view, "sceneGoToAction").trigger();
    QCOMPARE(bench.bench().current()->path(), std::filesystem::canonical(bench.room));
    QCOMPARE(bench.text().textCursor().selectedText(), QStringLiteral("<link name=\"top\"/>"));
    QCOMPARE(bench.refusal("scene.edit rover1/head/camera"), std::string());
    QCOMPARE(bench.bench().current()->path(), std::filesystem::canonical(bench.rover));
    QCOMPARE(bench.text().textCursor().selectedText(), QStringLiteral("<sensor name=\"camera\"/>"));
    QCOMPARE(bench.refusal("scene.edit nothing"), std::string("scene.object"));
  }

  void anEditorThatIsOpenedLaterGoesToTheObject() {
    RoomBench bench;
    bench.simulate();
    QCOMPARE(bench.refusal("scene.edit desk/top"), std::string());
    bench.view = bench.open<SceneEditorView>({1000, 700});
    QCOMPARE(bench.text().textCursor().selectedText(), QStringLiteral("<link name=\"top\"/>"));
  }

  void theObjectAtTheCursorIsSelectedInTheScene() {
    RoomBench bench;
    bench.simulate();
    bench.view = bench.open<SceneEditorView>({1000, 700});
    QCOMPARE(bench.refusal("scene.edit rover1/head"), std::string());
    bench.setCursor("<sensor");
    QCOMPARE(child<QLabel>(*bench.view, "sceneObject").text(), QStringLiteral("rover1/head/camera"));
    const QSignalSpy selected(&sceneSelection(bench.context), &SceneSelection::changed);
    child<QAction>(*bench.view, "sceneSelectAction").trigger();
    QCOMPARE(sceneSelection(bench.context).object(), std::string("rover1/camera"));
    QCOMPARE(selected.size(), 1);
  }

  void includedModelsOpenInTabs() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<uri>");
    child<QAction>(*bench.view, "sceneOpenIncludedAction").trigger();
    QCOMPARE(bench.tabs().count(), 2);
    QCOMPARE(bench.shown(), kRover);
    bench.tabs().setCurrentIndex(0);
    QCOMPARE(bench.shown(), kRoom);
    Q_EMIT bench.tabs().tabCloseRequested(1);
    QCOMPARE(bench.tabs().count(), 1);
    QCOMPARE(bench.shown(), kRoom);
  }

  void savingAndRunningReloadsTheSimulationOfTheFile() {
    RoomBench bench;
    bench.simulate();
    bench.show();
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" "));
    click(*bench.view, "sceneRun");
    QCOMPARE(bench.reloads, 1);
    QCOMPARE(bench.saved(), bench.shown());
    QCOMPARE(bench.refusal("scene.edit " + bench.rover.string()), std::string());
    click(*bench.view, "sceneRun");
    QCOMPARE(bench.reloads, 2);  // its model counts, too
  }

  void aModelIsIncludedFromTheMenu() {
    RoomBench bench;
    bench.show();
    auto& menu = child<QMenu>(*bench.view, "sceneIncludeMenu");
    Q_EMIT menu.aboutToShow();
    child<QAction>(menu, "include.crate").trigger();
    QVERIFY(bench.shown().find("<uri>model://crate</uri>\n      <name>crate</name>") != std::string::npos);
    QVERIFY(bench.text().textCursor().selectedText().startsWith(QStringLiteral("<include>")));
  }

  void aNewRoomIsMadeByADialog() {
    RoomBench bench;
    bench.view = bench.open<SceneEditorView>({1000, 700});
    DialogAnswer answer([](QDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("newSceneName"));
      name->setText(QStringLiteral("two words"));
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
      QVERIFY(dialog.isVisible());
      QVERIFY(!dialog.findChild<QLabel*>(QStringLiteral("newSceneRefusal"))->text().isEmpty());
      name->setText(QStringLiteral("hall"));
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    click(*bench.view, "sceneNew");
    QVERIFY(answer.asked());
    QVERIFY2(bench.view->window()->focusWidget() == &bench.text(), "one goes on in the text");
    QVERIFY(bench.shown().find("<world name=\"hall\">") != std::string::npos);
    QVERIFY(bench.shown().find("rover") != std::string::npos);
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("hall.sdf*"));
    QCOMPARE(bench.refusal("scene.save"), std::string("scene.no-file"));
    QCOMPARE(bench.refusal("scene.save " + (bench.folder.path() / "hall.sdf").string()), std::string());
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("hall.sdf"));
  }

  void unsavedTextsAreRestoredAfterACrash() {
    const TestFolder user;
    std::string text;
    {
      RoomBench bench;
      bench.bench().startRecovery(user.path() / "scenes");
      bench.show();
      bench.setCursor("<sdf>");
      QTest::keyClicks(&bench.text(), QStringLiteral(" unsaved"));
      text = bench.shown();
      bench.bench().keepNow();
    }  // it ends without saving, and without asking
    RoomBench next;
    const QSignalSpy reported(&next.bench(), &SceneBench::reported);
    next.bench().startRecovery(user.path() / "scenes");
    QCOMPARE(reported.size(), 1);
    QCOMPARE(next.bench().current()->text().toStdString(), text);
    QVERIFY(next.bench().hasUnsaved());
    next.bench().forget();
    next.bench().keepNow();
    RoomBench last;
    last.bench().startRecovery(user.path() / "scenes");
    QVERIFY(last.bench().files().empty());
  }

  void thePlaceInATextIsKeptBehindOtherTabsAndForTheNextEditor() {
    RoomBench bench;
    bench.show();
    bench.view->resize(600, 220);
    QTRY_VERIFY(bench.text().verticalScrollBar()->maximum() > 2);
    bench.text().select(40, 80);
    bench.text().verticalScrollBar()->setValue(2);
    const TextPlace before = bench.text().place();
    QVERIFY(before.position != before.anchor);
    QCOMPARE(before.top, 2);
    QCOMPARE(bench.refusal("scene.edit " + bench.rover.string()), std::string());
    QVERIFY(!(bench.text().place() == before));
    QCOMPARE(bench.refusal("scene.edit " + bench.room.string()), std::string());
    QVERIFY(bench.text().place() == before);
    // As when the appearance is changed, for which all views are created again.
    bench.view.reset();
    bench.view = bench.open<SceneEditorView>({600, 220});
    QVERIFY(bench.text().place() == before);
    QTRY_COMPARE(bench.text().verticalScrollBar()->value(), 2);
  }

  void discardedChangesComeBackByUndo() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" mine"));
    const std::string mine = bench.shown();
    child<QAction>(*bench.view, "sceneDiscardAction").trigger();
    QCOMPARE(bench.shown(), kRoom);
    QCOMPARE(bench.tabs().tabText(0), QStringLiteral("room.sdf"));
    bench.text().undo();
    QCOMPARE(bench.shown(), mine);
  }

  void aTextWithoutAFileIsAskedAboutBeforeItIsDiscarded() {
    RoomBench bench;
    bench.view = bench.open<SceneEditorView>({1000, 700});
    bench.bench().startAnew(QStringLiteral("<sdf/>"), {});
    const auto discard = [&bench](QDialogButtonBox::ButtonRole role) {
      DialogAnswer answer([role](QDialog& dialog) { DialogAnswer::press(dialog, role); });
      child<QAction>(*bench.view, "sceneDiscardAction").trigger();
      QVERIFY(answer.asked());
    };
    discard(QDialogButtonBox::RejectRole);
    QCOMPARE(bench.tabs().count(), 1);
    discard(QDialogButtonBox::DestructiveRole);
    QCOMPARE(bench.tabs().count(), 0);
  }

  void aDocumentOutlivesTheView() {
    RoomBench bench;
    bench.show();
    bench.setCursor("<sdf>");
    QTest::keyClicks(&bench.text(), QStringLiteral(" kept"));
    const std::string text = bench.shown();
    bench.view.reset();
    bench.view = bench.open<SceneEditorView>({1000, 700});
    QCOMPARE(bench.shown(), text);
    while (bench.text().document()->isUndoAvailable()) bench.text().undo();
    QCOMPARE(bench.shown(), kRoom);
  }
};

const GuiTest<SceneEditorViewTest> kSceneEditorViewTest;

}  // namespace widgets::test

#include "SceneEditorViewTest.moc"
