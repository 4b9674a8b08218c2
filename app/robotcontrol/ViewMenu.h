// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace app {

class ViewDocks;

/// The menu of all views, in groups, each with a tick while it is open. Choosing a view that can be seen
/// closes it, any other one is brought to the front. Of kinds that may be open several times another one can
/// be opened. GUI thread; the docks must outlive it.
class ViewMenu : public QMenu {
  Q_OBJECT
 public:
  ViewMenu(ViewDocks& docks, QWidget* parent);

 private:
  void addView(const QString& id);
  void addAnother(QMenu& menu, const QString& id);
  void choose(const QString& id);
  void refresh();

  ViewDocks& docks_;
};

}  // namespace app
