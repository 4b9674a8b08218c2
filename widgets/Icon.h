// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

// Icons from resources/icons, recolored for the palette in use.
namespace widgets {

/// Loads an icon by the base name of its file, "play" for play.svg. The strokes are drawn in the text color
/// of the application's palette each time the icon is painted, so it is legible in light and dark themes
/// without being reloaded; colors that the file sets explicitly (stop, warning) are kept. Scales to every
/// size without blur. If the file is missing the icon paints nothing. GUI thread.
QIcon icon(const QString& name);
/// Loads an icon by a Latin-1 literal.
inline QIcon icon(const char* name) {
  return icon(QString::fromLatin1(name));
}

}  // namespace widgets
