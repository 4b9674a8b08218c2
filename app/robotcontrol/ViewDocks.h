// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QObject>
#include <QPointer>
#include <vector>

#include "widgets/View.h"

namespace ads {
class CDockAreaWidget;
class CDockWidget;
}  // namespace ads

namespace app {

class DockSpace;

/// The docks of a window: one for each open view. A closed dock keeps its place and its view; opening it
/// again brings it back where it was. GUI thread.
///
/// Docks that are taken away leave the window at once and are deleted when control returns to the event loop;
/// destroyAll() deletes them at once. The docking library may delete docks, too, with the floating window
/// that they are in: those leave the list by themselves.
class ViewDocks : public QObject {
  Q_OBJECT
 public:
  /// Where a new dock goes, seen from another one or from the window.
  enum class Place : std::uint8_t { kLeft, kRight, kTop, kBottom, kTab };

  ViewDocks(DockSpace& space, widgets::ViewContext& context, QObject* parent);

  /// Brings a view to the front: one that is open, else a closed one where it was, else a new one as a tab of
  /// the largest area. Null if there is no such kind.
  ads::CDockWidget* open(const QString& id);
  /// One more view of a kind, even if one is open: a closed one, else a new one. Where only one is allowed,
  /// as open().
  ads::CDockWidget* openAnother(const QString& id);
  /// Closes the views of a kind; they keep their places.
  void close(const QString& id);
  /// A new dock at a place; for default perspectives. Null if there is no such kind.
  ads::CDockWidget* add(const QString& id, Place place, ads::CDockWidget* beside = nullptr);
  void closeAll();
  /// As closeAll(), and deletes the views now, before what they use goes.
  void destroyAll();
  bool empty() const { return docks_.empty(); }
  /// Whether a view of a kind is open, perhaps behind another tab.
  bool isOpen(const QString& id) const;
  /// Whether a view of a kind can be seen now.
  bool isInFront(const QString& id) const;
  bool anyOpen() const;

  /// Lets all visible views take in what is new.
  void tick();

  /// Docks, views and what was chosen in them, as JSON; restore() ignores kinds of views that it does not
  /// know.
  QJsonObject save() const;
  bool restore(const QJsonObject& state);

  /// Where the docks are, in the docking library's XML; rearrange() puts those that are there back to it, and
  /// closes others. False if the layout names docks that are not there any more, or cannot be read.
  QString layout() const;
  bool rearrange(const QString& layout);

  /// All docks whose view is of a kind, open or closed.
  std::vector<ads::CDockWidget*> docks(const QString& id) const;

 Q_SIGNALS:
  /// The places of the docks are about to be looked at or changed: what hides some of them for a while shows
  /// them.
  void placesWanted() const;

 private:
  struct Dock {
    QString id;
    QPointer<ads::CDockWidget> dock;
    QPointer<widgets::View> view;
  };
  Dock* make(const QString& id, int number);
  Dock* find(const QString& objectName);
  ads::CDockWidget* makeNext(const QString& id);
  /// Where it was; a dock without a place becomes a tab of the largest area.
  ads::CDockWidget* bringToFront(ads::CDockWidget* dock);
  int freeNumber(const QString& id) const;
  bool hasAllOf(const QString& layout);
  /// The dock of a view was deleted with its floating window.
  void forget(const QObject* view);

  DockSpace& space_;
  widgets::ViewContext& context_;
  std::vector<Dock> docks_;                          // never with null pointers between events
  std::vector<QPointer<ads::CDockWidget>> removed_;  // to be deleted soon
};

}  // namespace app
