// SPDX-License-Identifier: GPL-3.0-or-later
// More views in one area than have room for their tabs.
#include <qtadvanceddocking/DockAreaTabBar.h>
#include <qtadvanceddocking/DockAreaTitleBar.h>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/DockWidgetTab.h>
#include <QLabel>

#include "app/robotcontrol/docks/DockSpace.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

/// A desk with all views open.
struct ManyViewsDesk : EmptyDesk {
  explicit ManyViewsDesk(const std::filesystem::path& home) : EmptyDesk(home) {
    for (const widgets::ViewType& type : widgets::ViewRegistry::all())
      window.docks().open(QLatin1String(type.id));
    fit();
  }
  app::DockSpace& space() { return *window.findChild<app::DockSpace*>(); }
  void fit() {
    QCoreApplication::processEvents();
    window.tick();
    space().fitTabs();
    QCoreApplication::processEvents();
  }
};

}  // namespace

class ManyTabsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void ofManyTabsEachCanBeRead() {
    ManyViewsDesk desk(home_);
    widgets::test::keepPicture(desk.window, "docks-many");
    for (const ads::CDockWidget* each : desk.window.docks().openDocks()) {
      const auto& title = *each->tabWidget()->findChild<QLabel*>(QStringLiteral("dockWidgetTabLabel"));
      const int whole = title.fontMetrics().horizontalAdvance(each->windowTitle());
      QVERIFY2(title.width() >= std::min(whole, 40), qPrintable(each->windowTitle()));
    }
  }

  void ofManyTabsInOneAreaEachIsReached() {
    ManyViewsDesk desk(home_);
    ads::CDockWidget& first = *desk.window.docks().docks(QStringLiteral("messages")).front();
    for (ads::CDockWidget* each : desk.window.docks().openDocks()) {
      if (each != &first) desk.space().addDockWidgetTabToArea(each, first.dockAreaWidget());
    }
    first.setAsCurrentTab();
    desk.fit();
    const ads::CDockAreaTitleBar& bar = *first.dockAreaWidget()->titleBar();
    ads::CDockAreaTabBar& tabs = *bar.tabBar();
    QVERIFY(tabs.count() > 20);
    const auto isSeen = [](const ads::CDockWidgetTab& tab) { return !tab.visibleRegion().isEmpty(); };
    const ads::CDockWidgetTab& last = *tabs.tab(tabs.count() - 1);
    tabs.ensureWidgetVisible(tabs.tab(0));
    QVERIFY(!isSeen(last));
    for (int i = 0; i < 300 && !isSeen(last); ++i) widgets::test::turnWheel(*tabs.viewport(), {20, 10}, -1);
    QVERIFY(isSeen(last));
    auto* button = qobject_cast<QToolButton*>(bar.button(ads::TitleBarButtonTabsMenu));
    QVERIFY(button != nullptr && button->isVisible());
    Q_EMIT button->menu()->aboutToShow();
    QCOMPARE(button->menu()->actions().size(), tabs.count());
    // A title that is cut is whole in the tooltip.
    for (int i = 0; i < tabs.count(); ++i)
      QVERIFY(
          tabs.tab(i)->toolTip().startsWith(tabs.tab(i)->dockWidget()->windowTitle() + QLatin1Char('\n')));
  }
};

const widgets::test::GuiTest<ManyTabsGuiTest> kManyTabsGuiTest;

}  // namespace app::test

#include "ManyTabsGuiTest.moc"
