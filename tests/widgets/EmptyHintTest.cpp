// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/EmptyHint.h"

#include <QHelpEvent>
#include <QListView>
#include <QToolTip>

#include "tests/widgets/Bench.h"
#include "tests/widgets/GuiTest.h"

namespace widgets::test {

class EmptyHintTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void coversItsViewWhateverItsSize() {
    QListView list;
    list.resize(300, 200);
    EmptyHint hint(&list);
    hint.setHint(QStringLiteral("Nothing is here."));
    list.show();
    QVERIFY(hint.isVisible());
    list.resize(400, 120);
    QCOMPARE(hint.geometry(), list.viewport()->rect());
    hint.setHint({});
    QVERIFY(!hint.isVisible());
  }

  void aTextThatHasNoRoomEndsInAnEllipsisAndATooltipHasAllOfIt() {
    const QString text = QStringLiteral("There are no strokes yet. Draw at least two of each class.");
    QListView list;
    list.setFrameShape(QFrame::NoFrame);
    list.resize(260, 200);
    auto* hint = new EmptyHint(&list);
    hint->setHint(text);
    list.show();
    QCOMPARE(hint->shownText(), text);
    list.resize(260, hint->fontMetrics().lineSpacing() + 12);
    const QString shown = hint->shownText();
    QVERIFY2(shown.endsWith(QStringLiteral("…")) && shown.size() > 12, qPrintable(shown));
    QVERIFY(text.startsWith(shown.chopped(1)));
    QCOMPARE(hint->text(), text);
    QHelpEvent help(QEvent::ToolTip, {5, 5}, list.viewport()->mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(list.viewport(), &help);
    QCOMPARE(QToolTip::text(), text);
    QToolTip::hideText();
  }

  void wordsArePaintedInWhatRoomThereIs() {
    QListView list;
    list.setFrameShape(QFrame::NoFrame);
    list.resize(200, 60);
    auto* hint = new EmptyHint(&list);
    hint->setHint(QStringLiteral("MMMM MMMM"));
    list.show();
    const QImage with = list.grab().toImage();
    hint->setHint({});
    QVERIFY(with != list.grab().toImage());
  }
};

const GuiTest<EmptyHintTest> kEmptyHintTest;

}  // namespace widgets::test

#include "EmptyHintTest.moc"
