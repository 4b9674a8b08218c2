// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/RadarPainter.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"
#include "widgets/drive/RadarReadings.h"

namespace widgets {
namespace {

struct RadarText {
  Q_DECLARE_TR_FUNCTIONS(Radar)
};

using robotlink::Pose2;
using robotlink::Vector2;

constexpr double kRingPixels = 44;  // at least, between two rings
constexpr double kMarkPixels = 26;  // the robot is never smaller
constexpr double kSilentOpacity = 0.35;

QColor withAlpha(QColor color, double alpha) {
  color.setAlphaF(std::clamp(alpha, 0.0, 1.0));
  return color;
}

QPointF pointOn(const QTransform& transform, const Vector2& point) {
  return transform.map(QPointF(point.x(), point.y()));
}

QFont smallFont(const QPainter& painter) {
  QFont font = painter.font();
  font.setPixelSize(11);
  return font;
}

double ringStep(double scale) {
  for (const double step : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0}) {
    if (step * scale >= kRingPixels) return step;
  }
  return 20;
}

void paintRings(QPainter& painter, const RadarLook& look, const QTransform& toWidget,
                const QPalette& palette) {
  const double scale = look.scale(), step = ringStep(scale);
  const QPointF middle = pointOn(toWidget, {0, 0});
  const QColor line = mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.18);
  const double farthest = std::hypot(look.size.width(), look.size.height()) / 2 / scale;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(line, 1));
  for (const double angle : {0.0, 45.0, 90.0, 135.0}) {
    const Vector2 along(std::cos(robotlink::radians(angle)), std::sin(robotlink::radians(angle)));
    painter.setPen(QPen(line, 1, angle == 0 || angle == 90 ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(pointOn(toWidget, along * farthest), pointOn(toWidget, -along * farthest));
  }
  painter.setPen(QPen(line, 1));
  painter.setFont(smallFont(painter));
  for (int i = 1; i * step <= farthest; ++i) {
    const double radius = i * step * scale;
    painter.setPen(QPen(line, 1));
    painter.drawEllipse(middle, radius, radius);
    painter.setPen(colorOf(Meaning::kMuted, palette));
    painter.drawText(middle + QPointF(4, -radius - 3), RadarText::tr("%1 m").arg(i * step));
  }
}

/// Sector of a ring around the sensor, from radius `inner` to `outer`.
QPainterPath sector(const Pose2& sensor, double angle, double inner, double outer,
                    const QTransform& toWidget) {
  constexpr int kPieces = 12;
  QPolygonF outline;
  for (int i = 0; i <= kPieces; ++i) {
    const double at = -angle / 2 + angle * i / kPieces;
    outline << pointOn(toWidget, sensor * Vector2(outer * std::cos(at), outer * std::sin(at)));
  }
  for (int i = kPieces; i >= 0; --i) {
    const double at = -angle / 2 + angle * i / kPieces;
    outline << pointOn(toWidget, sensor * Vector2(inner * std::cos(at), inner * std::sin(at)));
  }
  QPainterPath path;
  path.addPolygon(outline);
  path.closeSubpath();
  return path;
}

void paintSonar(QPainter& painter, const RadarReadings& readings, const RadarLook& look,
                const QTransform& toWidget, const QPalette& palette) {
  const QColor color = colorOf(Meaning::kNote, palette);
  const double angle = readings.openingAngle > 0 ? readings.openingAngle : robotlink::radians(30);
  const double band = 3.5 / look.scale();
  for (const RadarReadings::Echo& echo : readings.echoes) {
    const double fresh = std::max(0.0, 1 - echo.age / look.memory);
    painter.setPen(Qt::NoPen);
    if (echo.newest) {
      painter.setBrush(withAlpha(color, (echo.nothing ? 0.05 : 0.16) * (0.3 + 0.7 * fresh)));
      painter.drawPath(sector(echo.sensorInRobot, angle, 0, echo.range, toWidget));
    }
    if (echo.nothing) continue;
    painter.setBrush(withAlpha(color, echo.newest ? 0.35 + 0.65 * fresh : 0.28 * fresh));
    painter.drawPath(sector(echo.sensorInRobot, angle, std::max(0.0, echo.range - band / 2),
                            echo.range + band / 2, toWidget));
  }
}

void paintLaser(QPainter& painter, const RadarReadings& readings, const QTransform& toWidget,
                const QPalette& palette) {
  const QColor color = colorOf(Meaning::kWarning, palette);
  QPolygonF free;
  for (const Vector2& corner : readings.laserFree) free << pointOn(toWidget, corner);
  painter.setPen(Qt::NoPen);
  painter.setBrush(withAlpha(color, 0.07));
  painter.drawPolygon(free);
  painter.setBrush(color);
  for (const Vector2& hit : readings.laser) {
    const QPointF at = pointOn(toWidget, hit);
    painter.drawRect(QRectF(at.x() - 1.5, at.y() - 1.5, 3, 3));
  }
}

/// The bumpers of one end from left to right; pressed ones are filled and have a thick edge.
void paintBumpers(QPainter& painter, const std::vector<bool>& pressed, const Vector2& body, double end,
                  const QTransform& toWidget, const QPalette& palette) {
  const double x = end * (body.x() / 2 + 0.03),
               width = body.y() / static_cast<double>(std::max<std::size_t>(1, pressed.size()));
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    const double left = body.y() / 2 - width * static_cast<double>(i), right = left - width;
    const QColor color = pressed[i] ? colorOf(Meaning::kBad, palette) : colorOf(Meaning::kMuted, palette);
    painter.setPen(QPen(color, pressed[i] ? 7 : 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(pointOn(toWidget, {x, left - 0.012}), pointOn(toWidget, {x, right + 0.012}));
  }
}

void paintWheels(QPainter& painter, const RadarReadings& readings, const QTransform& toWidget,
                 const QPalette& palette) {
  const Vector2& body = readings.body;
  for (const double side : {1.0, -1.0}) {
    const bool stalled = side > 0 ? readings.leftStalled : readings.rightStalled;
    const QColor color = stalled ? colorOf(Meaning::kBad, palette)
                                 : mixed(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.3);
    painter.setPen(QPen(color.darker(130), 1));
    painter.setBrush(color);
    for (const double end : {1.0, -1.0}) {
      const double x = end * 0.21 * body.x(), y = side * 0.44 * body.y(), length = 0.17 * body.x(),
                   width = 0.06 * body.y();
      painter.drawPolygon(toWidget.map(QPolygonF(QRectF(x - length, y - width, 2 * length, 2 * width))));
    }
  }
}

/// The robot's motion: an arrow as long as its way in one second, bent by its rotation.
void paintMotion(QPainter& painter, const RadarReadings& readings, const QTransform& toWidget,
                 const QPalette& palette) {
  if (std::abs(readings.speed) < 0.01 && std::abs(readings.rotation) < 0.03) return;
  painter.setPen(QPen(colorOf(Meaning::kGood, palette), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  QPolygonF way;
  Pose2 pose;
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    way << pointOn(toWidget, pose.translation());
    pose = pose * Pose2{readings.speed / kSteps, 0, std::clamp(readings.rotation, -3.0, 3.0) / kSteps};
  }
  if (std::abs(readings.speed) >= 0.01) painter.drawPolyline(way);
  const QPointF middle = pointOn(toWidget, {0, 0});
  const double turn = robotlink::degrees(std::clamp(readings.rotation, -2.5, 2.5));
  if (std::abs(turn) < 2) return;
  const QPointF ahead = pointOn(toWidget, {1, 0}) - middle;
  const double up = robotlink::degrees(std::atan2(-ahead.y(), ahead.x()));
  painter.drawArc(
      QRectF(middle - QPointF(kMarkPixels, kMarkPixels), QSizeF(2 * kMarkPixels, 2 * kMarkPixels)),
      static_cast<int>(up * 16), static_cast<int>(turn * 16));
}

void paintRobot(QPainter& painter, const RadarReadings& readings, const RadarLook& look,
                const QTransform& toWidget, const QPalette& palette) {
  QTransform enlarged = toWidget;
  const double factor = std::max(1.0, kMarkPixels / (readings.body.x() * look.scale()));
  enlarged.scale(factor, factor);
  paintWheels(painter, readings, enlarged, palette);
  const double x = readings.body.x() / 2, y = 0.37 * readings.body.y(), cut = 0.3 * y;
  painter.setPen(QPen(palette.color(QPalette::Text), 1.5));
  painter.setBrush(mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.12));
  painter.drawPolygon(enlarged.map(QPolygonF({{x - cut, y},
                                              {x, y - cut},
                                              {x, -y + cut},
                                              {x - cut, -y},
                                              {-x + cut, -y},
                                              {-x, -y + cut},
                                              {-x, y - cut},
                                              {-x + cut, y}})));
  painter.setBrush(palette.color(QPalette::Text));
  painter.drawPolygon(enlarged.map(QPolygonF({{0.75 * x, 0}, {0.25 * x, 0.4 * y}, {0.25 * x, -0.4 * y}})));
  paintBumpers(painter, readings.frontBumpers, readings.body, 1, enlarged, palette);
  paintBumpers(painter, readings.rearBumpers, readings.body, -1, enlarged, palette);
}

/// Problems in words at the upper left, so that color is not the only cue.
void paintTroubles(QPainter& painter, const RadarReadings& readings, const QPalette& palette) {
  QStringList troubles;
  if (readings.emergencyStop) troubles << RadarText::tr("emergency stop");
  if (readings.leftStalled && readings.rightStalled) {
    troubles << RadarText::tr("both sides are stalled");
  } else if (readings.leftStalled || readings.rightStalled) {
    troubles << (readings.leftStalled ? RadarText::tr("the left side is stalled")
                                      : RadarText::tr("the right side is stalled"));
  }
  const auto pressed = [](const std::vector<bool>& bumpers) {
    return std::find(bumpers.begin(), bumpers.end(), true) != bumpers.end();
  };
  if (pressed(readings.frontBumpers)) troubles << RadarText::tr("a front bumper is pressed");
  if (pressed(readings.rearBumpers)) troubles << RadarText::tr("a rear bumper is pressed");
  if (troubles.isEmpty()) return;
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(colorOf(readings.silence ? Meaning::kMuted : Meaning::kBad, palette));
  painter.drawText(QPointF(8, 8 + QFontMetricsF(font).ascent()), troubles.join(QStringLiteral(" · ")));
}

}  // namespace

double RadarLook::scale() const {
  return std::max(1.0, std::min(size.width(), size.height())) / 2 / std::clamp(range, kMinRange, kMaxRange);
}

QTransform robotToWidget(const RadarLook& look, double heading) {
  QTransform transform;
  transform.translate(look.size.width() / 2, look.size.height() / 2);
  transform.scale(look.scale(), -look.scale());
  transform.rotateRadians(look.northUp ? heading : robotlink::kPi / 2);
  return transform;
}

void paintRadar(QPainter& painter, const RadarReadings& readings, const RadarLook& look,
                const QPalette& palette) {
  painter.save();
  painter.fillRect(QRectF(QPointF(), look.size), palette.color(QPalette::Base));
  painter.setRenderHint(QPainter::Antialiasing);
  const QTransform toWidget = robotToWidget(look, readings.heading);
  paintRings(painter, look, robotToWidget(look, 0), palette);
  if (readings.silence) painter.setOpacity(kSilentOpacity);
  paintLaser(painter, readings, toWidget, palette);
  paintSonar(painter, readings, look, toWidget, palette);
  // The motion of a robot that sends nothing is unknown.
  if (!readings.silence) paintMotion(painter, readings, toWidget, palette);
  paintRobot(painter, readings, look, toWidget, palette);
  painter.setOpacity(1);
  paintTroubles(painter, readings, palette);
  painter.restore();
}

}  // namespace widgets
