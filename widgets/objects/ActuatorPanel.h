// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "widgets/ports/PortSubscription.h"

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QSlider;

namespace robotcontrol {
class Request;
class WorldObject;
}  // namespace robotcontrol
namespace robotlink {
class Session;
}

namespace widgets {

class SceneTreeModel;

/// Sliders of actuators of a simulation, with their ranges and units: what is set is held, whatever the
/// robot's program asks for, until it is released. An actuator with several values has one slider for each.
/// Hidden while it shows none. Object names: "actuator-PATH-NUMBER" (slider), "actuatorValue-PATH-NUMBER"
/// (field), "actuatorsRelease". GUI thread.
class ActuatorPanel final : public QWidget {
  Q_OBJECT
 public:
  /// The maximum number of actuators shown.
  static constexpr std::size_t kMax = 40;

  /// Both must outlive it.
  ActuatorPanel(robotlink::Session& session, const SceneTreeModel& model, QWidget* parent);
  ~ActuatorPanel() override;

  /// Shows the actuators of these paths.
  void show(std::vector<std::string> actuators);
  /// Shows what is held now; sliders that the user moves stay as they are.
  void refresh();
  /// Releases everything that is shown.
  void release();

 private:
  /// The controls of one value of an actuator.
  struct Row {
    std::string port, robot;
    int value = 0;
    double minimum = 0, maximum = 1;
    QSlider* slider = nullptr;
    QDoubleSpinBox* field = nullptr;
    /// Shown if the actuator is blocked; only in the first row of one.
    QLabel* blocked = nullptr;
  };
  void addActuator(const robotcontrol::WorldObject& object);
  void addRow(const robotcontrol::WorldObject& object, int value, int values);
  /// Whether what an actuator moves has met an obstacle since its last command.
  bool isBlocked(const std::string& port) const;
  /// Holds an actuator at what its sliders say.
  void hold(const std::string& port);
  void send(const std::string& robot, robotcontrol::Request request);
  /// The present measurement of the sensor of an actuator, such as the angle of the joint; 0: not known.
  double present(const Row& row) const;
  static int stepOf(const Row& row, double value);

  robotlink::Session& session_;
  const SceneTreeModel& model_;
  /// Asks for what becomes of the commands of what is shown.
  PortSubscription subscription_;
  std::vector<std::string> shown_;
  std::vector<Row> rows_;
  QScrollArea* area_ = nullptr;
  QWidget* contents_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QPushButton* release_ = nullptr;
  QLabel* outcome_ = nullptr;
  /// Whether controls are being set here and not by the user.
  bool isRefreshing_ = false;
};

}  // namespace widgets
