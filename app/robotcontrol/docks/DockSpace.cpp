// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/DockSpace.h"

#include <qtadvanceddocking/DockAreaTitleBar.h>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockOverlay.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/DockWidgetTab.h>
#include <qtadvanceddocking/FloatingDockContainer.h>
#include <qtadvanceddocking/IconProvider.h>
#include <QApplication>
#include <QEvent>
#include <QPointer>
#include <QScopedValueRollback>
#include <QTimer>
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
/// as what it lies on.
void colorDropSigns(ads::CDockOverlayCross& cross) {
  cross.setIconColor(ads::CDockOverlayCross::FrameColor, QColor(0x2b, 0x6c, 0xc4));
  cross.setIconColor(ads::CDockOverlayCross::WindowBackgroundColor, Qt::white);
  cross.setIconColor(ads::CDockOverlayCross::OverlayColor, QColor(0x2b, 0x6c, 0xc4, 90));
  cross.setIconColor(ads::CDockOverlayCross::ArrowColor, QColor(0x5b, 0x9c, 0xf4));
  cross.setIconColor(ads::CDockOverlayCross::ShadowColor, QColor(0, 0, 0, 64));
}

/// Is a dock perhaps dropped by an event? Windows that the window manager moves are dropped when they become
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

}  // namespace

DockSpace::DockSpace(QWidget* parent) : ads::CDockManager(parent) {
  window()->removeEventFilter(this);
  setStyleSheet(QString());  // the colors of the application's palette, not those of the library
  useIconsOfThePalette();
  for (auto* cross : findChildren<ads::CDockOverlayCross*>()) colorDropSigns(*cross);
  qApp->installNativeEventFilter(this);
  connect(this, &ads::CDockManager::dockAreaCreated, this,
          [this](ads::CDockAreaWidget* area) { area->titleBar()->installEventFilter(this); });
  connect(this, &ads::CDockManager::floatingWidgetCreated, this,
          [this](ads::CFloatingDockContainer* floating) {
            floating->installEventFilter(this);
            // Only windows of this kind are tied to their parent on X.
            floating->setWindowFlags(Qt::Dialog | Qt::CustomizeWindowHint | Qt::WindowTitleHint |
                                     Qt::WindowCloseButtonHint | Qt::WindowMaximizeButtonHint);
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

void DockSpace::nameFloats() {
  for (ads::CFloatingDockContainer* floating : floatingWidgets()) {
    const QString title = titleOf(*floating);
    if (!title.isEmpty() && floating->windowTitle() != title) floating->setWindowTitle(title);
  }
}

void DockSpace::reopenFloats() {
  std::vector<QPointer<ads::CDockWidget>> docks;
  for (ads::CFloatingDockContainer* floating : floatingWidgets()) {
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
  // While the library processes a dropped dock, it also runs other events, such as shortcuts and timers.
  if (!mayDrop(watched, event->type())) return QObject::eventFilter(watched, event);
  const QScopedValueRollback<bool> dropping(dropping_, true);
  return watched->event(event);
}

}  // namespace app
