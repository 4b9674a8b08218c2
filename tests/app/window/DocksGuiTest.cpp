// SPDX-License-Identifier: GPL-3.0-or-later
// Docks that are closed, floated, put back, and what becomes of them when perspectives change and the window
// closes.
#include <qtadvanceddocking/DockAreaTitleBar.h>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/DockWidgetTab.h>
#include <qtadvanceddocking/FloatingDockContainer.h>
#include <QAbstractButton>
#include <QJsonObject>
#include <QLabel>
#include <QSignalSpy>

#include "app/robotcontrol/docks/DockSpace.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

ads::CDockWidget& dock(Desk& desk, const char* id) {
  const auto docks = desk.window.docks().docks(QLatin1String(id));
  if (docks.empty()) qFatal("there is no dock for %s", id);
  return *docks.front();
}

widgets::View& view(Desk& desk, const char* id) {
  return *static_cast<widgets::View*>(dock(desk, id).widget());
}

app::DockSpace& space(Desk& desk) {
  auto* found = desk.window.findChild<app::DockSpace*>();
  if (found == nullptr) qFatal("there is no space for docks");
  return *found;
}

int visibleFloats(Desk& desk) {
  int count = 0;
  for (const auto* floating : space(desk).floatingWidgets()) count += floating->isVisible() ? 1 : 0;
  return count;
}

/// How light what an icon draws is, from 0 to 255.
int lightness(const QIcon& icon) {
  const QImage image = icon.pixmap(16).toImage();
  int most = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      if (color.alpha() > 200) most = std::max(most, color.lightness());
    }
  }
  return most;
}

int countPixels(QWidget& widget, const QColor& color) {
  const QImage image = widget.grab().toImage();
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == color ? 1 : 0;
  }
  return count;
}

/// Waits until the window took note of the layout.
bool canUndo(Desk& desk) {
  return QTest::qWaitFor([&] { return desk.find<QAction>("undoLayout").isEnabled(); });
}

}  // namespace

class DocksGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void everyPerspectiveIsShownWhileDocksFloatAndComesBackWithThem() {
    EmptyDesk desk(home_);
    const QStringList names = {QStringLiteral("Log"),    QStringLiteral("Colour"),
                               QStringLiteral("Motion"), QStringLiteral("Processes"),
                               QStringLiteral("Drive"),  QStringLiteral("Play")};
    dock(desk, "messages").setFloating();
    dock(desk, "scene").setFloating();
    settle(desk);
    QCOMPARE(visibleFloats(desk), 2);
    for (int round = 0; round < 2; ++round) {
      for (const QString& name : names) {
        desk.window.showPerspective(name);
        settle(desk);
        QVERIFY(!desk.window.docks().empty());
        QCOMPARE(visibleFloats(desk), name == QLatin1String("Play") ? 2 : round);
        if (name == QLatin1String("Play") || round == 1) continue;
        desk.window.docks()
            .docks(name == QLatin1String("Motion")  ? QStringLiteral("motion")
                   : name == QLatin1String("Drive") ? QStringLiteral("radar")
                                                    : QStringLiteral("messages"))
            .front()
            ->setFloating();
        settle(desk);
      }
    }
    QVERIFY(dock(desk, "messages").isFloating());
  }

  void aPerspectiveWaitsUntilAMenuIsClosedSinceAViewMayWaitForIt() {
    EmptyDesk desk(home_);
    settle(desk);
    QPointer<QWidget> field = dock(desk, "field").widget();
    auto* menu = new QMenu(field);  // as the context menu of the view
    menu->addAction(QStringLiteral("nothing"));
    menu->popup(desk.window.mapToGlobal(QPoint(100, 100)));
    QTRY_VERIFY(menu->isVisible());
    desk.find<QAction>("perspective.Log").trigger();
    settle(desk);
    QVERIFY(!field.isNull());
    QVERIFY(desk.find<QAction>("perspective.Play").isChecked());
    menu->close();
    QTRY_VERIFY(desk.find<QAction>("perspective.Log").isChecked());
    QTRY_VERIFY(field.isNull());
  }

  void aFloatingDockThatIsDeletedWithItsWindowLeavesTheList() {
    EmptyDesk desk(home_);
    dock(desk, "messages").setFloating();
    settle(desk);
    delete space(desk).floatingWidgets().front();
    QVERIFY(desk.window.docks().docks(QStringLiteral("messages")).empty());
    desk.window.tick();
    QVERIFY(!desk.window.docks().save().isEmpty());
    desk.window.docks().open(QStringLiteral("messages"));
    QVERIFY(dock(desk, "messages").isVisible());
  }

  void aClosedFloatIsOpenedAgainByItsMenuEntry() {
    EmptyDesk desk(home_);
    dock(desk, "messages").setFloating();
    settle(desk);
    space(desk).floatingWidgets().front()->close();
    settle(desk);
    QVERIFY(!desk.window.docks().isOpen(QStringLiteral("messages")));
    desk.choose("view.messages");
    settle(desk);
    QVERIFY(dock(desk, "messages").isVisible());
    QVERIFY(desk.find<QAction>("view.messages").isChecked());
  }

  void whatFloatsIsNamedByTheViewInFront() {
    EmptyDesk desk(home_);
    dock(desk, "messages").setFloating();
    settle(desk);
    auto* floating = space(desk).floatingWidgets().front();
    QCOMPARE(floating->windowTitle(), QStringLiteral("Messages"));
    space(desk).addDockWidgetTabToArea(&dock(desk, "plots"), dock(desk, "messages").dockAreaWidget());
    settle(desk);
    QCOMPARE(floating->windowTitle(), QStringLiteral("Plots"));
    dock(desk, "messages").setAsCurrentTab();
    settle(desk);
    QCOMPARE(floating->windowTitle(), QStringLiteral("Messages"));
    dock(desk, "messages").setWindowTitle(QStringLiteral("Messages of red1"));
    settle(desk);
    QCOMPARE(floating->windowTitle(), QStringLiteral("Messages of red1"));
  }

  void closingTheWindowClosesWhatFloatsAndKeepsIt() {
    {
      EmptyDesk desk(home_);
      dock(desk, "messages").setFloating();
      dock(desk, "scene").setFloating();
      settle(desk);
      QSignalSpy closed(&desk.window, &app::MainWindow::closed);
      desk.window.close();
      QCOMPARE(closed.count(), 1);
      QCOMPARE(visibleFloats(desk), 0);
    }
    EmptyDesk desk(home_);
    settle(desk);
    QCOMPARE(visibleFloats(desk), 2);
    QVERIFY(dock(desk, "scene").isFloating());
    QVERIFY(!desk.window.docks().docks(QStringLiteral("image")).front()->isFloating());
  }

  void floatingDocksAreOpenedAfterTheWindowAndOnlyOnce() {
    {
      EmptyDesk desk(home_);
      dock(desk, "messages").setFloating();
      settle(desk);
      desk.window.close();
    }
    MadeUpRobots network;
    Workbench workbench(home_);
    workbench.search().listenBy(network.source());
    MainWindow window(workbench, home_);
    const auto docks = window.docks().docks(QStringLiteral("messages"));
    QVERIFY(docks.size() == 1 && docks.front()->isFloating());
    const QWidget* floating = docks.front()->floatingDockContainer();
    const auto isOnScreen = [&] {
      return floating->windowHandle() != nullptr && floating->windowHandle()->isVisible();
    };
    QVERIFY(!isOnScreen());
    window.show();
    QVERIFY(!isOnScreen());
    QVERIFY(comes(isOnScreen));
    QVERIFY(floating->isVisible() && docks.front()->isVisible());
  }

  void theViewsOfTheSceneThatWasOpenLastStayWhenItIsLoadedAtTheStart() {
    QJsonObject before;
    {
      Desk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
      for (const char* line : {"scene.view wire", "scene.hide ball"})
        QVERIFY(desk.workbench.commands().runLine(line).has_value());
      dock(desk, "messages").setFloating();
      settle(desk);
      before = view(desk, "scene").saveState();
      desk.window.close();
    }
    Desk desk(home_);
    const QPointer<QWidget> scene = &view(desk, "scene");
    const QPointer<QWidget> floating = dock(desk, "messages").floatingDockContainer();
    QVERIFY(desk.workbench.loaded() == nullptr && floating != nullptr);
    // A view that is opened before the scene is loaded stays open, too.
    desk.window.docks().open(QStringLiteral("columns"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    settle(desk);
    QVERIFY(scene != nullptr && &view(desk, "scene") == scene);
    QCOMPARE(view(desk, "scene").saveState(), before);
    QVERIFY(floating != nullptr && floating->isVisible());
    QVERIFY(desk.window.docks().isOpen(QStringLiteral("columns")));
  }

  void titlesOfTabsAreReadableOnASmallScreen() {
    Desk desk(home_);
    desk.window.resize(1264, 672);
    desk.choose("perspective.Colour");
    settle(desk);
    auto& samples = dock(desk, "color-samples");
    space(desk).fitTabs();
    QCoreApplication::processEvents();
    widgets::test::keepPicture(desk.window, "docks-small");
    QVERIFY(!samples.tabWidget()->isTitleElided());
    for (const char* id : {"color-samples", "color-compare", "color-frames", "messages"}) {
      const ads::CDockWidgetTab& tab = *dock(desk, id).tabWidget();
      const auto& title = *tab.findChild<QLabel*>(QStringLiteral("dockWidgetTabLabel"));
      QVERIFY2(title.QLabel::text().size() >= 5, qPrintable(title.QLabel::text()));
      const auto* close = tab.findChild<QAbstractButton*>(QStringLiteral("tabCloseButton"));
      QCOMPARE(close->isVisible(), tab.isActiveTab());
    }
    // Where there is room, tabs have icons.
    const auto icons = [&] {
      int shown = 0;
      for (const auto* label : samples.tabWidget()->findChildren<QLabel*>()) shown += label->isVisible();
      return shown - 1;  // without the title
    };
    QCOMPARE(icons(), 0);
    desk.window.resize(2400, 1200);
    QCoreApplication::processEvents();
    space(desk).fitTabs();
    QCOMPARE(icons(), 1);
  }

  void anAreaThatIsNarrowerThanItsButtonsHasRoomForNoTitle() {
    Desk desk(home_);
    settle(desk);
    auto& messages = dock(desk, "messages");
    ads::CDockAreaTitleBar* bar = messages.dockAreaWidget()->titleBar();
    bar->resize(1, bar->height());
    space(desk).fitTabs();  // a warning of Qt fails the test
    QCOMPARE(messages.tabWidget()->findChild<QLabel*>(QStringLiteral("dockWidgetTabLabel"))->minimumWidth(),
             0);
  }

  void theViewThatWasClickedIsMaximizedThoughItTakesNoFocus() {
    Desk desk(home_);
    settle(desk);
    dock(desk, "debug-keys").widget()->setFocus();
    auto& messages = dock(desk, "messages");
    auto* label = messages.widget()->findChild<QLabel*>();
    QVERIFY(label != nullptr && label->focusPolicy() == Qt::NoFocus);
    QTest::mouseClick(label, Qt::LeftButton);
    desk.choose("maximizeView");
    QVERIFY(messages.isVisible());
    QVERIFY(!dock(desk, "debug-keys").isVisible());
  }

  void theThemeChangesWhileDocksFloat() {
    EmptyDesk desk(home_);
    dock(desk, "messages").setFloating();
    settle(desk);
    for (const char* name : {"appearance.dark", "appearance.light"}) {
      desk.find<QAction>(name).trigger();
      settle(desk);
      QCOMPARE(visibleFloats(desk), 1);
    }
  }

  void theButtonsOfDocksAreLightInTheDarkTheme() {
    EmptyDesk desk(home_);
    desk.find<QAction>("appearance.dark").trigger();
    settle(desk);
    auto* area = dock(desk, "scene").dockAreaWidget();
    for (const auto button :
         {ads::TitleBarButtonTabsMenu, ads::TitleBarButtonUndock, ads::TitleBarButtonClose}) {
      QVERIFY(lightness(qobject_cast<QToolButton*>(area->titleBarButton(button))->icon()) > 180);
    }
    desk.find<QAction>("appearance.light").trigger();
  }

  void stopCanBeReadWhenTheThemeChangesWhileItIsEngaged() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& stop = desk.find<QToolButton>("stopButton");
    QCOMPARE(stop.text(), QStringLiteral("STOP"));
    desk.find<QAction>("robot.stop").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(stop.text(), QStringLiteral("STOPPED: click to release"), kWaitMs);
    for (const char* theme : {"appearance.dark", "appearance.light"}) {
      desk.find<QAction>(theme).trigger();
      settle(desk);
      QVERIFY(countPixels(stop, QColor(0xff, 0xd5, 0x4f)) > stop.width() * stop.height() / 3);
      QVERIFY(countPixels(stop, QColor(0x5d, 0x12, 0x12)) > 50);
    }
    desk.find<QAction>("robot.stop").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(stop.text(), QStringLiteral("STOP"), kWaitMs);
    QVERIFY(countPixels(stop, Qt::white) > 30);
  }

  void aClosedAreaOfFourTabsIsOpenedAgainByUndo() {
    EmptyDesk desk(home_);
    settle(desk);
    QVERIFY(!desk.find<QAction>("undoLayout").isEnabled());
    auto* area = dock(desk, "messages").dockAreaWidget();
    QCOMPARE(area->openDockWidgetsCount(), 4);
    area->closeArea();
    settle(desk);
    QVERIFY(!desk.window.docks().isOpen(QStringLiteral("plots")));
    QVERIFY(canUndo(desk));
    desk.choose("undoLayout");
    settle(desk);
    QCOMPARE(dock(desk, "messages").dockAreaWidget()->openDockWidgetsCount(), 4);
    QVERIFY(desk.window.docks().isOpen(QStringLiteral("plots")));
    QTRY_VERIFY(desk.find<QAction>("redoLayout").isEnabled());
    desk.choose("redoLayout");
    settle(desk);
    QVERIFY(!desk.window.docks().isOpen(QStringLiteral("plots")));
  }

  void aResetPerspectiveIsUndoneWithTheViewsThatWereOpen() {
    EmptyDesk desk(home_);
    desk.choose("another.image");
    dock(desk, "messages").setFloating();
    settle(desk);
    QCOMPARE(desk.window.docks().docks(QStringLiteral("image")).size(), std::size_t{2});
    desk.choose("resetPerspective");
    settle(desk);
    QCOMPARE(desk.window.docks().docks(QStringLiteral("image")).size(), std::size_t{1});
    QCOMPARE(visibleFloats(desk), 0);
    QVERIFY(canUndo(desk));
    desk.choose("undoLayout");
    settle(desk);
    QCOMPARE(desk.window.docks().docks(QStringLiteral("image")).size(), std::size_t{2});
    QVERIFY(dock(desk, "messages").isFloating());
  }

  void aViewOfTheMenuOpensAsATabOfTheLargestArea() {
    EmptyDesk desk(home_);
    settle(desk);
    auto* largest = space(desk).largestArea();
    const QSize before = largest->size();
    desk.choose("view.radar");
    settle(desk);
    QCOMPARE(dock(desk, "radar").dockAreaWidget(), largest);
    QVERIFY(dock(desk, "radar").isVisible());
    QCOMPARE(largest->size(), before);
  }

  void theMenuTicksWhatIsOpenBringsItToTheFrontAndClosesIt() {
    EmptyDesk desk(home_);
    settle(desk);
    desk.choose("view.plots");
    settle(desk);
    QVERIFY2(dock(desk, "plots").isVisible(), "it was behind another tab");
    QVERIFY(desk.find<QAction>("view.plots").isChecked());
    desk.choose("view.plots");
    settle(desk);
    QVERIFY(!desk.window.docks().isOpen(QStringLiteral("plots")));
    QVERIFY(!desk.find<QAction>("view.plots").isChecked());
    desk.choose("view.plots");
    settle(desk);
    QVERIFY(dock(desk, "plots").isVisible());
  }

  void aHintIsShownWhileAllViewsAreClosed() {
    EmptyDesk desk(home_);
    auto& hint = desk.find<QLabel>("noViews");
    QTRY_VERIFY(!hint.isVisible());
    const auto areas = space(desk).openedDockAreas();
    for (auto* area : areas) area->closeArea();
    QTRY_VERIFY(hint.isVisible());
    QVERIFY(hint.text().contains(QStringLiteral("View menu")));
    QCOMPARE(hint.size(), space(desk).size());
    desk.choose("view.scene");
    QTRY_VERIFY(!hint.isVisible());
  }
};

const widgets::test::GuiTest<DocksGuiTest> kDocksGuiTest;

}  // namespace app::test

#include "DocksGuiTest.moc"
