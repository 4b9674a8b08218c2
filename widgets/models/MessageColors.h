// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace foxglove {
class Color;
}

namespace widgets {

/// Of a message's colour; channels out of range are clamped.
QColor qColor(const foxglove::Color& color);

}  // namespace widgets
