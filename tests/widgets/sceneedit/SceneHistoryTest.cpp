// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulation refuses later is in the texts no more, and the other way round.
#include <QSignalSpy>

#include "tests/widgets/sceneedit/HallBench.h"
#include "widgets/sceneedit/SceneFile.h"

namespace widgets::test {
namespace {

/// A hall with the texts of what the bench has reported.
struct RefusingHall : HallBench {
  QString lastReport() const { return reported.isEmpty() ? QString() : reported.last()[0].toString(); }
  SceneFile& text() { return *sceneBench(context).current(); }
  void writeByHand() { text().replaceText(text().text() + QStringLiteral("<!-- mine -->")); }

  QSignalSpy reported{&sceneBench(context), &SceneBench::reported};
};

}  // namespace

class SceneHistoryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theSimulationGoesOnInATextThatCannotGoBack() {
    RefusingHall b;
    QCOMPARE(b.insert("box", 3, 4), std::string("box"));
    b.writeByHand();
    const std::string mine = b.text().text().toStdString();
    b.refuse("there is no room for 'box'");
    QCOMPARE(b.text().text().toStdString(), mine);
    QVERIFY2(b.lastReport().startsWith(QStringLiteral("there is no room for 'box'")), "the reason");
    QVERIFY(b.lastReport().contains(QStringLiteral("edited by hand since")));
    QCOMPARE(b.texts.size(), std::size_t{2});
    QCOMPARE(b.running(), mine);
    QVERIFY2(!b.refuse, "what is in the way gives way");
    QVERIFY(b.edits().canUndo() && !b.edits().canRedo());
  }

  void severalChangesGoBackTogetherOrNoneDoes() {
    RefusingHall b;
    QCOMPARE(b.insert("box", 3, 4), std::string("box"));
    const auto refuseFirst = b.refuse;
    b.writeByHand();
    QCOMPARE(b.erase("desk"), std::string("desk"));
    const std::string both = b.text().text().toStdString();
    refuseFirst("there is no room for 'box'");
    QCOMPARE(b.text().text().toStdString(), both);
    QCOMPARE(b.running(), both);
    QVERIFY(!b.edits().canRedo() && b.edits().undoTitle().contains(QStringLiteral("desk")));
  }

  void whatTheSimulationWasAskedForSinceGoesBackToo() {
    RefusingHall b;
    QCOMPARE(b.insert("box", 3, 4), std::string("box"));
    const auto refuseFirst = b.refuse;
    QCOMPARE(b.erase("desk"), std::string("desk"));
    refuseFirst("there is no room for 'box'");
    QCOMPARE(b.text().text().toStdString(), kHall);
    QCOMPARE(b.texts.size(), std::size_t{3});
    QVERIFY2(b.texts.back().empty(), "the simulation may have gone on without the desk");
    QVERIFY(!b.edits().canUndo() && b.edits().canRedo());
  }

  void theReasonIsShownEvenIfTheChangeIsUndoneAlready() {
    RefusingHall b;
    QCOMPARE(b.insert("box", 3, 4), std::string("box"));
    const auto refuseFirst = b.refuse;
    QVERIFY(b.edits().undo().has_value());
    refuseFirst("there is no room for 'box'");
    QCOMPARE(b.lastReport(), QStringLiteral("there is no room for 'box'"));
    QCOMPARE(b.text().text().toStdString(), kHall);
    QVERIFY(!b.edits().canUndo() && b.edits().canRedo());
  }

  void withoutASimulationTheTextStaysAsItIs() {
    RefusingHall b;
    b.refusal = "no scene is open here";
    QCOMPARE(b.insert("box", 3, 4), b.refusal);
    QCOMPARE(b.text().text().toStdString(), kHall);
    QVERIFY(!b.text().isChanged() && !b.edits().canUndo());
  }
};

const GuiTest<SceneHistoryTest> kSceneHistoryTest;

}  // namespace widgets::test

#include "SceneHistoryTest.moc"
