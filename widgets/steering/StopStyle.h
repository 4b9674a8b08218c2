// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// The look of STOP buttons, which several views and the main window have.
namespace widgets {

/// Style sheet: white on red, dark on amber while it is engaged (checked), in light and dark themes. All
/// colors are set, so that none is inherited from the palette. `widgetClass` is the class that it applies to,
/// "QPushButton".
QString stopStyle(const QString& widgetClass);

/// The button's text: what the next click does.
QString stopText(bool engaged);

}  // namespace widgets
