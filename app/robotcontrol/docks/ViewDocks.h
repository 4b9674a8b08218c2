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

namespace widgets {
struct SceneRename;
}

namespace app {

class DockSpace;

/// The docks of a window: one for each view. A closed dock keeps its place and its view; reopening shows it
/// where it was. GUI thread; space and context must outlive this object.
///
/// Removed docks leave the window at once and are deleted when control returns to the event loop;
/// destroyAll() deletes them at once. The docking library may delete docks, too, together with their floating
/// window; those are removed from the list automatically.
class ViewDocks : public QObject {
  Q_OBJECT
 public:
  /// The position of a new dock, relative to another dock or to the window.
  enum class Place : std::uint8_t { kLeft, kRight, kTop, kBottom, kTab };

  ViewDocks(DockSpace& space, widgets::ViewContext& context, QObject* parent);

  /// Brings a view to the front: an open one of this kind, else a closed one at its place, else a new one as
  /// a tab of the largest area. Returns null if there is no such kind. "field#2" is a certain one of several.
  ads::CDockWidget* open(const QString& id);
  /// Opens one more view of a kind: a closed one, else a new one. Like open() for kinds that may be open only
  /// once.
  ads::CDockWidget* openAnother(const QString& id);
  /// Gives the keyboard to the view of a dock, or to what is the first in it that takes it.
  static void focusOn(ads::CDockWidget* dock);
  /// Closes all views of a kind; they keep their places.
  void close(const QString& id);
  /// Adds a new dock at a place, for the shipped perspectives. Returns null if there is no such kind.
  ads::CDockWidget* add(const QString& id, Place place, ads::CDockWidget* beside = nullptr);
  /// Removes all docks.
  void closeAll();
  /// Removes all docks and deletes their views at once; call this before objects that they use are
  /// destroyed.
  void destroyAll();
  bool empty() const { return docks_.empty(); }
  /// Whether a view of a kind is open, possibly behind another tab.
  bool isOpen(const QString& id) const;
  /// Whether a view of a kind is open and not behind another tab.
  bool isInFront(const QString& id) const;

  /// Makes all views follow an object of the scene to its new name.
  void follow(const widgets::SceneRename& rename);

  /// Updates all visible views.
  void tick();

  /// The docks with the states of their views as JSON; restore() ignores unknown kinds of views, opens
  /// kMaxRestored views at most, and returns false if the state cannot be used.
  QJsonObject save() const;
  bool restore(const QJsonObject& state);
  static constexpr int kMaxRestored = 100;

  /// The arrangement of the docks in the docking library's XML.
  QString layout() const;
  /// Restores an arrangement for the existing docks and closes those that it does not contain. Returns false
  /// if it names docks that no longer exist, or cannot be read.
  bool rearrange(const QString& layout);

  /// The dock of a view by the name that commands use: "field" for the first that is open, "field#2" for the
  /// second one, open or closed. Null if there is none.
  ads::CDockWidget* named(const QString& name) const;
  /// All open docks, in the order in which they were opened.
  std::vector<ads::CDockWidget*> openDocks() const;

  /// All docks whose view is of a kind, open or closed.
  std::vector<ads::CDockWidget*> docks(const QString& id) const;

 Q_SIGNALS:
  /// The places of the docks are about to be read or changed: a receiver that hides some docks temporarily
  /// must show them now.
  void placesWanted() const;
  /// The user wants to export a view, by the name of its dock.
  void exportWanted(const QString& name);
  /// Emitted when not all views of a state were restored, with a sentence for the user.
  void leftOut(const QString& sentence);

 private:
  /// A dock with its view and the kind of the view.
  struct Dock {
    QString id;
    QPointer<ads::CDockWidget> dock;
    QPointer<widgets::View> view;
    /// The same view, for comparisons only: it is valid while the view is being destroyed, too.
    const QObject* identity = nullptr;
  };
  /// Creates a dock that has no place yet; null if there is no such kind.
  Dock* make(const QString& id, int number);
  /// Puts a view into a dock that has none.
  void put(widgets::View& view, Dock& into);
  /// Puts a text in the place of a view that has thrown an exception, and deletes the view.
  void replaceFailed(widgets::View& failed, const QString& reason);
  /// Null if there is none.
  Dock* find(const QString& objectName);
  /// Creates a dock with the next free number.
  ads::CDockWidget* makeNext(const QString& id);
  /// Shows a dock at its place; without a place it becomes a tab of the largest area.
  ads::CDockWidget* bringToFront(ads::CDockWidget* dock);
  /// The smallest number that no dock of this kind has.
  int freeNumber(const QString& id) const;
  /// Whether all docks of a layout exist.
  bool hasAllOf(const QString& layout);
  /// Called when the docking library has deleted a dock with its floating window.
  void forget(const QObject* view);

  DockSpace& space_;
  widgets::ViewContext& context_;
  /// Contains no null pointers while no event is being processed.
  std::vector<Dock> docks_;
  /// Docks that will be deleted when control returns to the event loop.
  std::vector<QPointer<ads::CDockWidget>> removed_;
};

}  // namespace app
