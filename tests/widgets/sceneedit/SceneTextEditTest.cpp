// SPDX-License-Identifier: GPL-3.0-or-later
// What the editor does with keys; SceneEditorViewTest has what it proposes.
#include "widgets/sceneedit/SceneTextEdit.h"

#include <QTextBlock>
#include <QTextDocument>

#include "tests/widgets/Bench.h"

namespace widgets::test {
namespace {

/// An editor with a text.
struct EditedText {
  explicit EditedText(const char* text, bool isXml = true) {
    document.setDocumentLayout(new QPlainTextDocumentLayout(&document));
    document.setPlainText(QLatin1String(text));
    edit.showDocument(&document, isXml, "room.sdf");
    edit.show();
    if (!QTest::qWaitForWindowActive(&edit)) qFatal("the editor never became active");
  }
  /// Selects from the begin of a line up to a position in another one.
  void selectLines(int from, int to, int position = 0) {
    QTextCursor cursor(document.findBlockByNumber(from));
    cursor.setPosition(document.findBlockByNumber(to).position() + position, QTextCursor::KeepAnchor);
    edit.setTextCursor(cursor);
  }
  void setCursorAtEnd() { edit.moveCursor(QTextCursor::End); }
  QString text() const { return document.toPlainText(); }

  // The editor is gone first.
  QTextDocument document;
  SceneTextEdit edit{nullptr};
};

}  // namespace

class SceneTextEditTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void tabIndentsTheSelectedLines() {
    EditedText edited("a\nb\nc\n");
    edited.selectLines(0, 1, 1);
    QTest::keyClick(&edited.edit, Qt::Key_Tab);
    QCOMPARE(edited.text(), QStringLiteral("  a\n  b\nc\n"));
    edited.edit.undo();
    QVERIFY2(edited.text() == QStringLiteral("a\nb\nc\n"), "it is one step");
  }

  void aLineAtWhoseBeginASelectionEndsIsNotIndented() {
    EditedText edited("a\nb\nc\n");
    edited.selectLines(0, 2);
    QTest::keyClick(&edited.edit, Qt::Key_Tab);
    QCOMPARE(edited.text(), QStringLiteral("  a\n  b\nc\n"));
    EditedText back("  a\n  b\n  c\n");
    back.selectLines(0, 2);
    QTest::keyClick(&back.edit, Qt::Key_Backtab);
    QCOMPARE(back.text(), QStringLiteral("a\nb\n  c\n"));
  }

  void withoutASelectionTabInsertsBlanksAndBacktabMovesTheLine() {
    EditedText edited("   ab");
    edited.edit.moveCursor(QTextCursor::End);
    QTest::keyClick(&edited.edit, Qt::Key_Tab);
    QCOMPARE(edited.text(), QStringLiteral("   ab  "));
    for (const char* moved : {" ab  ", "ab  ", "ab  "}) {
      QTest::keyClick(&edited.edit, Qt::Key_Backtab);
      QCOMPARE(edited.text(), QLatin1String(moved));
    }
  }

  void onlyTagsAreClosed() {
    const auto typed = [](const char* text, const char* keys, bool isXml = true) {
      EditedText edited(text, isXml);
      edited.setCursorAtEnd();
      QTest::keyClicks(&edited.edit, QLatin1String(keys));
      return edited.text();
    };
    QCOMPARE(typed("<link name='a'", ">"), QStringLiteral("<link name='a'></link>"));
    QCOMPARE(typed("<link/", ">"), QStringLiteral("<link/>"));
    QCOMPARE(typed("<!-- a --", ">"), QStringLiteral("<!-- a -->"));
    QCOMPARE(typed("<!-- a <b", ">"), QStringLiteral("<!-- a <b>"));
    QCOMPARE(typed("<?xml version='1.0'?", ">"), QStringLiteral("<?xml version='1.0'?>"));
    QCOMPARE(typed("<a><b></b><", "/"), QStringLiteral("<a><b></b></a>"));
    QCOMPARE(typed("a <b", ">", false), QStringLiteral("a <b>"));
  }

  void whatIsTypedAsAWholeIsNotClosedTwice() {
    const auto typed = [](const char* keys) {
      EditedText edited("");
      for (const char* key = keys; *key != 0; ++key) {
        if (*key == '\n')
          QTest::keyClick(&edited.edit, Qt::Key_Return);
        else
          QTest::keyClick(&edited.edit, *key);
      }
      return edited.text();
    };
    const char* const kWorld =
        "<sdf version=\"1.9\"><world name=\"w\"><gravity>0 0 -9</gravity></world></sdf>";
    QCOMPARE(typed(kWorld), QLatin1String(kWorld));
    QCOMPARE(typed("<a>\n<b>1</b>\n</a>"), QStringLiteral("<a>\n  <b>1</b>\n</a>"));
    // The names may be left out as well.
    QCOMPARE(typed("<a><b>1</</"), QStringLiteral("<a><b>1</b></a>"));
    QCOMPARE(typed("<a><b/></a><c>1</c>"), QStringLiteral("<a><b/></a><c>1</c>"));
  }

  void quotesAndBracketsThatAreThereArePassedOver() {
    EditedText edited("<a name=\"\"></a>");
    QTextCursor cursor = edited.edit.textCursor();
    cursor.setPosition(9);
    edited.edit.setTextCursor(cursor);
    QTest::keyClicks(&edited.edit, QStringLiteral("b\">1"));
    QCOMPARE(edited.text(), QStringLiteral("<a name=\"b\">1</a>"));
  }

  void theCursorStandsInANewElement() {
    EditedText edited("<link");
    edited.setCursorAtEnd();
    QTest::keyClicks(&edited.edit, QStringLiteral(">x"));
    QCOMPARE(edited.text(), QStringLiteral("<link>x</link>"));
  }

  void linesAndSelectionsThatAreNotThereAreTheNearest() {
    EditedText edited("a\nbc\nd");
    edited.edit.goToLine(99);
    QCOMPARE(edited.edit.textCursor().blockNumber(), 2);
    edited.edit.goToLine(-1);
    QCOMPARE(edited.edit.textCursor().blockNumber(), 0);
    edited.edit.select(2, 99);
    QCOMPARE(edited.edit.textCursor().selectionStart(), 2);
    QCOMPARE(edited.edit.textCursor().selectionEnd(), 6);
    QVERIFY2(edited.edit.textCursor().position() == 2, "its begin is what is seen");
    edited.edit.select(-5, 1);
    QCOMPARE(edited.edit.textCursor().selectionStart(), 0);
  }

  void indentingAllIsOneStepAndLeavesTheLine() {
    EditedText edited("<a>\n<b>\n<c/>\n</b>\n</a>");
    edited.edit.goToLine(3);
    edited.edit.indentAll();
    QCOMPARE(edited.text(), QStringLiteral("<a>\n  <b>\n    <c/>\n  </b>\n</a>"));
    QCOMPARE(edited.edit.textCursor().blockNumber(), 2);
    edited.edit.undo();
    QCOMPARE(edited.text(), QStringLiteral("<a>\n<b>\n<c/>\n</b>\n</a>"));
  }

  void whatIsNoXmlIsNotIndented() {
    EditedText edited("<a>\n<b/>\n</a>", false);
    edited.edit.indentAll();
    QCOMPARE(edited.text(), QStringLiteral("<a>\n<b/>\n</a>"));
  }
};

const GuiTest<SceneTextEditTest> kSceneTextEditTest;

}  // namespace widgets::test

#include "SceneTextEditTest.moc"
