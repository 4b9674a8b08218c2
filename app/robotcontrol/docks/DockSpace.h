// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qtadvanceddocking/DockManager.h>
#include <QAbstractNativeEventFilter>

namespace app {

/// The part of a window in which docks are arranged, together with the floating windows into which docks were
/// dragged.
///
/// Floating windows belong to the main window: they stay above it and below its dialogs, and are minimized
/// with it. The behavior of the library, which raises them whenever the main window loses the focus, would
/// hide dialogs behind them and is disabled. GUI thread.
class DockSpace : public ads::CDockManager, private QAbstractNativeEventFilter {
  Q_OBJECT
 public:
  explicit DockSpace(QWidget* parent);
  ~DockSpace() override;

  /// Closes all floating windows together with their contents. They are deleted when control returns to the
  /// event loop, since the call may come from one of them.
  void releaseFloats();
  /// Closes the floating windows without docks in the same way.
  void releaseEmptyFloats();
  /// Sets the title of each floating window to the names of the views in front.
  void nameFloats();
  /// Makes titles of tabs readable: where they would be cut, tabs have no icons, and that of the view in
  /// front is cut last. If there are too many to be read, they are scrolled.
  void fitTabs();
  /// Opens the floating windows that were made before the main window was visible; call this when it is
  /// shown. Window managers associate them with it only then. They are not on the screen before: a window
  /// that is hidden and shown again before the window manager has seen it may never appear.
  void openFloats();
  /// Hides all floating windows.
  void hideFloats();

  /// Whether docks must not be removed now: a dock is being dragged or dropped, or a menu or dialog is open,
  /// perhaps one for which a view waits.
  bool busy() const;
  /// Whether a dock is open in the main window.
  bool hasVisibleDocks() const;
  /// The largest area of the main window; null if all docks are closed or floating.
  ads::CDockAreaWidget* largestArea() const;

 protected:
  /// Detects that a dock is being dropped.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// On X a click on a floating window that a dialog blocks brings that window to the front; Qt gives the
  /// focus back to the dialog, without an event. So the dialog is raised when the focus moves. Handles no
  /// event.
  bool nativeEventFilter(const QByteArray& type, void* event, long* result) override;
  /// Closes a floating window; it is deleted later.
  void release(ads::CFloatingDockContainer* floating);

  /// Whether the library is processing the drop of a dock. Meanwhile it runs other events, such as shortcuts
  /// and timers.
  bool dropping_ = false;
};

}  // namespace app
