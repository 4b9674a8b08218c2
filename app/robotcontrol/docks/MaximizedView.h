// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <utility>
#include <vector>

class QSplitter;
class QWidget;
namespace ads {
class CDockManager;
class CDockWidget;
}  // namespace ads

namespace app {

/// Gives one view of a window all the space, and undoes this. The docking state does not change: the other
/// docks are merely hidden, so that restore() must be called before that state is saved. GUI thread; the
/// manager must outlive this object.
class MaximizedView final : public QObject {
  Q_OBJECT
 public:
  MaximizedView(ads::CDockManager& manager, QObject* parent);

  /// Maximizes the view that was clicked or got the focus last, or else the one under the mouse, or else the
  /// first one; if a view is maximized, calls restore(). The window of a floating view is maximized on the
  /// screen instead.
  void toggle();
  /// Maximizes a view, instead of the one that may be maximized.
  void maximize(ads::CDockWidget& dock);
  /// Shows all docks with their sizes as before; without effect if no view is maximized.
  void restore();
  /// Notes which view is clicked: not all of its parts take the focus. Handles no event.
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Whether a view is maximized within the main window.
  bool active() const { return !hidden_.empty(); }

 private:
  /// The view to maximize; null if there is none.
  ads::CDockWidget* wanted() const;
  /// Hides everything but a dock area.
  void hideOthers(QWidget& area);

  ads::CDockManager& manager_;
  /// The part of a view that was clicked or got the focus last.
  QPointer<QWidget> used_;
  /// The hidden widgets; empty if no view is maximized.
  std::vector<QPointer<QWidget>> hidden_;
  /// The sizes of the splitters around the view, as they were before.
  std::vector<std::pair<QPointer<QSplitter>, QList<int>>> sizes_;
};

}  // namespace app
