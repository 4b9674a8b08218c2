// SPDX-License-Identifier: GPL-3.0-or-later
// Docks as a person moves them, by real mouse and keys under a window manager: dragged out, closed, restored,
// and quit with.
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/DockWidgetTab.h>
#include <qtadvanceddocking/FloatingDockContainer.h>
#include <QCursor>
#include <QMessageBox>
#include <QProcess>
#include <QRegularExpression>
#include <QStatusBar>

#include "app/robotcontrol/docks/DockSpace.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/XServer.h"

namespace app::test {
namespace {

QByteArray output(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!comes([&] { return process.state() == QProcess::NotRunning; }))
    qFatal("%s hangs", qPrintable(program));
  return process.readAllStandardOutput();
}

void xdotool(const QStringList& arguments) {
  output(QStringLiteral("xdotool"), arguments);
}

bool moveMouse(QPoint to) {
  xdotool({QStringLiteral("mousemove"), QString::number(to.x()), QString::number(to.y())});
  return comes([&] { return QCursor::pos() == to; });
}

bool click(QPoint at) {
  const bool there = moveMouse(at);
  xdotool({QStringLiteral("click"), QStringLiteral("1")});
  return there;
}

bool drag(QPoint from, QPoint to) {
  constexpr int kSteps = 8;
  if (!moveMouse(from)) return false;
  xdotool({QStringLiteral("mousedown"), QStringLiteral("1")});
  bool there = true;
  for (int step = 1; step <= kSteps; ++step) there = moveMouse(from + (to - from) * step / kSteps) && there;
  xdotool({QStringLiteral("mouseup"), QStringLiteral("1")});
  return there;
}

void press(const char* key) {
  xdotool({QStringLiteral("key"), QLatin1String(key)});
}

/// The windows of all programs, the lowest first.
QList<WId> stacking() {
  const QString text = QString::fromLatin1(output(
      QStringLiteral("xprop"), {QStringLiteral("-root"), QStringLiteral("_NET_CLIENT_LIST_STACKING")}));
  QList<WId> windows;
  QRegularExpressionMatchIterator found = QRegularExpression(QStringLiteral("0x[0-9a-f]+")).globalMatch(text);
  while (found.hasNext()) windows << found.next().captured().toULongLong(nullptr, 16);
  return windows;
}

/// In such a list, which takes a while to be asked for: a widget may end meanwhile.
bool isAbove(const QList<WId>& windows, const QWidget& upper, const QWidget& lower) {
  return windows.indexOf(lower.winId()) >= 0 &&
         windows.indexOf(upper.winId()) > windows.indexOf(lower.winId());
}

/// The windows that the window manager knows, the lowest first, and those that this program shows, for the
/// message of a failure.
QString allWindows() {
  QStringList lines;
  for (const WId window : stacking()) lines << QStringLiteral("managed: 0x%1").arg(window, 0, 16);
  for (const QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget->isVisible())
      lines << QStringLiteral("shown here: 0x%1 %2").arg(widget->winId(), 0, 16).arg(widget->windowTitle());
  }
  return lines.join(QLatin1Char('\n'));
}

ads::CDockWidget& dock(Desk& desk, const char* id) {
  const auto docks = desk.window.docks().docks(QLatin1String(id));
  if (docks.empty()) qFatal("there is no dock for %s", id);
  return *docks.front();
}

QPoint middle(const QWidget& widget) {
  return widget.mapToGlobal(widget.rect().center());
}

/// Where the mouse takes a dock by its tab.
QPoint handle(const ads::CDockWidget& dock) {
  return dock.tabWidget()->mapToGlobal(QPoint(20, dock.tabWidget()->height() / 2));
}

bool dragOut(Desk& desk, const char* id, QPoint to) {
  dock(desk, id).setAsCurrentTab();
  return drag(handle(dock(desk, id)), to) && comes([&] { return dock(desk, id).isFloating(); });
}

/// Waits for the window, and for the scene, whose views the window may show when it is loaded.
bool exposed(Desk& desk) {
  return QTest::qWaitForWindowActive(&desk.window) && comes([&] { return desk.loaded(); }) &&
         comes([&] { return dock(desk, "scene").isVisible(); });
}

}  // namespace

class DocksUnderXTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    home_ = widgets::test::BenchHome::path() / "robotcontrol";
    QTRY_VERIFY(
        output(QStringLiteral("xprop"), {QStringLiteral("-root"), QStringLiteral("_NET_SUPPORTING_WM_CHECK")})
            .contains("window id"));
  }
  void init() { std::filesystem::remove_all(home_); }

  void aDockIsDraggedOutAndThePerspectiveIsChangedByItsKey() {
    Desk desk(home_);
    QVERIFY(exposed(desk));
    for (int i = 0; i < 3; ++i) {
      if (!dock(desk, "messages").isFloating()) QVERIFY(dragOut(desk, "messages", QPoint(1700, 900)));
      QVERIFY(click(middle(*desk.window.statusBar())));
      QVERIFY(QTest::qWaitForWindowActive(&desk.window));
      press("ctrl+2");
      QTRY_VERIFY(desk.find<QAction>("perspective.Log").isChecked());
      press("ctrl+1");
      QTRY_VERIFY(desk.find<QAction>("perspective.Play").isChecked());
      QTRY_VERIFY(dock(desk, "messages").isVisible());
      desk.window.tick();
    }
  }

  void aDockIsDraggedOutAndPutBackIntoTheMiddleOfAnArea() {
    Desk desk(home_);
    QVERIFY(exposed(desk));
    QVERIFY(dragOut(desk, "messages", QPoint(1700, 900)));
    auto* floating = dock(desk, "messages").floatingDockContainer();
    QVERIFY(floating != nullptr);
    QPointer<QWidget> gone(floating);
    // It is moved by its frame, as the window manager moves windows.
    QVERIFY(drag(QPoint(floating->geometry().left() + 60, floating->geometry().top() - 8),
                 middle(dock(desk, "image"))));
    QVERIFY(click(middle(*desk.window.statusBar())));
    desk.window.tick();
    if (!dock(desk, "messages").isFloating()) QTRY_VERIFY(gone.isNull());
    press("ctrl+1");
    QTRY_VERIFY(dock(desk, "messages").isVisible());
  }

  void whatFloatsIsAboveTheMainWindowAfterARestartAndBelowDialogs() {
    {
      Desk desk(home_);
      QVERIFY(exposed(desk));
      QVERIFY(dragOut(desk, "messages", QPoint(700, 500)));
      desk.window.close();
    }
    Desk desk(home_);
    QVERIFY(QTest::qWaitForWindowExposed(&desk.window));
    const QPointer<QWidget> floating = dock(desk, "messages").floatingDockContainer();
    const auto floatsAbove = [&](const QWidget& lower) {
      const QList<WId> windows = stacking();
      return floating != nullptr && isAbove(windows, *floating, lower);
    };
    QVERIFY2(comes([&] { return floatsAbove(desk.window); }), qPrintable(allWindows()));
    // The scene finds its views, which stay as they are.
    QVERIFY(comes([&] { return desk.loaded(); }));
    QVERIFY2(floatsAbove(desk.window), qPrintable(allWindows()));
    QVERIFY(click(middle(*desk.window.statusBar())));
    QVERIFY2(comes([&] { return floatsAbove(desk.window); }), qPrintable(allWindows()));
    // In the dialog's own event loop, which returns when it is closed.
    bool above = false, stillAbove = false;
    QTimer::singleShot(0, &desk.window, [&] {
      if (!comes([] { return QApplication::activeModalWidget() != nullptr; })) return;
      QWidget* dialog = QApplication::activeModalWidget();
      const auto isBelow = [&] {
        const QList<WId> windows = stacking();
        return floating != nullptr && isAbove(windows, *dialog, *floating);
      };
      above = comes(isBelow);
      stillAbove = click(middle(*floating)) && comes(isBelow);
      dialog->close();
    });
    desk.find<QAction>("help.about").trigger();
    QVERIFY(above);
    QVERIFY(stillAbove);
  }

  void quittingWithTwoFloatingDocksEndsTheProgram() {
    {
      Desk desk(home_);
      QVERIFY(exposed(desk));
      QVERIFY(dragOut(desk, "messages", QPoint(1700, 900)));
      QVERIFY(dragOut(desk, "image", QPoint(1500, 200)));
      desk.window.close();
      for (const QWidget* window : QApplication::topLevelWidgets())
        QVERIFY2(!window->isVisible(), qPrintable(window->objectName()));
    }
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(QStringLiteral(ROBOTCONTROL), QStringList());
    QVERIFY2(comes([] { return stacking().size() == 3; }), qPrintable(allWindows()));
    press("ctrl+q");
    QTRY_COMPARE_WITH_TIMEOUT(program.state(), QProcess::NotRunning, kWaitMs);
    QCOMPARE(program.exitCode(), 0);
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
  }

  void theFirstWindowFitsTheScreenAtAnyScale() {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("1.5"));
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(QStringLiteral(ROBOTCONTROL), QStringList());
    QTRY_VERIFY_WITH_TIMEOUT(stacking().size() >= 1, kWaitMs);
    const QString geometry = QString::fromLatin1(
        output(QStringLiteral("xdotool"), {QStringLiteral("getwindowgeometry"), QStringLiteral("--shell"),
                                           QString::number(stacking().first())}));
    const auto number = [&](const char* name) {
      return QRegularExpression(QLatin1String(name) + QStringLiteral("=(-?[0-9]+)"))
          .match(geometry)
          .captured(1)
          .toInt();
    };
    QVERIFY2(number("WIDTH") > 1000 && number("X") + number("WIDTH") <= 1920, qPrintable(geometry));
    QVERIFY2(number("HEIGHT") > 700 && number("Y") + number("HEIGHT") <= 1080, qPrintable(geometry));
    program.terminate();
    QTRY_COMPARE_WITH_TIMEOUT(program.state(), QProcess::NotRunning, kWaitMs);
  }

  void theProgramEndsProperlyWhenItIsTerminated() {
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(QStringLiteral(ROBOTCONTROL), QStringList());
    QTRY_VERIFY_WITH_TIMEOUT(stacking().size() >= 1, kWaitMs);
    program.terminate();
    QTRY_COMPARE_WITH_TIMEOUT(program.state(), QProcess::NotRunning, kWaitMs);
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QVERIFY(std::filesystem::exists(home_ / "window.json"));
  }

 private:
  std::filesystem::path home_;
};

}  // namespace app::test

int main(int argc, char** argv) {
  const QStringList missing = XServer::missing();
  if (!missing.isEmpty()) {
    std::printf("SKIPPED: dragging docks by real mouse events needs %s\n",
                qPrintable(missing.join(QStringLiteral(", "))));
    return 0;
  }
  const auto server = XServer::start();
  if (server == nullptr) {
    std::fprintf(stderr, "Xvfb or openbox did not start\n");
    return 1;
  }
  QApplication application(argc, argv);
  const widgets::test::BenchHome home;
  app::test::DocksUnderXTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "DocksUnderXTest.moc"
