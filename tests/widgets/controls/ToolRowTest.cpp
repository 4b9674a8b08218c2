// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ToolRow.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <algorithm>

#include "tests/widgets/Bench.h"
#include "tests/widgets/GuiTest.h"
#include "widgets/Controls.h"

namespace widgets::test {

/// A row of five tools.
struct FiveTools {
  QWidget owner;
  QHBoxLayout* row = makeToolRow(&owner);
  QWidget* widget = row->parentWidget();
  std::vector<RowButton*> buttons;

  FiveTools() {
    for (const char* name : {"one", "two", "three", "four", "five"}) {
      QAction* action = makeAction(&owner, "fit", {name, QString::fromLatin1(name), {}});
      buttons.push_back(static_cast<RowButton*>(makeButton(widget, action)));
      row->addWidget(buttons.back());
    }
    makeColumn(&owner)->addWidget(widget);
    owner.resize(400, 40);
    owner.show();
    QApplication::processEvents();
  }

  QStringList offered() {
    QMenu* menu = widget->findChild<QToolButton*>(QStringLiteral("moreTools"))->menu();
    Q_EMIT menu->aboutToShow();
    QStringList texts;
    for (QAction* action : menu->actions()) texts << action->text();
    return texts;
  }
};

class ToolRowTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void allToolsAreShownWhereThereIsRoom() {
    FiveTools tools;
    for (RowButton* button : tools.buttons) QVERIFY(!button->isLeftOut());
    QVERIFY(!tools.widget->findChild<QToolButton*>(QStringLiteral("moreTools"))->isVisible());
  }

  void theLastToolsAreOfferedInAMenuWhereThereIsNone() {
    FiveTools tools;
    const int width = tools.buttons[0]->neededWidth();
    tools.owner.resize(4 * width, 40);
    auto* more = tools.widget->findChild<QToolButton*>(QStringLiteral("moreTools"));
    QTRY_VERIFY(more->isVisible());
    QVERIFY(tools.buttons.back()->isLeftOut());
    QVERIFY(!tools.buttons.front()->isLeftOut());
    // What is shown has all of its width.
    QTRY_COMPARE(tools.buttons.front()->width(), width);
    const QStringList offered = tools.offered();
    QCOMPARE(offered.back(), QStringLiteral("five"));
    QCOMPARE(offered.size(), static_cast<int>(std::ranges::count_if(tools.buttons, &RowButton::isLeftOut)));
    tools.owner.resize(400, 40);
    QTRY_VERIFY(!tools.buttons.back()->isLeftOut());
    QVERIFY(!more->isVisible());
  }

  void aToolThatIsHiddenTakesNoRoomAndIsNotOffered() {
    FiveTools tools;
    tools.buttons[4]->hide();
    tools.owner.resize(3 * tools.buttons[0]->neededWidth(), 40);
    QTRY_VERIFY(tools.buttons[3]->isLeftOut());
    QVERIFY(!tools.offered().contains(QStringLiteral("five")));
  }
};

const GuiTest<ToolRowTest> kToolRowTest;

}  // namespace widgets::test

#include "ToolRowTest.moc"
