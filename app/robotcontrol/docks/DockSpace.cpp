// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/DockSpace.h"

#include <qtadvanceddocking/DockAreaTabBar.h>
#include <qtadvanceddocking/DockAreaTitleBar.h>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockOverlay.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/DockWidgetTab.h>
#include <qtadvanceddocking/FloatingDockContainer.h>
#include <qtadvanceddocking/IconProvider.h>
#include <QAbstractButton>
#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QPointer>
#include <QScopedValueRollback>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "widgets/Icon.h"

namespace app {
namespace {

/// The library's own icons are dark gray, which cannot be seen on a dark window.
void useIconsOfThePalette() {
  auto& icons = ads::CDockManager::iconProvider();
  icons.registerCustomIcon(ads::TabCloseIcon, widgets::icon("close"));
  icons.registerCustomIcon(ads::DockAreaCloseIcon, widgets::icon("close"));
  icons.registerCustomIcon(ads::DockAreaMenuIcon, widgets::icon("chevron-down"));
  icons.registerCustomIcon(ads::DockAreaUndockIcon, widgets::icon("float"));
}

/// The signs where a dock can be dropped; the library takes them from the palette, where an arrow is as dark
/// as its background.
void colorDropSigns(ads::CDockOverlayCross& cross) {
  cross.setIconColor(ads::CDockOverlayCross::FrameColor, QColor(0x2b, 0x6c, 0xc4));
  cross.setIconColor(ads::CDockOverlayCross::WindowBackgroundColor, Qt::white);
  cross.setIconColor(ads::CDockOverlayCross::OverlayColor, QColor(0x2b, 0x6c, 0xc4, 90));
  cross.setIconColor(ads::CDockOverlayCross::ArrowColor, QColor(0x5b, 0x9c, 0xf4));
  cross.setIconColor(ads::CDockOverlayCross::ShadowColor, QColor(0, 0, 0, 64));
}

/// Whether an event may drop a dock. Windows that the window manager moves are dropped when they become
/// active again.
bool mayDrop(const QObject* object, QEvent::Type event) {
  if (event == QEvent::ActivationChange)
    return qobject_cast<const ads::CFloatingDockContainer*>(object) != nullptr;
  return event == QEvent::MouseButtonRelease &&
         (qobject_cast<const ads::CDockWidgetTab*>(object) != nullptr ||
          qobject_cast<const ads::CDockAreaTitleBar*>(object) != nullptr);
}

/// The titles of the views in front in each area of a floating window: "Messages", "Image, Field".
QString titleOf(const ads::CFloatingDockContainer& floating) {
  QStringList names;
  for (const ads::CDockAreaWidget* area : floating.dockContainer()->openedDockAreas()) {
    if (const auto* dock = area->currentDockWidget()) names << dock->windowTitle();
  }
  return names.join(QStringLiteral(", "));
}

/// The labels of a tab; null where it has none.
struct TabLabels {
  QLabel *icon = nullptr, *title = nullptr;

  explicit TabLabels(const ads::CDockWidgetTab& tab) {
    for (auto* label : tab.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
      (label->objectName() == QLatin1String("dockWidgetTabLabel") ? title : icon) = label;
  }
};

/// The room that the tabs of an area share, pixels.
int roomForTabs(const ads::CDockAreaTitleBar& bar) {
  int room = bar.contentsRect().width();
  for (const auto* button : bar.findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (!button->isHidden()) room -= button->sizeHint().width();
  }
  // An area that is narrower than its buttons, as before the window has its size, has none.
  return std::max(0, room);
}

/// The width at which the longest of these titles have to be cut so that all fit the room.
int commonWidth(std::vector<int> titles, int room) {
  std::ranges::sort(titles);
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const int share = std::max(0, room) / static_cast<int>(titles.size() - i);
    if (titles[i] > share) return share;
    room -= titles[i];
  }
  return room;
}

void fitTabsOf(const ads::CDockAreaTitleBar& bar) {
  const int room = roomForTabs(bar);
  std::vector<TabLabels> tabs;
  std::vector<int> others;  // widths of the titles of all but the tab in front
  int withIcons = 0, forTitles = room;
  for (int i = 0; i < bar.tabBar()->count(); ++i) {
    const ads::CDockWidgetTab& tab = *bar.tabBar()->tab(i);
    const TabLabels labels(tab);
    if (tab.isHidden() || labels.icon == nullptr || labels.title == nullptr) continue;
    tabs.push_back(labels);
    const int icon = labels.icon->sizeHint().width(), title = labels.title->sizeHint().width();
    const int plain = tab.sizeHint().width() - (labels.icon->isHidden() ? 0 : icon);
    withIcons += plain + icon;
    forTitles -= tab.isActiveTab() ? plain : plain - title;
    if (!tab.isActiveTab()) others.push_back(title);
  }
  // The title in front is whole, if it does not take all; of the others the longest are cut first.
  // Where that leaves nothing to be read, the tabs are scrolled.
  constexpr int kMinLetters = 7;
  const int least = kMinLetters * bar.fontMetrics().averageCharWidth();
  const int cut = std::max(commonWidth(others, std::max(forTitles, room / 3)), least);
  for (const TabLabels& tab : tabs) {
    const auto* owner = static_cast<const ads::CDockWidgetTab*>(tab.title->parentWidget());
    const int title = tab.title->sizeHint().width();
    tab.title->setMinimumWidth(std::min(title, owner->isActiveTab() ? room / 2 : cut));
    tab.icon->setVisible(withIcons <= room);
  }
}

}  // namespace

DockSpace::DockSpace(QWidget* parent) : ads::CDockManager(parent) {
  window()->removeEventFilter(this);
  setStyleSheet(QString());  // the colors of the application's palette, not those of the library
  useIconsOfThePalette();
  for (auto* cross : findChildren<ads::CDockOverlayCross*>()) colorDropSigns(*cross);
  qApp->installNativeEventFilter(this);
  connect(this, &ads::CDockManager::dockAreaCreated, this, [this](ads::CDockAreaWidget* area) {
    ads::CDockAreaTitleBar* bar = area->titleBar();
    bar->installEventFilter(this);
    connect(bar->tabBar(), &ads::CDockAreaTabBar::currentChanged, bar, [bar] { fitTabsOf(*bar); });
  });
  connect(this, &ads::CDockManager::floatingWidgetCreated, this,
          [this](ads::CFloatingDockContainer* floating) {
            floating->installEventFilter(this);
            // Only windows of this kind are tied to their parent on X.
            floating->setWindowFlags(Qt::Dialog | Qt::CustomizeWindowHint | Qt::WindowTitleHint |
                                     Qt::WindowCloseButtonHint | Qt::WindowMaximizeButtonHint);
            floating->setAttribute(Qt::WA_DontShowOnScreen, !window()->isVisible());
          });
}

DockSpace::~DockSpace() {
  const auto floats = findChildren<ads::CFloatingDockContainer*>(QString(), Qt::FindDirectChildrenOnly);
  qDeleteAll(floats);
}

void DockSpace::release(ads::CFloatingDockContainer* floating) {
  removeFloatingWidget(floating);
  removeDockContainer(floating->dockContainer());
  floating->hide();
  floating->deleteLater();
}

void DockSpace::releaseFloats() {
  const auto floats = floatingWidgets();
  for (ads::CFloatingDockContainer* floating : floats) release(floating);
}

void DockSpace::releaseEmptyFloats() {
  const auto floats = floatingWidgets();
  for (ads::CFloatingDockContainer* floating : floats) {
    if (floating->dockWidgets().isEmpty()) release(floating);
  }
}

void DockSpace::fitTabs() {
  for (const ads::CDockContainerWidget* container : dockContainers()) {
    for (const ads::CDockAreaWidget* area : container->openedDockAreas()) fitTabsOf(*area->titleBar());
  }
}

void DockSpace::nameFloats() {
  for (ads::CFloatingDockContainer* floating : floatingWidgets()) {
    const QString title = titleOf(*floating);
    if (!title.isEmpty() && floating->windowTitle() != title) floating->setWindowTitle(title);
  }
}

void DockSpace::openFloats() {
  std::vector<QPointer<ads::CDockWidget>> docks;
  for (ads::CFloatingDockContainer* floating : floatingWidgets()) {
    if (!floating->testAttribute(Qt::WA_DontShowOnScreen)) continue;
    floating->setAttribute(Qt::WA_DontShowOnScreen, false);
    if (!floating->isVisible()) continue;
    for (const ads::CDockAreaWidget* area : floating->dockContainer()->openedDockAreas()) {
      for (ads::CDockWidget* dock : area->openedDockWidgets()) {
        if (dock != area->currentDockWidget()) docks.emplace_back(dock);
      }
      docks.emplace_back(area->currentDockWidget());  // the last one comes to the front
    }
    floating->hide();
  }
  if (docks.empty()) return;
  QTimer::singleShot(0, this, [docks] {
    for (const auto& dock : docks) {
      if (dock) dock->toggleView(true);
    }
  });
}

void DockSpace::hideFloats() {
  for (ads::CFloatingDockContainer* floating : floatingWidgets()) floating->hide();
}

bool DockSpace::busy() const {
  return dropping_ || QWidget::mouseGrabber() != nullptr || QApplication::activePopupWidget() != nullptr ||
         QApplication::activeModalWidget() != nullptr;
}

bool DockSpace::hasVisibleDocks() const {
  return !openedDockAreas().isEmpty();
}

ads::CDockAreaWidget* DockSpace::largestArea() const {
  ads::CDockAreaWidget* largest = nullptr;
  for (ads::CDockAreaWidget* area : openedDockAreas()) {
    const auto size = [](const QWidget& widget) { return widget.width() * widget.height(); };
    if (largest == nullptr || size(*area) > size(*largest)) largest = area;
  }
  return largest;
}

bool DockSpace::nativeEventFilter(const QByteArray& type, void* event, long* /*result*/) {
  constexpr unsigned kFocusIn = 9;  // of the X protocol; its highest bit says who sent it
  if (type == "xcb_generic_event_t" && (*static_cast<const std::uint8_t*>(event) & 0x7FU) == kFocusIn) {
    if (QWidget* dialog = QApplication::activeModalWidget()) dialog->raise();
  }
  return false;
}

bool DockSpace::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    if (const auto* bar = qobject_cast<const ads::CDockAreaTitleBar*>(watched)) fitTabsOf(*bar);
  }
  // While the library processes a dropped dock, it also runs other events, such as shortcuts and timers.
  if (!mayDrop(watched, event->type())) return QObject::eventFilter(watched, event);
  const QScopedValueRollback<bool> dropping(dropping_, true);
  return watched->event(event);
}

}  // namespace app
