// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QJsonArray>
#include <vector>

#include "robotlink/session/CommandTable.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QSpinBox;

namespace app {

/// A dialog that asks what to simulate: a scene or a map, how many robots are added to it, how they are
/// moved, and whether other programs can connect to them. It yields the arguments of the command
/// "simulation.setup"; the dialog opens with the last choices. GUI thread.
class SimulationSetupDialog final : public QDialog {
  Q_OBJECT
 public:
  /// The arguments of the command: scene, kind of robots, number of robots, kinematic, first port (0: none),
  /// open to the network, teams.
  using Arguments = std::vector<robotlink::CommandTable::Value>;

  /// `last`: the last arguments, or empty.
  explicit SimulationSetupDialog(const Arguments& last, QWidget* parent = nullptr);
  /// The chosen arguments, in the order of the command's parameters.
  Arguments arguments() const;

  // Conversion for the settings file. Unreadable elements are skipped.
  static QJsonArray toJson(const Arguments& arguments);
  static Arguments fromJson(const QJsonArray& array);

 private:
  /// The create functions are called once, by the constructor.
  void createWorld();
  void createRobots();
  void createPorts();
  /// Sets the widgets to arguments; ignores those that are missing.
  void restore(const Arguments& last);
  /// Asks for a scene file.
  void chooseFile();
  /// Adapts the choices to the kind of scene.
  void followScene();
  /// Enables widgets, shows hints, and checks whether the dialog can be accepted.
  void update();

  /// A shipped scene or a file, and the robots to add.
  QComboBox* scene_ = nullptr;
  QComboBox* kind_ = nullptr;
  QSpinBox* robots_ = nullptr;
  QComboBox* teams_ = nullptr;
  QCheckBox* kinematic_ = nullptr;
  /// Whether robots get ports, the first one, and whether other computers may connect.
  QCheckBox* ports_ = nullptr;
  QSpinBox* port_ = nullptr;
  QCheckBox* network_ = nullptr;
  /// Says what the choices mean where that is not obvious.
  QLabel* hint_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace app
