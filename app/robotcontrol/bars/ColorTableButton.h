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

/// Shows which color table the selected robot's program uses and where the table is from. Its menu loads
/// another one. GUI thread.
class ColorTableButton final : public QToolButton {
  Q_OBJECT
 public:
  explicit ColorTableButton(QWidget* parent);

  /// Shows the table that the selected robot reports; called after each tick. Returns false if its program
  /// uses none or has not reported one.
  bool refresh(robotlink::Session& session);

  QSize sizeHint() const override;

  /// Returns "game.c64" for the source "/home/me/game.c64"; other sources as they are.
  static QString shortName(const QString& source);

 private:
  /// Updates text and tooltip if the table has changed.
  void show(const robotcontrol::ColorTable& table);

  /// Source and time of the table that is shown.
  QString shown_;
};

}  // namespace app
