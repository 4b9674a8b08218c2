// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/PackageSubscription.h"
#include "widgets/picture/PictureView.h"

class QAction;
class QLabel;

namespace widgets {

class RadarCanvas;
class RobotChoice;
struct WorldDrawing;

/// The surroundings of a robot on wheels: sonars, laser, bumpers, stall, and what its program draws relative
/// to itself. Follows the session's timeline.
///
/// Registered as "radar". GUI thread.
class RadarView final : public PictureView {
  Q_OBJECT
 public:
  explicit RadarView(ViewContext& context, QWidget* parent = nullptr);
  ~RadarView() override;

  /// Shows the readings and drawings at the shown instant.
  void tick() override;
  /// A line for each newest echo of a sonar and each hit of the laser: what measured it, its number, its
  /// distance and its place in the robot's frame in m.
  std::optional<QString> numbers() override;

 private:
  void createViews();
  /// Time, nearest echoes, position of the cursor, and range.
  QWidget* createFooter();
  void connectSignals();
  /// The drawings in the robot's frame.
  std::vector<WorldDrawing> drawingsOf(const std::string& robot) const;
  /// Heading of the robot on the map (rad): by its pose estimate if there is one, else the odometry's.
  double mapHeading(const std::string& robot, double odometry) const;
  /// Says why nothing is shown and what to do; empty if there are readings (`told`).
  QString hint(const std::string& robot, bool hasContents) const;
  /// Updates the footer.
  void updateStatus();

  /// Requests that the packages shown here are published.
  PackageSubscription subscription_;
  RadarCanvas* canvas_ = nullptr;
  RobotChoice* robots_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr, *nearest_ = nullptr, *cursor_ = nullptr, *range_ = nullptr;
  QAction* northUp_ = nullptr;
};

}  // namespace widgets
