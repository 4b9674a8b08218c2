// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionEditorView.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTableView>
#include <QTextBlock>
#include <QToolButton>
#include <fstream>

#include "robotlink/base/AtomicFile.h"
#include "tests/robotlink/motions/CmpackBytes.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/motions/MotionBenchSetup.h"
#include "widgets/motions/KeyFrameModel.h"
#include "widgets/motions/MotionTextEdit.h"
#include "widgets/motions/MotionTimeLine.h"

namespace widgets::test {

using robotcontrol::MotionRequest;

namespace {

/// A bench with the motion wave in the editor, from a file.
struct WaveBench : JointBench {
  WaveBench() : file(folder.write("wave.mof", kWave)) {
    QCOMPARE(refusal("motion.open " + file.string()), std::string());
    view = open<MotionEditorView>({1000, 500});
    tick(*view);
  }
  QTableView& table() const { return child<QTableView>(*view, "motionTable"); }
  MotionTextEdit& text() const { return child<MotionTextEdit>(*view, "motionText"); }
  MotionTimeLine& timeLine() const { return child<MotionTimeLine>(*view, "motionTimeLine"); }
  QString errors() const { return child<QLabel>(*view, "motionErrors").text(); }
  QString state() const { return child<QLabel>(*view, "motionState").text(); }
  QString cell(int row, int column) const { return table().model()->index(row, column).data().toString(); }
  /// Types into a cell of the table.
  void type(int row, int column, const QString& value) {
    table().setCurrentIndex(table().model()->index(row, column));
    table().setFocus();
    QTest::keyClick(&table(), Qt::Key_F2);
    auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    if (editor == nullptr) qFatal("the cell is not edited");
    editor->selectAll();
    QTest::keyClicks(editor, value);
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents();  // the editor commits later
    tick(*view);
  }
  /// Sets the cursor behind a text in a line, from 1.
  void setCursor(int line, const QString& behind) {
    QTextCursor cursor(text().document()->findBlockByNumber(line - 1));
    const int at = cursor.block().text().indexOf(behind) + behind.size();
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, at);
    text().setTextCursor(cursor);
    text().setFocus();
  }
  std::string savedText() const { return robotlink::readFile(file).value_or(""); }
  const std::filesystem::path file;
  std::unique_ptr<MotionEditorView> view;
};

}  // namespace

class MotionEditorViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theNextEditorBeginsWhereTheOneBeforeWas() {
    WaveBench bench;
    bench.setCursor(4, QStringLiteral("10  20"));
    const TextPlace before = bench.text().place();
    QVERIFY(before.position > 0);
    bench.view.reset();
    bench.view = bench.open<MotionEditorView>({1000, 500});
    QVERIFY(bench.text().place() == before);
  }

  void withoutAMotionTheViewSaysHowToGetOne() {
    JointBench bench;
    auto view = bench.open<MotionEditorView>();
    QVERIFY(!child<QToolButton>(*view, "motionSave").isEnabled());
    QVERIFY(!child<QToolButton>(*view, "motionPlay").isEnabled());
    QCOMPARE(bench.refusal("motion.play"), std::string("motion.none"));
    DialogAnswer answer([](QDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>();
      name->setText(QStringLiteral("bow"));
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    click(*view, "motionNew");
    QVERIFY(answer.asked());
    QCOMPARE(bench.row(1), std::string("motion_id = bow"));
    QCOMPARE(bench.row(2), std::string("joints = headPan legFL1 legFR1"));
  }

  void aMotionIsShownAsTextTableAndTimeLine() {
    WaveBench bench;
    const QAbstractItemModelTester tester(bench.table().model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(bench.text().toPlainText().toStdString(), kWave);
    QCOMPARE(bench.table().model()->rowCount(), 2);
    QCOMPARE(bench.cell(1, KeyFrameModel::kBegin), QStringLiteral("300"));
    QCOMPARE(bench.cell(1, KeyFrameModel::kFirstJoint + 2), QStringLiteral("-"));
    QCOMPARE(child<QLabel>(*bench.view, "motionTitle").text(), QStringLiteral("wave.mof"));
    QCOMPARE(bench.state(), QStringLiteral("red1 has this motion"));
    keepPicture(*bench.view, "motion-editor");
  }

  void theTableEditsTheTextAndKeepsItsComments() {
    WaveBench bench;
    bench.type(0, KeyFrameModel::kFirstJoint, QStringLiteral("-45.5"));
    QCOMPARE(bench.row(4), std::string("-45.5  20  30  1 300 // up"));
    bench.type(1, KeyFrameModel::kDuration, QStringLiteral("1200"));
    QCOMPARE(bench.row(5), std::string(" -10   *   -  0 1200"));
    bench.type(1, KeyFrameModel::kInterpolation, QStringLiteral("3"));
    bench.type(1, KeyFrameModel::kFirstJoint + 1, QStringLiteral("*"));
    QCOMPARE(bench.row(5), std::string(" -10   *   -  3 1200"));
    QCOMPARE(bench.text().toPlainText().toStdString(), bench.bench().document().text());
    bench.type(0, KeyFrameModel::kFirstJoint, QStringLiteral("300"));
    QVERIFY(bench.state().contains(QStringLiteral("neither an angle")));
    QCOMPARE(bench.cell(0, KeyFrameModel::kFirstJoint), QStringLiteral("-45.5"));
    for (int i = 0; i < 3; ++i) click(*bench.view, "motionUndo");
    QCOMPARE(bench.bench().document().text(), kWave);
    QVERIFY(!motionFiles(bench.context).changed());
    click(*bench.view, "motionRedo");
    QCOMPARE(bench.row(4), std::string("-45.5  20  30  1 300 // up"));
  }

  void typingIsReadAtOnceAndErrorsAreUnderlined() {
    WaveBench bench;
    bench.setCursor(4, QStringLiteral("  20"));
    QTest::keyClicks(&bench.text(), QStringLiteral("x"));
    QCOMPARE(bench.row(4), std::string("  10  20x  30  1 300 // up"));
    QCOMPARE(bench.errors(), QStringLiteral("Line 4: '20x' is neither an angle nor '*', '~' or '-'"));
    const auto marks = bench.text().extraSelections();
    QCOMPARE(marks.size(), 2);  // the current line, and the error
    QCOMPARE(marks[1].cursor.selectedText(), QStringLiteral("20x"));
    QCOMPARE(marks[1].format.underlineStyle(), QTextCharFormat::WaveUnderline);
    QVERIFY(!child<QToolButton>(*bench.view, "motionSend").isEnabled());
    keepPicture(*bench.view, "motion-editor-error");
    QTest::keyClick(&bench.text(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.bench().document().text(), kWave);
    QCOMPARE(bench.text().toPlainText().toStdString(), kWave);
    QCOMPARE(bench.errors(), QString());
  }

  void whatTheRobotsOtherMotionsDoNotAllowIsAnErrorToo() {
    WaveBench bench;
    bench.setCursor(6, QStringLiteral("extern start"));
    QTest::keyClicks(&bench.text(), QStringLiteral("ing"));
    QCOMPARE(bench.errors(), QStringLiteral("Line 6: the motion 'extern' has no label 'starting'"));
    const auto marks = bench.text().extraSelections();
    QCOMPARE(marks.back().cursor.selectedText(), QStringLiteral("transition allMotions extern starting"));
  }

  void textTableAndTimeLineSelectTheSameKeyFrame() {
    WaveBench bench;
    bench.setCursor(5, QStringLiteral("-10"));
    QCOMPARE(bench.table().currentIndex().row(), 1);
    clickCellOf(bench.table(), 0, KeyFrameModel::kFirstJoint + 1);
    QCOMPARE(bench.text().textCursor().blockNumber(), 3);
    auto& line = bench.timeLine();
    const int x = static_cast<int>(line.placeOf(std::chrono::milliseconds(350)));
    QTest::mouseClick(&line, Qt::LeftButton, {}, {x, line.height() / 2});
    QCOMPARE(bench.bench().frame(), 1);
    QCOMPARE(bench.text().textCursor().blockNumber(), 4);
    QTest::keyClick(&line, Qt::Key_Left);
    QCOMPARE(bench.bench().frame(), 0);
    QTest::keyClick(&line, Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(bench.cell(0, KeyFrameModel::kDuration), QStringLiteral("308"));
  }

  void draggingTheEndOfAKeyFrameIsOneStep() {
    WaveBench bench;
    auto& line = bench.timeLine();
    const auto at = [&](int ms) {
      return QPoint(static_cast<int>(line.placeOf(std::chrono::milliseconds(ms))), line.height() / 2);
    };
    const QPoint from = at(300), to = at(200);
    drag(line, Qt::LeftButton, from, to);
    const int duration = bench.cell(0, KeyFrameModel::kDuration).toInt();
    QVERIFY2(std::abs(duration - 200) < 5, qPrintable(QString::number(duration)));
    QCOMPARE(bench.bench().undoStack().count(), 1);
    click(*bench.view, "motionUndo");
    QCOMPARE(bench.bench().document().text(), kWave);
  }

  void keyFramesAreDuplicatedMovedAndRemoved() {
    WaveBench bench;
    bench.bench().setFrame(0);
    click(*bench.view, "motionAddFrame");
    QCOMPARE(bench.bench().frames().size(), std::size_t{3});
    QCOMPARE(bench.bench().frame(), 1);
    child<QAction>(*bench.view, "motionDownAction").trigger();
    QCOMPARE(bench.bench().frame(), 2);
    QCOMPARE(bench.cell(1, KeyFrameModel::kDuration), QStringLiteral("100"));
    click(*bench.view, "motionRemoveFrame");
    QCOMPARE(bench.bench().document().text(), kWave);
  }

  void mirroringExchangesTheSides() {
    WaveBench bench;
    click(*bench.view, "motionMirror");
    QCOMPARE(bench.row(4), std::string(" -10  30  20  1 300 // up"));
    QCOMPARE(bench.row(5), std::string("  10   -   *  0 100"));
    click(*bench.view, "motionMirror");
    QCOMPARE(bench.row(4), std::string("  10  20  30  1 300 // up"));
  }

  void aMotionIsSentAndTheStateFollowsTheRobot() {
    WaveBench bench;
    bench.type(0, KeyFrameModel::kDuration, QStringLiteral("500"));
    QCOMPARE(bench.state(), QStringLiteral("red1 has a different version of this motion"));
    click(*bench.view, "motionSend");
    const auto request = bench.sentMotion();
    QCOMPARE(request.robot(), std::string("red1"));
    QCOMPARE(request.set_motion().motion().name(), std::string("wave"));
    QCOMPARE(request.set_motion().motion().text(), bench.bench().document().text());
    QCOMPARE(bench.state(), QStringLiteral("Sending to red1…"));
    bench.answer(request, false, "wave.mof:4:1: no");
    bench.tick(*bench.view);
    QCOMPARE(bench.state(), QStringLiteral("red1 refuses it: wave.mof:4:1: no"));
    click(*bench.view, "motionSend");
    bench.answer(bench.sentMotion(), true);
    bench.publishMotions(bench.bench().document().text(), true);
    bench.tick(*bench.view);
    QCOMPARE(bench.state(), QStringLiteral("red1 has this motion, as it was sent"));
    child<QAction>(*bench.view, "motionTakeBackAction").trigger();
    QCOMPARE(bench.sentMotion().set_motion().motion().text(), std::string());
  }

  void changesAreSentByThemselvesIfThatIsChosen() {
    WaveBench bench;
    click(*bench.view, "motionAutoSend");
    bench.requests.clear();
    bench.type(0, KeyFrameModel::kDuration, QStringLiteral("700"));
    for (int i = 0; i < 20; ++i) bench.tick(*bench.view);
    QCOMPARE(bench.sentMotion().set_motion().motion().text(), bench.bench().document().text());
    const auto count = bench.requests.size();
    for (int i = 0; i < 20; ++i) bench.tick(*bench.view);
    QCOMPARE(bench.requests.size(), count);
  }

  void playingSendsWhatTheRobotDoesNotHaveYetAndThenPlays() {
    WaveBench bench;
    QCOMPARE(bench.refusal("motion.play"), std::string("robot.not-taken"));
    bench.takeOver();
    click(*bench.view, "motionPlay");
    bench.tick(*bench.view);
    QCOMPARE(bench.commanded().kind(), MotionRequest::KEY_FRAMES);
    QCOMPARE(bench.commanded().motion(), std::string("wave"));
    QCOMPARE(bench.refusal("robot.stand"), std::string());
    bench.requests.clear();
    bench.type(0, KeyFrameModel::kDuration, QStringLiteral("500"));
    click(*bench.view, "motionPlay");
    bench.tick(*bench.view);
    QCOMPARE(bench.commanded().kind(), MotionRequest::STAND);
    bench.answer(bench.sentMotion(), true);
    bench.tick(*bench.view);
    QCOMPARE(bench.commanded().motion(), std::string("wave"));
  }

  void steppingTurnsTheRobotToThePoses() {
    WaveBench bench;
    bench.takeOver();
    bench.bench().setFrame(1);
    click(*bench.view, "motionPrevious");
    bench.tick(*bench.view);
    const MotionRequest motion = bench.commanded();
    QCOMPARE(motion.kind(), MotionRequest::JOINTS);
    QCOMPARE(motion.joints_size(), 3);
    QCOMPARE(motion.joints(1).name(), std::string("legFL1"));
    QVERIFY(std::abs(motion.joints(1).position() - robotlink::radians(20)) < 1e-9);
    click(*bench.view, "motionNext");
    bench.tick(*bench.view);
    QCOMPARE(bench.bench().frame(), 1);
    QVERIFY(std::abs(bench.commanded().joints(0).position() - robotlink::radians(-10)) < 1e-9);
  }

  void robotsWithoutJointsSaySo() {
    WaveBench bench;
    bench.session.selectRobot("blue1");
    bench.tick(*bench.view);
    QCOMPARE(bench.state(), QStringLiteral("blue1 has no joints, so it plays no motions"));
    QVERIFY(!child<QToolButton>(*bench.view, "motionSend").isEnabled());
    QVERIFY(!child<QToolButton>(*bench.view, "motionPlay").isEnabled());
    QCOMPARE(bench.refusal("motion.send"), std::string("motion.no-joints"));
  }

  void aChangedMotionIsAskedAboutAndSaved() {
    WaveBench bench;
    bench.type(0, KeyFrameModel::kDuration, QStringLiteral("500"));
    QCOMPARE(child<QLabel>(*bench.view, "motionTitle").text(), QStringLiteral("wave.mof*"));
    QCOMPARE(bench.refusal("motion.new other"), std::string("motion.unsaved"));
    DialogAnswer cancel([](QDialog& dialog) {
      QCOMPARE(dialog.objectName(), QStringLiteral("unsavedMotion"));
      DialogAnswer::press(dialog, QDialogButtonBox::RejectRole);
    });
    click(*bench.view, "motionNew");
    QVERIFY(cancel.asked());
    QCOMPARE(bench.savedText(), kWave);
    click(*bench.view, "motionSave");
    QCOMPARE(bench.savedText(), bench.bench().document().text());
    QVERIFY(!motionFiles(bench.context).changed());
  }

  void motionsOfOtherTeamsAreImportedAndAreUnsaved() {
    JointBench bench;
    const auto mot = bench.folder.write("k_head.mot", robotlink::cmpackBytes(robotlink::cmpackKick()));
    QCOMPARE(bench.refusal("motion.open " + mot.string()), std::string());
    QCOMPARE(bench.bench().frames().size(), std::size_t{3});
    QVERIFY(motionFiles(bench.context).changed());
    QCOMPARE(bench.refusal("motion.save"), std::string("motion.no-file"));
    QCOMPARE(bench.refusal("motion.save-as " + mot.string()), std::string("motion.format"));
    const auto saved = (bench.folder / "k_head.mof").string();
    QCOMPARE(bench.refusal("motion.save-as " + saved), std::string());
    QCOMPARE(bench.refusal("motion.open " + saved), std::string());
    const auto broken = bench.folder.write("bad.pos", "nothing");
    QCOMPARE(bench.refusal("motion.open " + broken.string()), std::string("motion.no-count"));
    QCOMPARE(bench.bench().motion().name, std::string("k_head"));
  }

  void aDiscardedMotionIsNotChanged() {
    JointBench bench;
    const auto mot = bench.folder.write("k_head.mot", robotlink::cmpackBytes(robotlink::cmpackKick()));
    const auto wave = bench.folder.write("wave.mof", kWave);
    QCOMPARE(bench.refusal("motion.open " + mot.string()), std::string());
    QVERIFY(motionFiles(bench.context).changed());
    QCOMPARE(bench.refusal("motion.discard"), std::string());
    QVERIFY(!motionFiles(bench.context).changed());
    for (int i = 0; i < 2; ++i) {
      QCOMPARE(bench.refusal("motion.open " + wave.string()), std::string());
      QVERIFY(!motionFiles(bench.context).changed());
      QCOMPARE(bench.refusal("motion.discard"), std::string());
      QVERIFY(!motionFiles(bench.context).changed());
    }
  }

  void aMotionOfTheRobotIsOpened() {
    JointBench bench;
    auto view = bench.open<MotionEditorView>();
    auto& menu = child<QMenu>(*view, "motionOfRobotMenu");
    Q_EMIT menu.aboutToShow();
    child<QAction>(menu, "ofRobot.wave").trigger();
    QCOMPARE(bench.bench().document().text(), kWave);
    QVERIFY(!motionFiles(bench.context).changed());
    QCOMPARE(bench.refusal("motion.open-from-robot nothing"), std::string("motion.unknown"));
  }

  void commandsEditTheMotion() {
    WaveBench bench;
    QCOMPARE(bench.refusal("motion.select 2"), std::string());
    QCOMPARE(bench.refusal("motion.set legFL1 12.5"), std::string());
    QCOMPARE(bench.refusal("motion.duration 250"), std::string());
    QCOMPARE(bench.refusal("motion.interpolation 2"), std::string());
    QCOMPARE(bench.row(5), std::string(" -10 12.5   -  2 250"));
    QCOMPARE(bench.refusal("motion.set tail 1"), std::string("motion.no-column"));
    QCOMPARE(bench.refusal("motion.set legFL1 x"), std::string("motion.bad-angle"));
    QCOMPARE(bench.refusal("motion.select 3"), std::string("motion.no-frame"));
    QCOMPARE(bench.refusal("motion.mirror key-frame"), std::string());
    QCOMPARE(bench.row(5), std::string("  10    - 12.5  2 250"));
    QCOMPARE(bench.refusal("motion.move -1"), std::string());
    QCOMPARE(bench.bench().frame(), 0);
    QCOMPARE(bench.refusal("motion.move -1"), std::string("motion.no-frame"));
    QCOMPARE(bench.refusal("motion.duplicate"), std::string());
    QCOMPARE(bench.refusal("motion.remove"), std::string());
    for (int i = 0; i < 7; ++i) QCOMPARE(bench.refusal("motion.undo"), std::string());
    QCOMPARE(bench.bench().document().text(), kWave);
    QCOMPARE(bench.refusal("motion.undo"), std::string("motion.history"));
    QCOMPARE(bench.refusal("motion.redo"), std::string());
    QCOMPARE(bench.refusal("motion.discard"), std::string());
    QCOMPARE(bench.bench().document().text(), kWave);
  }

  void anUnsavedMotionIsRestoredAfterACrash() {
    const TestFolder user;
    std::string text;
    {
      JointBench bench;
      auto& files = motionFiles(bench.context);
      files.startRecovery(user / "motions");
      QCOMPARE(bench.refusal("motion.new bow"), std::string());
      bench.publishJoints(5, 5);
      bench.step();
      QCOMPARE(bench.refusal("joints.capture"), std::string());
      text = bench.bench().document().text();
      files.keepNow();
    }  // it ends without saving, and without asking
    JointBench bench;
    auto& files = motionFiles(bench.context);
    const QSignalSpy reported(&files, &MotionFiles::reported);
    files.startRecovery(user / "motions");
    QCOMPARE(bench.bench().document().text(), text);
    QVERIFY(files.changed());
    QCOMPARE(reported.size(), 1);
    files.forget();
    files.keepNow();
    JointBench next;
    motionFiles(next.context).startRecovery(user / "motions");
    QVERIFY(next.bench().isEmpty() || next.bench().document().text() != text);
  }

 private:
  static void clickCellOf(QTableView& table, int row, int column) {
    const QRect cell = table.visualRect(table.model()->index(row, column));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, cell.center());
  }
};

const GuiTest<MotionEditorViewTest> kMotionEditorViewTest;

}  // namespace widgets::test

#include "MotionEditorViewTest.moc"
