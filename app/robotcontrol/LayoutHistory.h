// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QObject>
#include <vector>

namespace app {

class ViewDocks;

/// What the user did to the arrangement of the docks, to be undone: views closed, opened, moved, floated.
/// Sizes alone are no step, but come back with one. GUI thread; the docks must outlive it.
class LayoutHistory : public QObject {
  Q_OBJECT
 public:
  LayoutHistory(ViewDocks& docks, QObject* parent);

  /// Takes note of the present layout; to be called every now and then, and not while a dock is being
  /// dragged.
  void look();
  /// Another perspective is shown: there is nothing to undo.
  void forget();
  /// All docks are about to be replaced; that can be undone, with what was chosen in the views.
  void keepAll();

  bool canUndo() const { return !done_.empty(); }
  bool canRedo() const { return !undone_.empty(); }
  void undo() { step(done_, undone_); }
  void redo() { step(undone_, done_); }

 private:
  using Steps = std::vector<QJsonObject>;  // as ViewDocks::save(), mostly without its "views"

  void step(Steps& from, Steps& to);
  QJsonObject layout() const;

  ViewDocks& docks_;
  QJsonObject present_;
  Steps done_;
  Steps undone_;
};

}  // namespace app
