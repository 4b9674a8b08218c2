// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace robotcontrol {
class ColorTable;
}
namespace robotlink {
class Session;
}

namespace app {

/// Says which color table the selected robot's program uses, and where that one is from; its menu loads
/// another one. GUI thread.
class ColorTableButton final : public QToolButton {
  Q_OBJECT
 public:
  explicit ColorTableButton(QWidget* parent);

  /// Shows what the selected robot says; called after each tick. False: its program uses none, or has not
  /// said so yet.
  bool refresh(robotlink::Session& session);

  QSize sizeHint() const override;

  /// "game.c64" of "/home/me/game.c64", and other sources as they are.
  static QString shortName(const QString& source);

 private:
  void show(const robotcontrol::ColorTable& table);

  QString shown_;  ///< source and time of what the text and the tool tip are of
};

}  // namespace app
