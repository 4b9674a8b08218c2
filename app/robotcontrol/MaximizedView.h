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

/// Lets one view of a window have all the room, and gives it back. The docks stay as they are: all others are
/// merely hidden, so that restore() has to be called before their state is saved. GUI thread; the manager
/// must outlive it.
class MaximizedView final : public QObject {
  Q_OBJECT
 public:
  MaximizedView(ads::CDockManager& manager, QObject* parent);

  /// The view with the focus, else the one under the mouse, else the first one; a second time: all as it was.
  /// A view in a window of its own gets the screen.
  void toggle();
  void restore();
  bool active() const { return !hidden_.empty(); }

 private:
  ads::CDockWidget* wanted() const;
  void maximize(QWidget& area);

  ads::CDockManager& manager_;
  std::vector<QPointer<QWidget>> hidden_;
  std::vector<std::pair<QPointer<QSplitter>, QList<int>>>
      sizes_;  ///< of the splitters around it, as they were
};

}  // namespace app
