// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <string>
#include <vector>

namespace robotlink {
class Session;
}

namespace widgets {

/// Chooses whose drawings a view shows: the session's selected robot, all robots, or a certain one. A robot
/// that is chosen and not there stays chosen.
class RobotChoice final : public QComboBox {
  Q_OBJECT
 public:
  enum class Offer : std::uint8_t { kAll, kOne };
  /// `offer`: whether all of them at once can be chosen.
  explicit RobotChoice(const char* name, QWidget* parent = nullptr, Offer offer = Offer::kAll);

  /// Lists the session's robots; cheap while they are the same.
  void refresh(const robotlink::Session& session);
  std::vector<std::string> robots(const robotlink::Session& session) const;
  /// The one robot that a camera can follow: the chosen one, else the selected one.
  std::string robot(const robotlink::Session& session) const;

  /// For saved states: "" is the selected robot, "*" all of them.
  QString choice() const { return choice_; }
  void setChoice(const QString& choice);

 Q_SIGNALS:
  void choiceChanged();

 private:
  void list(const std::vector<std::string>& robots);

  Offer offer_;
  QString choice_;
  std::vector<std::string> listed_;
};

}  // namespace widgets
