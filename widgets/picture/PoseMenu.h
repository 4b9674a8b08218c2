// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QString>
#include <QStringList>

#include "widgets/PackageSubscription.h"

class QActionGroup;

namespace robotlink {
class Session;
}

namespace widgets {

/// Chooses the pose at which a view places the drawings relative to robots: the usual one, the true one, or a
/// pose estimate that a robot publishes (see DrawingPose.h). An estimate that was chosen and that no robot
/// publishes stays chosen and is listed. GUI thread.
class PoseMenu final : public QMenu {
  Q_OBJECT
 public:
  /// `name` is the object name; those of the entries are "pose", followed by their choices.
  PoseMenu(const QString& name, QWidget* parent);

  /// Lists the estimates that the session's robots publish, if its streams have changed, and requests the
  /// chosen one.
  void refresh(robotlink::Session& session);
  /// The choice as it is kept in the state of a view.
  QString choice() const { return choice_; }
  void setChoice(const QString& choice);
  /// All choices but the usual one.
  QStringList choices() const;

 Q_SIGNALS:
  /// The user or setChoice() has chosen.
  void choiceChanged();

 private:
  void choose(const QString& choice);
  /// Updates the list of estimates.
  void collect(robotlink::Session& session);
  /// Fills the menu.
  void list();
  void add(const QString& choice, const QString& text, const QString& toolTip);

  /// Paths of pose estimates without their robots, sorted.
  QStringList estimates_;
  QString choice_;
  QActionGroup* entries_ = nullptr;
  /// The store's version of its list of streams, as of the last refresh.
  quint64 listVersion_ = ~0ULL;
  PackageSubscription subscription_;
};

}  // namespace widgets
