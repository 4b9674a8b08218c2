// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "robotcontrol/Game.pb.h"

class QDoubleSpinBox;

namespace widgets {

/// Edits the transmission of messages in a team: range, delay and loss, each as a number. GUI thread.
class RadioPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit RadioPanel(QWidget* parent = nullptr);

  /// Shows the settings; what the user is changing is not moved.
  void showSettings(const robotcontrol::TeamRadioSettings& settings);

 Q_SIGNALS:
  /// The user wants these; what is unset stays.
  void wanted(const robotcontrol::TeamRadioSettings& settings);

 private:
  /// The numbers: m, ms, and %.
  std::array<QDoubleSpinBox*, 3> boxes_{};
};

}  // namespace widgets
