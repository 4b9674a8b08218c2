// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <string>

namespace robotlink {
class Session;
}

namespace widgets {

/// Chooses a stream of a session by its path, of one type: a certain one, or with "*" for the robot the same
/// of the session's selected robot. A stream that is chosen and not there (yet) stays chosen.
class StreamChoice final : public QComboBox {
  Q_OBJECT
 public:
  /// `type`: full name of the messages' type. `choice`: at first.
  StreamChoice(std::string type, QString choice, QWidget* parent = nullptr);

  /// Lists what there is; cheap while it is the same. Whether the list, and so perhaps path(), changed.
  bool refresh(robotlink::Session& session);
  /// The path of the chosen stream, the selected robot's name in place of "*".
  std::string path(const robotlink::Session& session) const;

  /// For saved states: "red1/camera/image" or "*/camera/image".
  const QString& choice() const { return choice_; }
  void setChoice(const QString& choice);

 Q_SIGNALS:
  void choiceChanged();

 private:
  std::string type_;
  QString choice_;
  quint64 listVersion_ = ~0ULL;
  std::string listedRobot_;
};

}  // namespace widgets
