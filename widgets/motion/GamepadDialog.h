// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QTableWidget;

namespace robotlink {
class CommandTable;
}

namespace widgets {

class GamepadSettings;

/// Lists all axes and buttons of gamepads with what they do: axes walk or turn, with a dead zone and a scale;
/// buttons run a command. What is changed counts at once, and is remembered. Object names: gamepadAxes,
/// gamepadButtons, gamepadReset, gamepadResult. GUI thread; settings and commands must outlive it.
class GamepadDialog final : public QDialog {
  Q_OBJECT
 public:
  GamepadDialog(GamepadSettings& settings, const robotlink::CommandTable& commands, QWidget* parent);

 private:
  void createWidgets();
  /// A row for each axis and each button.
  void fillAxes();
  void fillButtons();
  /// Uses what the dialog shows.
  void apply();
  /// Says why a command cannot be run; empty: it can.
  QString problemOf(const QString& command) const;
  void reset();

  GamepadSettings& settings_;
  const robotlink::CommandTable& commands_;
  QTableWidget *axes_ = nullptr, *buttons_ = nullptr;
  QLabel* result_ = nullptr;
  /// Whether the tables are being filled.
  bool isFilling_ = false;
};

}  // namespace widgets
