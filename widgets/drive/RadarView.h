// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/PackageWish.h"
#include "widgets/View.h"

class QAction;
class QLabel;

namespace widgets {

class DrawingsModel;
class RadarCanvas;
class RobotChoice;
struct WorldDrawing;

/// What is around a robot on wheels: sonars, laser, bumpers, stall, and what its program draws relative to
/// itself. Follows the session's time line.
class RadarView final : public View {
  Q_OBJECT
 public:
  explicit RadarView(ViewContext& context, QWidget* parent = nullptr);
  ~RadarView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  QWidget* createToolRow();
  QWidget* createFooter();
  void connectSignals();
  std::vector<WorldDrawing> drawings(const std::string& robot) const;
  double mapHeading(const std::string& robot, double odometry) const;
  QString hint(const std::string& robot, bool told) const;
  void updateStatus();

  PackageWish wish_;
  DrawingsModel* drawings_ = nullptr;
  RadarCanvas* canvas_ = nullptr;
  RobotChoice* robots_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr, *nearest_ = nullptr, *cursor_ = nullptr, *range_ = nullptr;
  QAction *northUp_ = nullptr, *zoomIn_ = nullptr, *zoomOut_ = nullptr, *showDrawings_ = nullptr;
  QAction *copy_ = nullptr, *save_ = nullptr;
};

}  // namespace widgets
