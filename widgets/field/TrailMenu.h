// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QMenu>

#include "robotlink/base/Clock.h"

class QAction;
class QActionGroup;

namespace widgets {

/// The menu that chooses the length of trails on the field, and the robots and the ball that have them.
/// Object name "fieldTrailMenu"; the entries for lengths are "trailSeconds0" (as long as it fits the ground)
/// to "trailSeconds60". GUI thread.
class TrailMenu final : public QMenu {
  Q_OBJECT
 public:
  explicit TrailMenu(QWidget* parent);

  /// The length of the trails; `onMap`: on a map, which is crossed in minutes rather than in seconds.
  robotlink::Duration reach(bool onMap) const;
  /// Whether there are trails of true poses, of pose estimates, and of the ball (true, or else estimated).
  bool showsRobots() const;
  bool showsEstimates() const;
  bool showsBall() const;

  /// The choices, as they are kept in the state of a view; restore() ignores what it does not know.
  QJsonValue save() const;
  void restore(const QJsonValue& state);

 Q_SIGNALS:
  /// The user or restore() has chosen.
  void changed();

 private:
  void addLengths();
  QAction* addChoice(const char* name, const QString& text, const QString& toolTip, bool on);

  QActionGroup* lengths_ = nullptr;
  QAction *robots_ = nullptr, *estimates_ = nullptr, *ball_ = nullptr;
};

}  // namespace widgets
