// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace foxglove {
class Color;
}

namespace widgets {

/// Converts a message's color. Channels are clamped to 0 to 1; NaN becomes 0.
QColor qColor(const foxglove::Color& color);

}  // namespace widgets
