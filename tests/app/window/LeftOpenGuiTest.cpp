// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does after a crash and about problems: what was open is offered again, and a report is
// made.
#include <QApplication>
#include <QClipboard>
#include <QJsonArray>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "app/robotcontrol/bars/LeftOpenBar.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

constexpr char kBar[] = "leftOpenBar";

}  // namespace

class LeftOpenGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void whatWasOpenIsOfferedAfterACrash() {
    std::string scene;
    {
      Desk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
      scene = desk.workbench.loaded()->sources.front();
      desk.window.keepWindow();  // and it ends without being closed
    }
    EmptyDesk again(home_);
    QVERIFY(again.find<QWidget>(kBar).isVisible());
    QVERIFY(again.find<QLabel>("leftOpenText").text().contains(QStringLiteral("field2002.sdf")));
    QTest::mouseClick(&again.find<QToolButton>("leftOpenAgain"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(again.loaded(), kWaitMs);
    QCOMPARE(again.workbench.loaded()->sources.front(), scene);
    QVERIFY(!again.find<QWidget>(kBar).isVisible());
  }

  void nothingIsOfferedAfterAProperEnd() {
    {
      Desk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
      desk.window.keepWindow();
      QVERIFY(desk.window.close());
    }
    EmptyDesk again(home_);
    QVERIFY(!again.find<QWidget>(kBar).isVisible());
  }

  void itHidesWhenTheSameIsOpenAgain() {
    {
      Desk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
      desk.window.keepWindow();
    }
    Desk again(home_);
    QTRY_VERIFY_WITH_TIMEOUT(again.loaded(), kWaitMs);
    QTRY_VERIFY(!again.find<QWidget>(kBar).isVisible());
  }

  void whatAnotherWorkbenchHasOpenIsNotOffered() {
    EmptyDesk desk(home_);
    auto& bar = desk.find<LeftOpenBar>(kBar);
    const QJsonObject left{{QStringLiteral("sources"), QJsonArray{QStringLiteral("/a/field.sdf")}},
                           {QStringLiteral("process"), 1.0}};
    bar.offer(left);  // the first process is another program
    QVERIFY(bar.isVisible());
    QTest::mouseClick(&desk.find<QToolButton>("leftOpenDismiss"), Qt::LeftButton);
    QVERIFY(!bar.isVisible());
    bar.offer({});
    QVERIFY(!bar.isVisible());
  }

  void aProblemIsReportedWithWhatHelps() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QString text;
    QTimer::singleShot(0, &desk.window, [&] {
      QWidget* dialog = QApplication::activeModalWidget();
      dialog->findChild<QPlainTextEdit*>(QStringLiteral("problemStory"))
          ->setPlainText(QStringLiteral("It fell over."));
      dialog->findChild<QPushButton*>(QStringLiteral("problemCopy"))->click();
      text = QApplication::clipboard()->text();
      dialog->close();
    });
    desk.find<QAction>("help.report").trigger();
    for (const char* part : {"It fell over.", "RobotControl ", "Qt 5", "field2002.sdf",
                             "Robot: red1 (ers210)", "processes:", "\"appearance\""})
      QVERIFY2(text.contains(QLatin1String(part)), part);
    QVERIFY(!text.contains(QDir::homePath() + QLatin1Char('/')));
  }
};

const widgets::test::GuiTest<LeftOpenGuiTest> kLeftOpenGuiTest;

}  // namespace app::test

#include "LeftOpenGuiTest.moc"
