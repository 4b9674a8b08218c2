// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace widgets {

/// An icon of resources/icons, "play" for play.svg. Its strokes take the text colour of the application's
/// palette whenever it is painted, so that it reads in light and dark without being made anew; colours that
/// the file fixes (stop, warning) stay. Sharp at every size. An icon whose file is missing paints nothing.
/// GUI thread.
QIcon icon(const QString& name);
inline QIcon icon(const char* name) {
  return icon(QString::fromLatin1(name));
}

}  // namespace widgets
