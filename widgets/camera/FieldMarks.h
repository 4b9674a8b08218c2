// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace robotlink {
struct FieldDescription;
}

namespace widgets {

/// A point of the field that can be recognized in an image.
struct FieldMark {
  /// "goal post", translated.
  QString kind;
  /// In the field's frame, m.
  robotlink::Vector3 place = robotlink::Vector3::Zero();

  /// "2.10, -0.30".
  QString placeText() const;
  /// "goal post (2.10, -0.30)".
  QString name() const;
};

/// The points in which lines meet or end, the feet of goal posts and beacons, and the inner corners of walls.
/// The middles of lines count, as they are painted.
std::vector<FieldMark> fieldMarks(const robotlink::FieldDescription& field);

}  // namespace widgets
