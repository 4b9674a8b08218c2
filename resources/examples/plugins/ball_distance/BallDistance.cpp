// SPDX-License-Identifier: GPL-3.0-or-later
// A view with the distance of the ball as large digits, a toolbar that opens it, and a command that logs it.
#include <QLabel>
#include <QToolBar>
#include <QVBoxLayout>
#include <optional>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/base/Plugin.h"
#include "robotlink/commands/CommandRegistration.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/PackageSubscription.h"
#include "widgets/ToolBarRegistration.h"
#include "widgets/View.h"

namespace {

/// At the instant that all views show; nothing if the selected robot knows no ball.
std::optional<double> ballDistance(robotlink::Session& session) {
  const std::string path = session.selectedRobot() + "/" + robotlink::kBallModel.name;
  const auto* ball = session.store().latestAs<robotcontrol::BallModel>(path, session.timeline().shown());
  if (ball == nullptr || !ball->known()) return std::nullopt;
  return robotlink::vector2(ball->position_in_robot()).norm();
}

class BallDistanceView final : public widgets::View {
 public:
  explicit BallDistanceView(widgets::ViewContext& context, QWidget* parent)
      : View(context, parent), text_(new QLabel(this)) {
    text_->setObjectName(QStringLiteral("ballDistance"));
    text_->setAccessibleName(QStringLiteral("Distance of the ball"));
    text_->setAlignment(Qt::AlignCenter);
    QFont font = text_->font();
    font.setPointSizeF(3 * font.pointSizeF());
    text_->setFont(font);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text_);
  }

  void tick() override {
    subscription_.want(session(), session().selectedRobot(), {robotlink::kBallModel.name});
    const auto distance = ballDistance(session());
    text_->setText(distance ? QStringLiteral("%1 m").arg(*distance, 0, 'f', 2) : QStringLiteral("no ball"));
  }

 private:
  QLabel* text_;
  /// Has the robot publish its model of the ball.
  widgets::PackageSubscription subscription_;
};

QToolBar* createToolBar(widgets::ViewContext& context, QWidget* parent) {
  auto* bar = new QToolBar(parent);
  bar->addAction(QStringLiteral("Ball distance"), parent,
                 [&context] { (void)context.commands.runLine("view.show ball-distance"); });
  return bar;
}

robotlink::Result<void> requireNearBall(robotlink::Session& session,
                                        const robotlink::CommandTable::Values& values) {
  const auto distance = ballDistance(session);
  const double limit = std::get<double>(values[0]);
  if (!distance) return robotlink::failure("ball.unknown", "the robot knows no ball");
  if (*distance <= limit) return {};
  return robotlink::failure("ball.far", "the ball is " + std::to_string(*distance) + " m away");
}

}  // namespace

ROBOTCONTROL_PLUGIN("ball-distance", "1.0", "Adds a view and a command for the distance of the ball.") {
  widgets::ViewRegistration({"ball-distance", "Ball distance",
                             "Shows the distance of the ball as the robot believes it.", "field", true,
                             widgets::create<BallDistanceView>});
  widgets::ToolBarRegistration({"ball-distance", "Ball distance", createToolBar});
  robotlink::CommandRegistration({{"ball.require-near",
                                   "Fails if the ball is farther away than this",
                                   {{"distance", robotlink::CommandTable::Type::kNumber, "m"}}},
                                  requireNearBall});
}
