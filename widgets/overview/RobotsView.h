// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/data/ImageThumbnails.h"
#include "widgets/overview/GlanceSubscription.h"
#include "widgets/overview/RobotCardModel.h"

class QListView;

namespace widgets {

class EmptyHint;
class RobotCardDelegate;

/// All robots of the session at a glance, simulated, real, remote and logged: a card for each with its image,
/// state, battery and link. A click, or the arrow keys, select the robot that all other views show.
///
/// While the view is visible, robots publish what it shows twice a second, if nobody wants it more often.
/// Registered as "robots". GUI thread.
class RobotsView final : public View {
  Q_OBJECT
 public:
  explicit RobotsView(ViewContext& context, QWidget* parent = nullptr);
  ~RobotsView() override;
  void tick() override;
  /// The texts of the cards, a row for each robot.
  std::optional<QString> numbers() override;

 protected:
  /// Ends subscriptions while the view is hidden.
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// The newest image of a robot, or why there is none.
  void addImage(RobotCard& card);
  /// Gives all cards the size that fits.
  void fit();
  /// Makes the card of the selected robot the current one.
  void followSelection();

  RobotCardModel model_;
  RobotCardDelegate* delegate_;
  QListView* list_ = nullptr;
  EmptyHint* hint_ = nullptr;
  ImageThumbnails thumbnails_;
  GlanceSubscription subscription_;
  /// The current card is being changed here and not by the user.
  bool isFollowing_ = false;
};

}  // namespace widgets
