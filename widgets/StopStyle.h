// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace widgets {

/// How a STOP button looks: white on red, dark on amber while it is engaged, in light and dark alike. All
/// colors are given, so none is left over from the palette of before. For widgets of a class, "QPushButton".
QString stopStyle(const QString& widgetClass);

/// What a STOP button says: what a click does next.
QString stopText(bool engaged);

}  // namespace widgets
