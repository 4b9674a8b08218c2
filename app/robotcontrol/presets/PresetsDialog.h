// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/session/Presets.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace app {

class PresetActions;

/// Lists the presets with what differs between the current one and what is chosen now; saves, loads, renames
/// and deletes them. GUI thread; the actions must outlive it.
class PresetsDialog final : public QDialog {
  Q_OBJECT
 public:
  PresetsDialog(PresetActions& presets, QWidget* parent);

 private:
  void createWidgets();
  void connectSignals();
  /// Lists the names and keeps the current one.
  void list();
  std::string current() const;
  /// Shows what differs from the current preset, once the robot has reported what it has.
  void compare();
  void showDifferences(const QString& text);
  std::vector<robotlink::Preset::Part> chosenParts() const;
  void report(const robotlink::Result<void>& done, const QString& text);

  PresetActions& presets_;
  QListWidget* list_ = nullptr;
  QPlainTextEdit* differences_ = nullptr;
  QLineEdit* name_ = nullptr;
  std::vector<QCheckBox*> parts_;
  QPushButton *save_ = nullptr, *load_ = nullptr, *rename_ = nullptr, *delete_ = nullptr;
  QLabel* state_ = nullptr;
  QTimer comparing_;
};

}  // namespace app
