// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QString>
#include <string>

#include "robotlink/base/Clock.h"
#include "widgets/Theme.h"
#include "widgets/drive/BatteryGauge.h"

namespace widgets {

struct ViewContext;

/// A short text with what it means; empty: nothing is known.
struct CardText {
  QString text;
  Meaning meaning = Meaning::kMuted;
  /// The whole of it, for a tooltip; empty: the same.
  QString details = {};
  bool operator==(const CardText&) const = default;
};

/// The state of a robot at a glance, translated. A plain value.
struct RobotCard {
  std::string robot;
  /// Its kind: "Sony Aibo ERS-210"; empty if it is not known.
  QString kind;
  /// The color of its team.
  QColor color;
  bool isSelected = false;
  /// Its activity, or why it stands still; the solution that decides; its connection.
  CardText state, behavior, link;
  /// State kUnknown if it does not say.
  BatteryLevel battery;
  /// Its newest image at the shown instant, small, or why there is none.
  QImage image;
  QString noImage;

  bool operator==(const RobotCard&) const = default;
  /// All of it in one text, a line each, for tooltips and screen readers.
  QString text() const;
};

/// The card of a robot at an instant, without its image.
RobotCard robotCard(const ViewContext& context, const std::string& robot, robotlink::Instant shown);

}  // namespace widgets
