// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>
#include <optional>

#include "robotlink/base/Geometry.h"

namespace robotcontrol {
class CameraPose;
}

namespace widgets {

/// The point of the floor that an image shows at a pixel, in the robot's frame (m, x to the front, y to the
/// left); unset if the pixel is above the horizon. `pixel`: in an image of the size `image`, from its upper
/// left corner; images that are larger or smaller than the camera's are taken for scaled ones. A pure
/// function: a pinhole camera, as robotcontrol.CameraPose describes it.
std::optional<robotlink::Vector2> floorPoint(const robotcontrol::CameraPose& camera, const QSizeF& image,
                                             const QPointF& pixel);

}  // namespace widgets
