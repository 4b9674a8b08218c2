// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <string>

namespace robotlink {
class Session;
}

namespace widgets {

/// A combo box that selects a stream of one message type by its path: a certain one, or with "*" in place of
/// the robot that of the session's selected robot. A stream that was chosen and does not exist (yet) stays
/// chosen. While the initial choice, which nobody chose, does not exist, the first stream there is stands for
/// it: one of the selected robot, else one of no robot, as in logs of other programs. For a stream of a robot
/// that is no longer there, as after another scene was opened, the same of the selected robot is used, or
/// its first one, until that robot is back. GUI thread.
class StreamSelector final : public QComboBox {
  Q_OBJECT
 public:
  /// `type`: full name of the message type. `choice`: the initial choice.
  StreamSelector(std::string type, QString choice, QWidget* parent = nullptr);

  /// Lists the session's streams; returns early while they are unchanged. True if the list, and so perhaps
  /// path(), changed.
  bool refresh(robotlink::Session& session);
  /// Path of the chosen stream, or of the one that stands for it, with the selected robot's name in place of
  /// "*".
  std::string path(const robotlink::Session& session) const;

  /// The choice as saved in a view's state: "red1/camera/image" or "*/camera/image".
  const QString& choice() const { return choice_; }
  void setChoice(const QString& choice);

 Q_SIGNALS:
  /// Emitted when the user or setChoice() chooses.
  void choiceChanged();

 private:
  /// Whether the choice is a stream of something that the session does not have, such as a robot of another
  /// scene.
  bool isOfOthers(robotlink::Session& session) const;
  /// The choice that stands in for the one that does not exist; empty: none.
  QString substitute(const QStringList& ofSelected, const QStringList& paths,
                     robotlink::Session& session) const;

  /// Full name of the message type.
  std::string type_;
  const QString initial_;
  QString choice_;
  /// The last result of substitute().
  QString shown_;
  /// The store's list of streams and the selected robot that the combo box shows.
  quint64 listVersion_ = ~0ULL;
  std::string listedRobot_;
};

}  // namespace widgets
