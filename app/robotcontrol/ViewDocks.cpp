// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/ViewDocks.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <algorithm>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>

#include "widgets/Icon.h"

namespace app {
namespace {

QString nameOf(const QString& id, int number) { return QStringLiteral("%1#%2").arg(id).arg(number); }

ads::DockWidgetArea areaOf(ViewDocks::Place place) {
  switch (place) {
    case ViewDocks::Place::kLeft:
      return ads::LeftDockWidgetArea;
    case ViewDocks::Place::kRight:
      return ads::RightDockWidgetArea;
    case ViewDocks::Place::kTop:
      return ads::TopDockWidgetArea;
    case ViewDocks::Place::kBottom:
      return ads::BottomDockWidgetArea;
    case ViewDocks::Place::kTab:
      break;
  }
  return ads::CenterDockWidgetArea;
}

}  // namespace

ViewDocks::ViewDocks(ads::CDockManager& manager, widgets::ViewContext& context, QObject* parent)
    : QObject(parent), manager_(manager), context_(context) {}

ViewDocks::Dock* ViewDocks::find(const QString& objectName) {
  const auto found = std::find_if(docks_.begin(), docks_.end(),
                                  [&](const Dock& dock) { return dock.dock->objectName() == objectName; });
  return found == docks_.end() ? nullptr : &*found;
}

int ViewDocks::freeNumber(const QString& id) const {
  int number = 1;
  const auto taken = [&] {
    return std::any_of(docks_.begin(), docks_.end(),
                       [&](const Dock& dock) { return dock.dock->objectName() == nameOf(id, number); });
  };
  while (taken()) ++number;
  return number;
}

ViewDocks::Dock* ViewDocks::make(const QString& id, int number) {
  const widgets::ViewType* type = widgets::ViewRegistry::find(id.toStdString());
  if (type == nullptr) return nullptr;
  const QString title = QCoreApplication::translate("View", type->title);
  auto* dock = new ads::CDockWidget(number > 1 ? QStringLiteral("%1 %2").arg(title).arg(number) : title);
  dock->setObjectName(nameOf(id, number));
  dock->setIcon(widgets::icon(type->icon));
  dock->setTabToolTip(QCoreApplication::translate("View", type->help));
  widgets::View* view = type->create(context_, dock);
  dock->setWidget(view, ads::CDockWidget::ForceNoScrollArea);
  connect(view, &widgets::View::titleChanged, dock, [dock](const QString& text) { dock->setWindowTitle(text); });
  docks_.push_back({id, dock, view});
  return &docks_.back();
}

ads::CDockWidget* ViewDocks::add(const QString& id, Place place, ads::CDockWidget* beside) {
  Dock* dock = make(id, freeNumber(id));
  if (dock == nullptr) return nullptr;
  manager_.addDockWidget(areaOf(place), dock->dock, beside == nullptr ? nullptr : beside->dockAreaWidget());
  return dock->dock;
}

ads::CDockWidget* ViewDocks::open(const QString& id) {
  const widgets::ViewType* type = widgets::ViewRegistry::find(id.toStdString());
  if (type == nullptr) return nullptr;
  const auto existing = docks(id);
  const auto closed = std::find_if(existing.begin(), existing.end(), [](auto* dock) { return dock->isClosed(); });
  ads::CDockWidget* dock = nullptr;
  if (closed != existing.end()) {
    dock = *closed;
  } else if (!existing.empty() && !type->several) {
    dock = existing.front();
  } else {
    dock = add(id, Place::kRight, nullptr);
  }
  dock->toggleView(true);
  dock->raise();
  return dock;
}

void ViewDocks::closeAll() {
  for (const Dock& dock : docks_) {
    manager_.removeDockWidget(dock.dock);
    delete dock.dock;
  }
  docks_.clear();
}

void ViewDocks::tick() {
  for (const Dock& dock : docks_) {
    if (dock.view->isVisible()) dock.view->tick();
  }
}

QJsonObject ViewDocks::save() const {
  QJsonArray views;
  for (const Dock& dock : docks_) {
    views.append(QJsonObject{{QStringLiteral("id"), dock.id},
                             {QStringLiteral("dock"), dock.dock->objectName()},
                             {QStringLiteral("state"), dock.view->saveState()}});
  }
  return {{QStringLiteral("docks"), QString::fromUtf8(manager_.saveState(1))}, {QStringLiteral("views"), views}};
}

bool ViewDocks::restore(const QJsonObject& state) {
  const QByteArray xml = state.value(QStringLiteral("docks")).toString().toUtf8();
  const QJsonArray views = state.value(QStringLiteral("views")).toArray();
  if (xml.isEmpty() || views.isEmpty()) return false;
  closeAll();
  for (const auto& value : views) {
    const QJsonObject view = value.toObject();
    const QString id = view.value(QStringLiteral("id")).toString();
    const QString name = view.value(QStringLiteral("dock")).toString();
    if (find(name) != nullptr || !name.startsWith(id + QLatin1Char('#'))) continue;
    const Dock* dock = make(id, name.mid(id.size() + 1).toInt());
    if (dock == nullptr) continue;
    manager_.addDockWidget(ads::RightDockWidgetArea, dock->dock);
    dock->view->restoreState(view.value(QStringLiteral("state")).toObject());
  }
  return manager_.restoreState(xml, 1);
}

std::vector<ads::CDockWidget*> ViewDocks::docks(const QString& id) const {
  std::vector<ads::CDockWidget*> result;
  for (const Dock& dock : docks_) {
    if (dock.id == id) result.push_back(dock.dock);
  }
  return result;
}

}  // namespace app
