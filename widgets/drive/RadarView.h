// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/PackageSubscription.h"
#include "widgets/View.h"

class QAction;
class QLabel;

namespace widgets {

class DrawingsModel;
class RadarCanvas;
class RobotChoice;
struct WorldDrawing;

/// The surroundings of a robot on wheels: sonars, laser, bumpers, stall, and what its program draws relative
/// to itself. Follows the session's timeline.
///
/// Registered as "radar". GUI thread.
class RadarView final : public View {
  Q_OBJECT
 public:
  explicit RadarView(ViewContext& context, QWidget* parent = nullptr);
  ~RadarView() override;

  /// Shows the readings and drawings at the shown instant.
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  /// Choice of the robot and buttons.
  QWidget* createToolRow();
  /// Time, nearest echoes, position of the cursor, and range.
  QWidget* createFooter();
  void connectSignals();
  /// The drawings in the robot's frame.
  std::vector<WorldDrawing> drawings(const std::string& robot) const;
  /// Heading of the robot on the map (rad): by its pose estimate if there is one, else the odometry's.
  double mapHeading(const std::string& robot, double odometry) const;
  /// Why nothing is shown and what to do; empty if there are readings (`told`).
  QString hint(const std::string& robot, bool reported) const;
  /// Updates the footer.
  void updateStatus();

  /// Requests that the packages shown here are published.
  PackageSubscription subscription_;
  DrawingsModel* drawings_ = nullptr;
  RadarCanvas* canvas_ = nullptr;
  RobotChoice* robots_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr, *nearest_ = nullptr, *cursor_ = nullptr, *range_ = nullptr;
  QAction *northUp_ = nullptr, *zoomIn_ = nullptr, *zoomOut_ = nullptr, *showDrawings_ = nullptr;
  QAction *copy_ = nullptr, *save_ = nullptr;
};

}  // namespace widgets
