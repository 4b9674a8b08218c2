// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace app {

class CommandActions;
class PresetActions;

/// The presets in the menu of the robot: each loads itself; the dialog saves, compares and removes them.
/// GUI thread; its arguments must outlive it.
class PresetMenu final : public QMenu {
  Q_OBJECT
 public:
  PresetMenu(CommandActions& actions, PresetActions& presets, QWidget* window);

 private:
  void fill();

  CommandActions& actions_;
  PresetActions& presets_;
};

}  // namespace app
