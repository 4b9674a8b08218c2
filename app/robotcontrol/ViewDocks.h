// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QObject>
#include <vector>

#include "widgets/View.h"

namespace ads {
class CDockAreaWidget;
class CDockManager;
class CDockWidget;
}  // namespace ads

namespace app {

/// The docks of a window: one for each open view. A closed dock keeps its place and its view; opening it again brings it back
/// where it was. GUI thread.
class ViewDocks : public QObject {
  Q_OBJECT
 public:
  /// Where a new dock goes, seen from another one or from the window.
  enum class Place : std::uint8_t { kLeft, kRight, kTop, kBottom, kTab };

  ViewDocks(ads::CDockManager& manager, widgets::ViewContext& context, QObject* parent);

  /// Opens a view: the one there is, a closed one, or, where several are allowed, a new one. Null if there is no such kind.
  ads::CDockWidget* open(const QString& id);
  /// A new dock at a place; for default perspectives. Null if there is no such kind.
  ads::CDockWidget* add(const QString& id, Place place, ads::CDockWidget* beside = nullptr);
  void closeAll();
  bool empty() const { return docks_.empty(); }

  /// Lets all visible views take in what is new.
  void tick();

  /// Docks, views and what was chosen in them, as JSON; restore() ignores kinds of views that it does not know.
  QJsonObject save() const;
  bool restore(const QJsonObject& state);

  /// All docks whose view is of a kind, open or closed.
  std::vector<ads::CDockWidget*> docks(const QString& id) const;

 private:
  struct Dock {
    QString id;
    ads::CDockWidget* dock;
    widgets::View* view;
  };
  Dock* make(const QString& id, int number);
  Dock* find(const QString& objectName);
  int freeNumber(const QString& id) const;

  ads::CDockManager& manager_;
  widgets::ViewContext& context_;
  std::vector<Dock> docks_;
};

}  // namespace app
