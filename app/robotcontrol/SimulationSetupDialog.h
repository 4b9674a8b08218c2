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

/// What is simulated: a scene or a map, how many robots are put into it, how they are moved, and whether
/// programs outside find them at ports. What it yields are the arguments of the command "simulation.setup".
/// What was chosen last is there again when it is opened the next time. GUI thread.
class SimulationSetupDialog final : public QDialog {
  Q_OBJECT
 public:
  using Arguments = std::vector<robotlink::CommandTable::Value>;

  /// `last`: arguments of the last time, or empty.
  explicit SimulationSetupDialog(const Arguments& last, QWidget* parent = nullptr);
  Arguments arguments() const;

  // To be kept from one start to the next. What cannot be read is left out.
  static QJsonArray toJson(const Arguments& arguments);
  static Arguments fromJson(const QJsonArray& array);

 private:
  void createWorld();
  void createRobots();
  void createPorts();
  void restore(const Arguments& last);
  void chooseFile();
  void followScene();
  void update();

  QComboBox* scene_ = nullptr;
  QComboBox* kind_ = nullptr;
  QSpinBox* robots_ = nullptr;
  QComboBox* teams_ = nullptr;
  QCheckBox* kinematic_ = nullptr;
  QCheckBox* ports_ = nullptr;
  QSpinBox* port_ = nullptr;
  QCheckBox* network_ = nullptr;
  QLabel* hint_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace app
