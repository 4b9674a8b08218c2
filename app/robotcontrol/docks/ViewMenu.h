// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace app {

class ViewDocks;

/// The menu of all views, in groups, with a check mark for those that are open. Choosing a visible view
/// closes it; any other is brought to the front. Kinds that may be open several times have an entry for
/// another one. GUI thread; the docks must outlive it.
class ViewMenu : public QMenu {
  Q_OBJECT
 public:
  ViewMenu(ViewDocks& docks, QWidget* parent);

 private:
  void addView(const QString& id);
  void addAnother(QMenu& menu, const QString& id);
  /// Closes a view that is in front, or brings it there.
  void choose(const QString& id);
  /// Updates the check marks, before the menu is shown.
  void refresh();

  ViewDocks& docks_;
};

}  // namespace app
