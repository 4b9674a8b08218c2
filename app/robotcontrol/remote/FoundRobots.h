// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/core/remote/RobotSearch.h"

class QTreeWidget;
namespace widgets {
class EmptyHint;
}

namespace app {

/// Returns an age as a text for users: "12 s", "3 min", "2 h".
QString ageText(robotlink::Duration age);

/// Lists the robots that announce themselves on the networks of this computer: their names, kinds, what they
/// run, where they are, and since when they have been heard. Says why there are none. GUI thread.
class FoundRobots final : public QWidget {
  Q_OBJECT
 public:
  using Announced = robotlink::dds::AnnouncedRobots;

  explicit FoundRobots(QWidget* parent = nullptr);

  /// Shows the results of the search; those for which `isOwn` holds are left out.
  void show(const RobotSearch::State& state, const std::function<bool(const Announced&)>& isOwn);
  /// The selected one; nothing if none is.
  std::optional<Announced> selected() const;

 Q_SIGNALS:
  /// The user has selected one, by a click or a key.
  void picked(const robotlink::dds::AnnouncedRobots& robots);
  /// The user has double-clicked one, or pressed Enter.
  void wanted(const robotlink::dds::AnnouncedRobots& robots);

 protected:
  /// Enter in the list.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showRow(int row, const RobotSearch::Found& found);
  void showHint(const RobotSearch::State& state);
  const Announced* at(int row) const;

  QTreeWidget* tree_ = nullptr;
  widgets::EmptyHint* hint_ = nullptr;
  bool isShowing_ = false;
  /// In the order of the rows.
  std::vector<Announced> shown_;
};

}  // namespace app
