// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/timeline/TimeLineLayout.h"

class QPainter;
class QPalette;

// Painting of a timeline: pure functions of the bands, the look and the palette, in the painter's font.
namespace widgets {

/// Paints everything but the play head. Takes some milliseconds, so a widget should cache the result.
void paintTimeLine(QPainter& painter, const std::vector<TimeLineBand>& bands, const TimeLineLook& look,
                   const QPalette& palette);
/// Paints the play head with its time, and the frame that shows the focus.
void paintPlayHead(QPainter& painter, const TimeLineLook& look, const QPalette& palette);

/// The color of the play head.
QColor playHeadColor(const QPalette& palette);

}  // namespace widgets
