// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QString>

class QWidget;

// Pictures of all plots that a widget holds, at their places in it. GUI thread.
namespace widgets {

/// Returns a picture of the plots at twice the resolution of the screen.
QPixmap plotsPicture(const QWidget& area);
/// Writes a PNG file, or, if its name ends so, an SVG file. False if it cannot be written.
bool savePlots(const QWidget& area, const QString& file);

}  // namespace widgets
