// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <string>
#include <vector>

namespace robotlink {
class Session;
}

namespace widgets {

/// Shows in a combo box how remote robots are connected: behind the names of those that are not, and in
/// the tooltips of all. The data of entries are names of robots; other entries stay as they are.
void showConnections(QComboBox& robots, const robotlink::Session& session);

/// A combo box that selects the robot whose data a view shows: the session's selected robot, all robots, or a
/// certain one. A robot that was chosen and is not in the session stays chosen and is listed as "not here".
/// GUI thread.
class RobotChoice final : public QComboBox {
  Q_OBJECT
 public:
  /// kAll: the list has the entry "All robots".
  /// kOne: it has not.
  enum class Offer : std::uint8_t { kAll, kOne };
  /// `name` is the object name.
  explicit RobotChoice(const char* name, QWidget* parent = nullptr, Offer offer = Offer::kAll);

  /// Lists the session's robots; returns early while they are unchanged.
  void refresh(const robotlink::Session& session);
  /// Names of the chosen robots; none if the selected robot is chosen and none is selected.
  std::vector<std::string> robots(const robotlink::Session& session) const;
  /// The one robot that a camera can follow: the chosen robot, or the selected one if all or none in
  /// particular is chosen.
  std::string robot(const robotlink::Session& session) const;

  /// The choice as saved in a view's state: "" for the selected robot, "*" for all robots, else a name.
  QString choice() const { return choice_; }
  void setChoice(const QString& choice);

 Q_SIGNALS:
  /// Emitted when the user or setChoice() chooses.
  void choiceChanged();

 private:
  /// Fills the combo box.
  void list(const std::vector<std::string>& robots);

  Offer offer_;
  /// See choice().
  QString choice_;
  /// The robots that the combo box lists.
  std::vector<std::string> listed_;
};

}  // namespace widgets
