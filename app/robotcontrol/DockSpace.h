// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qtadvanceddocking/DockManager.h>

namespace app {

/// The part of a window in which docks are arranged, together with the floating windows of the docks that
/// were dragged out of it.
///
/// Floating windows belong to the main window: they stay above it, below its dialogs, and are iconified with
/// it. The library's own way (it raises them whenever the main window is left) hides dialogs behind them, so
/// it is switched off. GUI thread.
class DockSpace : public ads::CDockManager {
  Q_OBJECT
 public:
  explicit DockSpace(QWidget* parent);
  ~DockSpace() override;

  /// Lets go of all floating windows; what is in them goes with them. They are deleted when control returns
  /// to the event loop, since one of them may be the cause of the call.
  void releaseFloats();
  /// The same for those that have no dock left.
  void releaseEmptyFloats();
  /// Gives each floating window the names of the views in front as its title.
  void nameFloats();
  /// Shows the floating windows anew, as soon as the main window is on the screen: window managers tie them
  /// to it only then.
  void reopenFloats();
  void hideFloats();

  /// A dock is being dragged or dropped, or a menu or dialog is open, perhaps one that a view waits for: no
  /// dock may be taken away now.
  bool busy() const;
  bool hasVisibleDocks() const;
  /// The area of the main window that covers most; null if all docks are closed or floating.
  ads::CDockAreaWidget* largestArea() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void release(ads::CFloatingDockContainer* floating);

  bool dropping_ = false;
};

}  // namespace app
