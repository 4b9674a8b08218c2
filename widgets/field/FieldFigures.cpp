// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/FieldFigures.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"
#include "widgets/field/FieldViewport.h"
#include "widgets/world/SceneState.h"

namespace widgets {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

// Approximate size of a robot with legs from above, whose description has none.
constexpr double kLength = 0.27, kWidth = 0.15;  // m

constexpr double kSmallest =
    // Pixels; robots are not drawn shorter than this, so that they are visible on large maps.
    14;

/// A robot on wheels from above in its own frame: a body with cut corners and a wedge at its front, between
/// four wheels.
QPainterPath wheeledOutline(const Vector2& body) {
  const double x = body.x() / 2, y = body.y() / 2, cut = 0.35 * y, wheel = 0.16 * y;
  QPainterPath path;
  path.addPolygon(QPolygonF({{x - cut, y - wheel},
                             {x, y - wheel - cut},
                             {x, -y + wheel + cut},
                             {x - cut, -y + wheel},
                             {-x + cut, -y + wheel},
                             {-x, -y + wheel + cut},
                             {-x, y - wheel - cut},
                             {-x + cut, y - wheel}}));
  path.closeSubpath();
  QPainterPath wheels;
  for (const double side : {-1.0, 1.0}) {
    for (const double end : {-1.0, 1.0})
      wheels.addRoundedRect(
          QRectF(end * 0.45 * x - 0.34 * x, side * (y - wheel) - wheel, 0.68 * x, 2 * wheel), wheel / 2,
          wheel / 2);
  }
  QPainterPath nose;
  nose.addPolygon(QPolygonF({{0.85 * x, 0}, {0.2 * x, 0.4 * y}, {0.2 * x, -0.4 * y}}));
  nose.closeSubpath();
  return path.united(wheels).subtracted(nose);
}

/// A four-legged robot from above in its own frame, with the head as a nose.
QPainterPath bodyOutline(const Vector2& body) {
  if (body.x() > 0) return wheeledOutline(body);
  QPainterPath path;
  path.addRoundedRect(QRectF(-0.6 * kLength, -kWidth / 2, 0.8 * kLength, kWidth), 0.03, 0.03);
  QPainterPath head;
  head.addRoundedRect(QRectF(0.12 * kLength, -0.3 * kWidth, 0.36 * kLength, 0.6 * kWidth), 0.035, 0.035);
  return path.united(head);
}

double lengthOf(const Vector2& body) {
  return body.x() > 0 ? body.x() : kLength;
}

QPointF map(const QTransform& transform, const Vector2& point) {
  return transform.map(QPointF(point.x(), point.y()));
}

QPainterPath outlineAt(const Pose2& pose, const Vector2& body, const QTransform& fieldToWidget) {
  QTransform transform = fieldToWidget;
  transform.translate(pose.x, pose.y);
  transform.rotate(robotlink::degrees(pose.heading));
  const double enlarged = std::max(1.0, kSmallest / (lengthOf(body) * scaleOf(fieldToWidget)));
  transform.scale(enlarged, enlarged);
  return transform.map(bodyOutline(body));
}

/// The color of estimates: on the green field a lighter tone of the team's color, on a map a tone that
/// differs from its ground.
QColor estimateColor(const FieldFigures& figures, const QColor& team, const QPalette& palette) {
  if (figures.onMap && !isDark(palette)) return mixed(team, Qt::black, 0.25);
  return mixed(team, Qt::white, 0.45);
}

QPen dashed(const QColor& color) {
  QPen pen(color, 2, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({3, 2});
  return pen;
}

void paintTrue(QPainter& painter, const FieldFigures& figures, const RobotBelief& belief,
               const QTransform& toWidget, const QPalette& palette) {
  const bool highlighted = belief.robot == figures.highlighted;
  const QPainterPath outline = outlineAt(*belief.truth, belief.body, toWidget);
  if (belief.selected || highlighted) {
    QColor halo = figures.onMap ? palette.color(QPalette::Highlight) : QColor(Qt::white);
    halo.setAlpha(highlighted ? 255 : 170);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(halo, highlighted ? 6 : 4));
    painter.drawPath(outline);
  }
  painter.setPen(QPen(belief.team.darker(180), 1.2));
  painter.setBrush(belief.team);
  painter.drawPath(outline);
}

void paintEstimate(QPainter& painter, const FieldFigures& figures, const RobotBelief& belief,
                   const QTransform& toWidget, const QPalette& palette) {
  const QColor color =
      belief.silent ? colorOf(Meaning::kMuted, palette) : estimateColor(figures, belief.team, palette);
  const double radius = belief.positionDeviation * scaleOf(toWidget);
  const QPointF at = map(toWidget, belief.estimate->translation());
  if (radius > 1) {
    QColor area = color;
    // The large deviation of a robot that is not localized must not hide the building.
    area.setAlphaF(figures.onMap ? 0.1 : 0.22);
    painter.setPen(QPen(color, 1));
    painter.setBrush(area);
    painter.drawEllipse(at, radius, radius);
  }
  painter.setPen(dashed(color));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outlineAt(*belief.estimate, belief.body, toWidget));
  painter.setPen(QPen(color, 2));
  const double ahead = std::max(0.6 * lengthOf(belief.body), 0.8 * kSmallest / scaleOf(toWidget));
  painter.drawLine(at, map(toWidget, *belief.estimate * Vector2(ahead, 0)));
}

/// A text on a dark box around a place of the widget.
void paintLabel(QPainter& painter, const QPointF& at, const QString& text, bool isBold) {
  QFont font = painter.font();
  font.setPixelSize(11);
  font.setBold(isBold);
  painter.setFont(font);
  QRectF box = QFontMetricsF(font).boundingRect(text).adjusted(-4, -1, 4, 1);
  box.moveCenter(at);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 130));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(Qt::white);
  painter.drawText(box, Qt::AlignCenter, text);
}

void paintName(QPainter& painter, const RobotBelief& belief, const QTransform& toWidget) {
  const auto pose = belief.pose();
  if (!pose) return;
  const QPointF below =
      map(toWidget, pose->translation()) +
      QPointF(0, std::max(0.63 * lengthOf(belief.body) * scaleOf(toWidget), 0.6 * kSmallest) + 12);
  paintLabel(painter, below, QString::fromStdString(belief.robot), belief.selected);
}

/// A line from where something is to where it is believed, with the distance.
void paintError(QPainter& painter, const FieldFigures& figures, const Vector2& truth, const Vector2& believed,
                const QTransform& toWidget, const QPalette& palette) {
  const QLineF line(map(toWidget, truth), map(toWidget, believed));
  painter.setPen(QPen(figures.onMap ? palette.color(QPalette::Text) : QColor(Qt::white), 1.5));
  painter.drawLine(line);
  paintLabel(painter, line.center(),
             QObject::tr("%1 mm", "error on the field").arg(1000 * (believed - truth).norm(), 0, 'f', 0),
             false);
}

void paintErrors(QPainter& painter, const FieldFigures& figures, const QTransform& toWidget,
                 const QPalette& palette) {
  for (const RobotBelief& belief : figures.robots) {
    if (belief.truth && belief.estimate)
      paintError(painter, figures, belief.truth->translation(), belief.estimate->translation(), toWidget,
                 palette);
    if (figures.ball && belief.ball)
      paintError(painter, figures, *figures.ball, *belief.ball, toWidget, palette);
  }
}

void paintBallEstimate(QPainter& painter, const FieldFigures& figures, const RobotBelief& belief,
                       const QTransform& toWidget, const QPalette& palette) {
  const QPointF at = map(toWidget, *belief.ball);
  const double scale = scaleOf(toWidget), radius = std::max(3.0, figures.ballRadius * scale);
  if (belief.ballDeviation * scale > radius) {
    QColor area = figures.ballColor;
    area.setAlphaF(0.18);
    painter.setPen(QPen(figures.ballColor, 1));
    painter.setBrush(area);
    painter.drawEllipse(at, belief.ballDeviation * scale, belief.ballDeviation * scale);
  }
  // A thin line connects the estimated ball with the estimate of its robot.
  if (belief.estimate) {
    QColor line = estimateColor(figures, belief.team, palette);
    line.setAlphaF(0.6);
    painter.setPen(QPen(line, 1, Qt::DotLine));
    painter.drawLine(map(toWidget, belief.estimate->translation()), at);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(dashed(mixed(figures.ballColor, Qt::white, 0.35)));
  painter.drawEllipse(at, radius + 1.5, radius + 1.5);
}

void paintBall(QPainter& painter, const FieldFigures& figures, const QTransform& toWidget) {
  if (!figures.ball) return;
  const double radius = std::max(3.0, figures.ballRadius * scaleOf(toWidget));
  const bool highlighted = figures.highlighted == kBallModel;
  painter.setPen(highlighted ? QPen(Qt::white, 3) : QPen(figures.ballColor.darker(160), 1.2));
  painter.setBrush(figures.ballColor);
  painter.drawEllipse(map(toWidget, *figures.ball), radius, radius);
}

/// The subject of a trail: "red1", its estimated pose "red1/estimate", the ball, or where "red1/ball" was
/// believed.
struct TrailKind {
  QColor color;
  bool isEstimate = false;
};

TrailKind trailKind(const FieldFigures& figures, const std::string& model, const QPalette& palette) {
  const std::string robot = model.substr(0, model.find('/'));
  const bool isEstimate = robot.size() < model.size();
  if (isEstimate && model.ends_with(kBallTrail)) return {mixed(figures.ballColor, Qt::white, 0.35), true};
  for (const RobotBelief& belief : figures.robots) {
    if (belief.robot != robot) continue;
    if (isEstimate) return {estimateColor(figures, belief.team, palette), true};
    // The robot's color, lighter on the green field.
    return {mixed(belief.team, Qt::white, figures.onMap ? 0 : 0.25)};
  }
  return {mixed(figures.ballColor, Qt::white, figures.onMap ? 0 : 0.25)};
}

void paintTrails(QPainter& painter, const FieldFigures& figures, const QTransform& toWidget,
                 const QPalette& palette) {
  for (const auto& [model, places] : figures.trails) {
    auto [color, isEstimate] = trailKind(figures, model, palette);
    // Trails fade with age.
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (isEstimate && i % 3 == 0) continue;  // dashed, as estimates are
      color.setAlphaF(0.3 + 0.6 * static_cast<double>(i) / static_cast<double>(places.size()));
      painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(map(toWidget, places[i - 1]), map(toWidget, places[i]));
    }
  }
}

/// Whether a place is within the figure of a robot at a pose.
bool covers(const Pose2& pose, const Vector2& body, const Vector2& place, double tolerance) {
  const Vector2 inRobot = pose.inverse() * place;
  const bool wheels = body.x() > 0;
  const double x = wheels ? body.x() / 2 : 0.56 * kLength, y = wheels ? body.y() / 2 : kWidth / 2;
  return std::abs(inRobot.x() + (wheels ? 0 : 0.06 * kLength)) < x + tolerance &&
         std::abs(inRobot.y()) < y + tolerance;
}

}  // namespace

void paintFigures(QPainter& painter, const FieldFigures& figures, const QTransform& toWidget,
                  const QPalette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  paintTrails(painter, figures, toWidget, palette);
  for (const RobotBelief& belief : figures.robots) {
    if (belief.truth) paintTrue(painter, figures, belief, toWidget, palette);
  }
  paintBall(painter, figures, toWidget);
  for (const RobotBelief& belief : figures.robots) {
    if (belief.estimate) paintEstimate(painter, figures, belief, toWidget, palette);
    if (belief.ball) paintBallEstimate(painter, figures, belief, toWidget, palette);
  }
  for (const RobotBelief& belief : figures.robots) paintName(painter, belief, toWidget);
  if (figures.errorLines) paintErrors(painter, figures, toWidget, palette);
  painter.restore();
}

void paintWanted(QPainter& painter, const WantedPlace& place, const FieldFigures& figures,
                 const QTransform& toWidget, const QPalette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor free = figures.onMap ? palette.color(QPalette::Text) : QColor(Qt::white);
  const QColor color = place.refused ? colorOf(Meaning::kBad, palette) : free;
  painter.setPen(QPen(color, 2));
  QColor area = color;
  area.setAlphaF(0.25);
  painter.setBrush(area);
  const QPointF at = map(toWidget, place.pose.translation());
  if (place.isBall) {
    const double radius = std::max(4.0, figures.ballRadius * scaleOf(toWidget));
    painter.drawEllipse(at, radius, radius);
  } else {
    const auto belief = std::find_if(figures.robots.begin(), figures.robots.end(),
                                     [&](const RobotBelief& robot) { return robot.robot == place.model; });
    painter.drawPath(
        outlineAt(place.pose, belief == figures.robots.end() ? Vector2(0, 0) : belief->body, toWidget));
  }
  painter.drawLine(at - QPointF(9, 0), at + QPointF(9, 0));
  painter.drawLine(at - QPointF(0, 9), at + QPointF(0, 9));
  painter.restore();
}

void paintLegend(QPainter& painter, const QSizeF& widget, const QPalette&) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPixelSize(11);
  painter.setFont(font);
  const QString texts[] = {QObject::tr("true", "legend of the field"),
                           QObject::tr("estimated", "legend of the field")};
  const QFontMetricsF metrics(font);
  const double width = metrics.horizontalAdvance(texts[0]) + metrics.horizontalAdvance(texts[1]) + 72;
  const QRectF box(6, widget.height() - 26, width, 20);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 140));
  painter.drawRoundedRect(box, 4, 4);
  double x = box.left() + 8;
  for (int i = 0; i < 2; ++i) {
    const QRectF swatch(x, box.center().y() - 5, 16, 10);
    painter.setPen(i == 0 ? QPen(QColor(220, 220, 220), 1) : dashed(QColor(240, 240, 240)));
    painter.setBrush(i == 0 ? QBrush(QColor(200, 200, 200)) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(swatch, 3, 3);
    painter.setPen(Qt::white);
    painter.drawText(QPointF(x + 21, box.center().y() + metrics.ascent() / 2 - 1), texts[i]);
    x += 21 + metrics.horizontalAdvance(texts[i]) + 12;
  }
  painter.restore();
}

std::string robotAt(const FieldFigures& figures, const Vector2& place, double tolerance) {
  for (const RobotBelief& belief : figures.robots) {
    const auto pose = belief.pose();
    if (pose && covers(*pose, belief.body, place, tolerance)) return belief.robot;
  }
  return {};
}

std::string figureAt(const FieldFigures& figures, const Vector2& place, double tolerance) {
  for (const RobotBelief& belief : figures.robots) {
    if (belief.truth && covers(*belief.truth, belief.body, place, tolerance)) return belief.robot;
  }
  if (figures.ball && (*figures.ball - place).norm() < figures.ballRadius + tolerance) return kBallModel;
  return {};
}

}  // namespace widgets
