// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/MaximizedView.h"

#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <QApplication>
#include <QCursor>
#include <QSplitter>
#include <utility>

namespace app {
namespace {

ads::CDockWidget* dockOf(QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    if (auto* dock = qobject_cast<ads::CDockWidget*>(widget)) return dock;
    if (auto* area = qobject_cast<ads::CDockAreaWidget*>(widget)) return area->currentDockWidget();
  }
  return nullptr;
}

}  // namespace

MaximizedView::MaximizedView(ads::CDockManager& manager, QObject* parent)
    : QObject(parent), manager_(manager) {
  // A dock that is added, removed or moved needs the places of the others.
  connect(&manager, &ads::CDockManager::dockAreaCreated, this, &MaximizedView::restore);
  connect(&manager, &ads::CDockManager::dockWidgetAboutToBeRemoved, this, &MaximizedView::restore);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (dockOf(now) != nullptr) used_ = now;
  });
  qApp->installEventFilter(this);
}

bool MaximizedView::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = event->type() == QEvent::MouseButtonPress ? qobject_cast<QWidget*>(watched) : nullptr;
  if (dockOf(widget) != nullptr) used_ = widget;
  return false;
}

ads::CDockWidget* MaximizedView::wanted() const {
  for (QWidget* widget :
       {used_.data(), QApplication::focusWidget(), QApplication::widgetAt(QCursor::pos())}) {
    ads::CDockWidget* dock = dockOf(widget);
    if (dock != nullptr && dock->isVisible() && dock->dockManager() == &manager_ &&
        dock->dockAreaWidget() != nullptr)
      return dock;
  }
  const auto areas = manager_.openedDockAreas();
  return areas.isEmpty() ? nullptr : areas.first()->currentDockWidget();
}

void MaximizedView::toggle() {
  if (active()) return restore();
  ads::CDockWidget* dock = wanted();
  if (dock == nullptr) return;
  if (!dock->isInFloatingContainer()) return maximize(*dock);
  dock->window()->setWindowState(dock->window()->windowState() ^ Qt::WindowMaximized);
}

void MaximizedView::maximize(ads::CDockWidget& dock) {
  restore();
  if (!dock.isInFloatingContainer()) return hideOthers(*dock.dockAreaWidget());
  dock.window()->setWindowState(dock.window()->windowState() | Qt::WindowMaximized);
}

void MaximizedView::hideOthers(QWidget& area) {
  QWidget* child = &area;
  for (QWidget* parent = area.parentWidget(); parent != nullptr && parent != &manager_;
       parent = parent->parentWidget()) {
    if (auto* splitter = qobject_cast<QSplitter*>(parent)) {
      sizes_.emplace_back(splitter, splitter->sizes());
      for (int i = 0; i < splitter->count(); ++i) {
        QWidget* other = splitter->widget(i);
        if (other == child || other->isHidden()) continue;
        hidden_.emplace_back(other);
        other->hide();
      }
    }
    child = parent;
  }
  if (hidden_.empty()) sizes_.clear();  // the view is the only one
}

void MaximizedView::restore() {
  // Cleared first, since showing a widget may call this function again.
  const auto hidden = std::exchange(hidden_, {});
  const auto sizes = std::exchange(sizes_, {});
  for (const auto& widget : hidden) {
    if (widget) widget->show();
  }
  for (const auto& [splitter, before] : sizes) {
    if (splitter && splitter->count() == before.size()) splitter->setSizes(before);
  }
}

}  // namespace app
