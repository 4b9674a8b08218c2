// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QObject>
#include <vector>

namespace app {

class ViewDocks;

/// The undo history of the arrangement of docks: views that were closed, opened, moved, or floated. A changed
/// size or another tab in front is no step of its own, but is restored together with one. Limited to the last
/// 50 steps. GUI thread; the docks must outlive this object.
class LayoutHistory : public QObject {
  Q_OBJECT
 public:
  LayoutHistory(ViewDocks& docks, QObject* parent);

  /// Compares the current layout with the last known one and adds a step if they differ. Call this
  /// regularly, but not while a dock is being dragged.
  void look();
  /// Clears the history, for example because another perspective is shown.
  void forget();
  /// Adds a step that also contains the state of the views; call this before all docks are replaced.
  void keepAll();

  /// Whether undo() or redo() has an effect.
  bool canUndo() const { return !done_.empty(); }
  bool canRedo() const { return !undone_.empty(); }
  void undo() { step(done_, undone_); }
  void redo() { step(undone_, done_); }

 private:
  /// States as returned by ViewDocks::save(), mostly without "views".
  using Steps = std::vector<QJsonObject>;

  /// Restores the last state of `from` that still can be restored and adds the current one to `to`.
  void step(Steps& from, Steps& to);
  /// The current layout without the state of the views.
  QJsonObject layout() const;

  ViewDocks& docks_;
  /// The last known layout.
  QJsonObject present_;
  Steps done_;
  Steps undone_;
};

}  // namespace app
