// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/PackageSubscription.h"
#include "widgets/picture/PictureView.h"
#include "widgets/world/ModelDrag.h"
#include "widgets/world/RobotBeliefs.h"
#include "widgets/world/SceneState.h"
#include "widgets/world/StreamFigures.h"
#include "widgets/world/Trails.h"

class QAction;
class QLabel;

namespace widgets {

class FieldCanvas;
class GoalTool;
class MeasureTool;
class RobotChoice;
class TrailMenu;
struct FieldFigures;

/// The field, or the map of a building, from above: the true poses of robots and ball, the robots' estimates
/// and drawings, and the paths of robots on wheels. Robots and ball of a simulation can be placed with the
/// mouse, robots on wheels sent to goals; distances and angles are measured. Follows the session's timeline.
///
/// Registered as "field". GUI thread.
class FieldView final : public PictureView {
  Q_OBJECT
 public:
  explicit FieldView(ViewContext& context, QWidget* parent = nullptr);
  ~FieldView() override;

  /// Shows the state of the world at the shown instant.
  void tick() override;
  /// The positions of everything: robots and ball, truly and as they are estimated, goals, paths, trails.
  std::optional<QString> numbers() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  /// Fit, rotation, trails and placing.
  void createActions();
  void createViews();
  /// Measuring in millimeters and degrees.
  void createMeasure();
  /// Choice of the robots, and buttons; `showDrawings` is the last.
  QWidget* createToolRow(QAction* showDrawings);
  /// Time, position of the cursor, and zoom.
  QWidget* createFooter();
  void connectSignals();
  /// Connects dragging of models with ModelDrag.
  void connectDrag();

  /// All robots with the sizes of those on wheels.
  std::vector<RobotBelief> beliefs() const;
  /// Whether a robot's description says that it has wheels.
  bool drives(const std::string& robot) const;
  /// Chooses map or field for the canvas.
  void updateGround();
  /// Passes paths and goals to the canvas.
  void updateGoals(const std::vector<RobotBelief>& beliefs);
  /// The figures that the canvas paints.
  FieldFigures figures(const std::vector<RobotBelief>& beliefs) const;
  /// Appends to the trails, or clears them if they are not shown.
  void updateTrails();
  /// Requests what lines to what is believed need, while they are shown.
  void updateErrors();
  /// The objects whose positions the trails show.
  Trails::Sources trailSources();
  /// Passes the dragged pose and its refusal to the canvas.
  void updateWanted();
  /// The data that the chosen robot needs for its localization; empty: none.
  QString noticeOf(const std::vector<RobotBelief>& beliefs) const;
  void showAge(const std::vector<RobotBelief>& beliefs, bool faded);
  void updateStatus();
  /// Turns the picture by 90 degrees.
  void turn();

  /// The true poses.
  SceneState scene_;
  StreamFigures streamFigures_;
  Trails trails_;
  /// The model that is being dragged.
  ModelDrag drag_;
  FieldCanvas* canvas_ = nullptr;
  GoalTool* goals_ = nullptr;
  MeasureTool* measure_ = nullptr;
  TrailMenu* trailMenu_ = nullptr;
  /// The last title that was emitted.
  QString title_;
  /// The last result of noticeOf().
  QString placeNotice_;
  /// Requests that the packages shown here are published.
  PackageSubscription subscription_;
  /// The same for trails of estimates, and for lines to what is believed.
  PackageSubscription trailSubscription_, errorSubscription_;
  RobotChoice* robots_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr, *cursor_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *turn_ = nullptr, *move_ = nullptr, *showTrails_ = nullptr, *showErrors_ = nullptr;
};

}  // namespace widgets
