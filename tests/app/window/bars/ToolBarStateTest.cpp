// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/ToolBarState.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QToolBar>
#include <QtTest>

#include "tests/widgets/GuiTest.h"

namespace app::test {
namespace {

/// The state of a window with toolbars on two sides, one of them in a line of its own.
QByteArray stateOfToolBars() {
  QMainWindow window;
  const auto add = [&window](const char* name, Qt::ToolBarArea area) {
    auto* bar = new QToolBar(QLatin1String(name), &window);
    bar->setObjectName(QLatin1String(name));
    window.addToolBar(area, bar);
  };
  add("simulation", Qt::TopToolBarArea);
  add("recording", Qt::TopToolBarArea);
  window.addToolBarBreak(Qt::TopToolBarArea);
  add("log", Qt::TopToolBarArea);
  add("stop", Qt::LeftToolBarArea);
  return window.saveState();
}

}  // namespace

class ToolBarStateTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatAWindowSavesIsOne() {
    QVERIFY(isToolBarState(stateOfToolBars()));
    QVERIFY2(isToolBarState(QMainWindow().saveState()), "without toolbars");
  }

  void aPartOfItIsNone() {
    const QByteArray whole = stateOfToolBars();
    for (int size = 0; size < whole.size(); ++size)
      QVERIFY2(!isToolBarState(whole.left(size)), qPrintable(QString::number(size)));
  }

  void moreThanItIsNoneEither() { QVERIFY(!isToolBarState(stateOfToolBars() + '\0')); }

  void aWindowWithDocksOfQtIsAnother() {
    QMainWindow window;
    auto* dock = new QDockWidget(QStringLiteral("dock"), &window);
    dock->setObjectName(QStringLiteral("dock"));
    window.addDockWidget(Qt::LeftDockWidgetArea, dock);
    QVERIFY(!isToolBarState(window.saveState()));
  }

  void numbersThatPromiseMoreThanThereIsAreNotBelieved() {
    // Where the numbers are: how many lines of toolbars, and of the first one its side, how many toolbars it
    // has, and how many bytes the name of the first of these.
    const int lines = 4 + 4 + 1 + 4 + 24 + 1, side = lines + 4, bars = side + 4, name = bars + 4;
    for (const int at : {lines, side, bars, name}) {
      for (const char* number : {"\x00\x00\x00\x7f", "\x7f\xff\xff\xff", "\xff\xff\xff\xff"}) {
        QByteArray damaged = stateOfToolBars();
        damaged.replace(at, 4, number, 4);
        QVERIFY2(!isToolBarState(damaged), qPrintable(QString::number(at)));
      }
    }
  }

  void rubbishIsNone() {
    QVERIFY(!isToolBarState({}));
    QVERIFY(!isToolBarState(QByteArray(1000, '\0')));
    QVERIFY(!isToolBarState(QByteArray(1000, '\xfd')));
  }
};

const widgets::test::GuiTest<ToolBarStateTest> kToolBarStateTest;

}  // namespace app::test

#include "ToolBarStateTest.moc"
