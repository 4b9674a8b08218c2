// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/log/TimeLineLayout.h"

class QPainter;
class QPalette;

namespace widgets {

/// How a time line is drawn: pure functions of the bands, the look and the palette, in the painter's font.
///
/// All but the play head; it costs some milliseconds, so a widget keeps the outcome until something changes.
void paintTimeLine(QPainter& painter, const std::vector<TimeLineBand>& bands, const TimeLineLook& look,
                   const QPalette& palette);
/// The play head with its time, and the frame that tells the focus.
void paintPlayHead(QPainter& painter, const TimeLineLook& look, const QPalette& palette);

QColor playHeadColor(const QPalette& palette);

}  // namespace widgets
