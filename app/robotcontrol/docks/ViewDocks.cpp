// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/ViewDocks.h"

#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/DockWidgetTab.h>
#include <QCoreApplication>
#include <QJsonArray>
#include <QXmlStreamReader>
#include <algorithm>
#include <exception>

#include "app/robotcontrol/docks/DockLayout.h"
#include "app/robotcontrol/docks/DockSpace.h"
#include "app/robotcontrol/docks/FailedView.h"
#include "robotlink/session/Session.h"
#include "widgets/HiddenTick.h"
#include "widgets/Icon.h"
#include "widgets/world/SceneRename.h"

namespace app {
namespace {

constexpr int kLayoutVersion = 1;

QString dockNameOf(const QString& id, int number) {
  return QStringLiteral("%1#%2").arg(id).arg(number);
}

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

ViewDocks::ViewDocks(DockSpace& space, widgets::ViewContext& context, QObject* parent)
    : QObject(parent), space_(space), context_(context) {}

ViewDocks::Dock* ViewDocks::find(const QString& objectName) {
  const auto found = std::find_if(docks_.begin(), docks_.end(),
                                  [&](const Dock& dock) { return dock.dock->objectName() == objectName; });
  return found == docks_.end() ? nullptr : &*found;
}

void ViewDocks::forget(const QObject* view) {
  // While a widget emits destroyed(), pointers to it are not null yet, but it is no longer a view.
  std::erase_if(docks_, [&](const Dock& dock) { return dock.identity == view || !dock.dock || !dock.view; });
}

int ViewDocks::freeNumber(const QString& id) const {
  int number = 1;
  const auto taken = [&] {
    return std::any_of(docks_.begin(), docks_.end(),
                       [&](const Dock& dock) { return dock.dock->objectName() == dockNameOf(id, number); });
  };
  while (taken()) ++number;
  return number;
}

ViewDocks::Dock* ViewDocks::make(const QString& id, int number) {
  const widgets::ViewType* type = widgets::ViewRegistry::find(id.toStdString());
  if (type == nullptr) return nullptr;
  const QString title = QCoreApplication::translate("View", type->title);
  auto* dock =
      new ads::CDockWidget(number > 1 ? QStringLiteral("%1 %2").arg(title, QString::number(number)) : title);
  dock->setObjectName(dockNameOf(id, number));
  dock->setIcon(widgets::icon(type->icon));
  // The title on the tab may be cut.
  const auto showTip = [dock, help = QCoreApplication::translate("View", type->help)] {
    dock->setTabToolTip(dock->windowTitle() + QLatin1Char('\n') + help);
  };
  connect(dock, &QWidget::windowTitleChanged, dock, showTip);
  showTip();
  dock->tabWidget()->installEventFilter(&space_);
  widgets::View* view = nullptr;
  try {
    view = type->create(context_, dock);
  } catch (const std::exception& thrown) {
    view = new FailedView(context_, QString::fromUtf8(thrown.what()), {}, dock);
  }
  docks_.push_back({id, dock, nullptr, nullptr});
  put(*view, docks_.back());
  return &docks_.back();
}

void ViewDocks::put(widgets::View& view, Dock& into) {
  ads::CDockWidget* dock = into.dock;
  dock->setWidget(&view, ads::CDockWidget::ForceNoScrollArea);
  connect(&view, &widgets::View::titleChanged, dock,
          [dock](const QString& text) { dock->setWindowTitle(text); });
  connect(&view, &widgets::View::exportWanted, this,
          [this, dock] { Q_EMIT exportWanted(dock->objectName()); });
  connect(&view, &QObject::destroyed, this, &ViewDocks::forget);
  into.view = &view;
  into.identity = &view;
}

void ViewDocks::replaceFailed(widgets::View& failed, const QString& reason) {
  const auto entry = std::ranges::find(docks_, &failed, [](const Dock& dock) { return dock.view.data(); });
  if (entry == docks_.end()) return;
  QJsonObject state;
  try {
    state = failed.saveState();
  } catch (const std::exception&) {
    // The view cannot even save its state; the new one starts with its defaults.
  }
  entry->dock->takeWidget();
  failed.hide();
  failed.deleteLater();
  put(*new FailedView(context_, reason, state, entry->dock), *entry);
}

ads::CDockWidget* ViewDocks::add(const QString& id, Place place, ads::CDockWidget* beside) {
  Dock* dock = make(id, freeNumber(id));
  if (dock == nullptr) return nullptr;
  space_.addDockWidget(areaOf(place), dock->dock, beside == nullptr ? nullptr : beside->dockAreaWidget());
  return dock->dock;
}

ads::CDockWidget* ViewDocks::makeNext(const QString& id) {
  const Dock* dock = make(id, freeNumber(id));
  return dock == nullptr ? nullptr : dock->dock.data();
}

ads::CDockWidget* ViewDocks::bringToFront(ads::CDockWidget* dock) {
  if (dock == nullptr) return nullptr;
  if (dock->dockAreaWidget() == nullptr) {
    ads::CDockAreaWidget* area = space_.largestArea();
    space_.addDockWidget(area == nullptr ? ads::RightDockWidgetArea : ads::CenterDockWidgetArea, dock, area);
  }
  dock->toggleView(true);
  dock->setAsCurrentTab();
  dock->raise();
  return dock;
}

ads::CDockWidget* ViewDocks::open(const QString& id) {
  Q_EMIT placesWanted();
  if (id.contains(QLatin1Char('#'))) return bringToFront(named(id));
  const auto existing = docks(id);
  const auto open =
      std::find_if(existing.begin(), existing.end(), [](auto* dock) { return !dock->isClosed(); });
  if (open != existing.end()) return bringToFront(*open);
  return bringToFront(existing.empty() ? makeNext(id) : existing.front());
}

void ViewDocks::focusOn(ads::CDockWidget* dock) {
  if (dock == nullptr || dock->widget() == nullptr) return;
  QWidget* const view = dock->widget();
  QWidget* first = view;
  // The chain leads around the whole window.
  const auto takesFocus = [view](const QWidget& widget) {
    return widget.isEnabled() && widget.isVisibleTo(view) &&
           (widget.focusProxy() != nullptr || (widget.focusPolicy() & Qt::TabFocus) != 0);
  };
  while (!takesFocus(*first)) {
    first = first->nextInFocusChain();
    if (first == view || !view->isAncestorOf(first)) return view->setFocus();
  }
  first->setFocus();
}

ads::CDockWidget* ViewDocks::openAnother(const QString& id) {
  const widgets::ViewType* type = widgets::ViewRegistry::find(id.toStdString());
  if (type == nullptr || !type->several) return open(id);
  const auto existing = docks(id);
  const auto closed =
      std::find_if(existing.begin(), existing.end(), [](auto* dock) { return dock->isClosed(); });
  return bringToFront(closed == existing.end() ? makeNext(id) : *closed);
}

void ViewDocks::close(const QString& id) {
  for (ads::CDockWidget* dock : docks(id)) dock->toggleView(false);
}

void ViewDocks::closeAll() {
  const auto docks = std::exchange(docks_, {});
  for (const Dock& dock : docks) {
    space_.removeDockWidget(dock.dock);
    dock.dock->hide();
    dock.dock->setParent(nullptr);
    dock.dock->deleteLater();
    removed_.push_back(dock.dock);
  }
  space_.releaseFloats();
  removed_.erase(std::remove(removed_.begin(), removed_.end(), nullptr), removed_.end());
}

void ViewDocks::destroyAll() {
  closeAll();
  const auto removed = std::exchange(removed_, {});
  for (const auto& dock : removed) delete dock.data();
}

bool ViewDocks::isOpen(const QString& id) const {
  return std::any_of(docks_.begin(), docks_.end(),
                     [&](const Dock& dock) { return dock.id == id && !dock.dock->isClosed(); });
}

bool ViewDocks::isInFront(const QString& id) const {
  return std::any_of(docks_.begin(), docks_.end(), [&](const Dock& dock) {
    return dock.id == id && !dock.dock->isClosed() && dock.dock->isCurrentTab();
  });
}

void ViewDocks::follow(const widgets::SceneRename& rename) {
  for (const Dock& dock : docks_) {
    if (dock.view)
      dock.view->followNames([&](const QJsonValue& names) { return widgets::withRename(names, rename); });
  }
}

void ViewDocks::tick() {
  // A view may open a dialog, during which the list of docks may change.
  const auto docks = docks_;
  for (const Dock& dock : docks) {
    if (!dock.view) continue;
    auto* hidden = dock.view->isVisible() || dock.dock->isClosed()
                       ? nullptr
                       : dynamic_cast<widgets::HiddenTick*>(dock.view.data());
    if (!dock.view->isVisible() && hidden == nullptr) continue;
    const robotlink::StreamReaders::Scope reading(context_.session.readers(),
                                                  dock.dock->objectName().toStdString(),
                                                  dock.dock->windowTitle().toStdString());
    try {
      hidden != nullptr ? hidden->tickHidden() : dock.view->tick();
    } catch (const std::exception& thrown) {
      // The others continue.
      if (dock.view) replaceFailed(*dock.view, QString::fromUtf8(thrown.what()));
    }
  }
}

QJsonObject ViewDocks::save() const {
  QJsonArray views;
  for (const Dock& dock : docks_) {
    views.append(QJsonObject{{QStringLiteral("id"), dock.id},
                             {QStringLiteral("dock"), dock.dock->objectName()},
                             {QStringLiteral("state"), dock.view->saveState()}});
  }
  return {{QStringLiteral("docks"), layout()}, {QStringLiteral("views"), views}};
}

bool ViewDocks::restore(const QJsonObject& state) {
  const QByteArray xml = state.value(QStringLiteral("docks")).toString().toUtf8();
  const QJsonArray views = state.value(QStringLiteral("views")).toArray();
  if (views.isEmpty() || !isDockLayout(xml)) return false;
  closeAll();
  for (int i = 0; i < std::min(views.size(), kMaxRestored); ++i) {
    const QJsonObject view = views.at(i).toObject();
    const QString id = view.value(QStringLiteral("id")).toString();
    const QString name = view.value(QStringLiteral("dock")).toString();
    if (find(name) != nullptr || !name.startsWith(id + QLatin1Char('#'))) continue;
    const Dock* dock = make(id, name.mid(id.size() + 1).toInt());
    if (dock == nullptr) continue;
    space_.addDockWidget(ads::RightDockWidgetArea, dock->dock);
    dock->view->restoreState(view.value(QStringLiteral("state")).toObject());
  }
  const bool restored = space_.restoreState(xml, kLayoutVersion);
  space_.releaseEmptyFloats();
  if (views.size() > kMaxRestored)
    Q_EMIT leftOut(tr("The saved window layout has too many views (%1); only the first %2 were opened.")
                       .arg(views.size())
                       .arg(kMaxRestored));
  return restored;
}

QString ViewDocks::layout() const {
  Q_EMIT placesWanted();
  return QString::fromUtf8(space_.saveState(kLayoutVersion));
}

bool ViewDocks::hasAllOf(const QString& layout) {
  QXmlStreamReader reader(layout);
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement || reader.name() != QLatin1String("Widget"))
      continue;
    if (find(reader.attributes().value(QLatin1String("Name")).toString()) == nullptr) return false;
  }
  return !reader.hasError();
}

bool ViewDocks::rearrange(const QString& layout) {
  space_.releaseEmptyFloats();
  if (!hasAllOf(layout) || !isDockLayout(layout.toUtf8())) return false;
  const bool restored = space_.restoreState(layout.toUtf8(), kLayoutVersion);
  space_.releaseEmptyFloats();
  return restored;
}

ads::CDockWidget* ViewDocks::named(const QString& name) const {
  for (const Dock& dock : docks_) {
    if (dock.dock->objectName() == name || (dock.id == name && !dock.dock->isClosed())) return dock.dock;
  }
  return nullptr;
}

std::vector<ads::CDockWidget*> ViewDocks::openDocks() const {
  std::vector<ads::CDockWidget*> open;
  for (const Dock& dock : docks_) {
    if (!dock.dock->isClosed()) open.push_back(dock.dock);
  }
  return open;
}

std::vector<ads::CDockWidget*> ViewDocks::docks(const QString& id) const {
  std::vector<ads::CDockWidget*> result;
  for (const Dock& dock : docks_) {
    if (dock.id == id) result.push_back(dock.dock);
  }
  return result;
}

}  // namespace app
