// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

namespace widgets {

/// "1 stroke" or, with the number in the place of %1, "12 strokes". Both are to be translated already.
inline QString counted(qulonglong count, const QString& one, const QString& several) {
  return count == 1 ? one : several.arg(QLocale().toString(count));
}

}  // namespace widgets
