// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/PackageWish.h"
#include "widgets/View.h"
#include "widgets/models/ModelDrag.h"
#include "widgets/models/RobotBeliefs.h"
#include "widgets/models/SceneState.h"
#include "widgets/models/Trails.h"

class QAction;
class QLabel;
class QSplitter;

namespace widgets {

class DrawingsModel;
class FieldCanvas;
class GoalTool;
class RobotChoice;
struct FieldFigures;

/// The field, or the map of a building, from above: where robots and ball are, where the robots believe that
/// they are, what they draw, and where robots on wheels are going. Robots and ball of a simulation can be
/// placed with the mouse, robots on wheels sent to places. Follows the session's time line.
class FieldView final : public View {
  Q_OBJECT
 public:
  explicit FieldView(ViewContext& context, QWidget* parent = nullptr);
  ~FieldView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

  /// Writes what is seen as PNG. False, with a message shown, if that fails.
  bool savePicture(const QString& file);

 private:
  void createActions();
  void createViews();
  QWidget* createToolRow();
  QWidget* createFooter();
  void connectSignals();
  void connectDrag();

  std::vector<RobotBelief> beliefs() const;
  bool drives(const std::string& robot) const;
  void updateGround();
  void updateGoals(const std::vector<RobotBelief>& beliefs);
  FieldFigures figures(const std::vector<RobotBelief>& beliefs) const;
  void updateTrails();
  void updateWanted();
  /// What the robot that is chosen needs to find out where it is; empty: nothing.
  QString noticeOf(const std::vector<RobotBelief>& beliefs) const;
  void showAge(const std::vector<RobotBelief>& beliefs, bool faded);
  void updateStatus();
  void turn();

  SceneState scene_;
  Trails trails_;
  ModelDrag drag_;
  DrawingsModel* drawings_ = nullptr;
  FieldCanvas* canvas_ = nullptr;
  GoalTool* goals_ = nullptr;
  QString title_;  // as it was told last
  QString placeNotice_;
  PackageWish wish_;
  RobotChoice* robots_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr, *cursor_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *zoomIn_ = nullptr, *zoomOut_ = nullptr, *turn_ = nullptr;
  QAction *move_ = nullptr, *showTrails_ = nullptr, *showDrawings_ = nullptr;
  QAction *copy_ = nullptr, *save_ = nullptr;
};

}  // namespace widgets
