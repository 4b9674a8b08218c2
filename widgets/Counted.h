// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace widgets {

/// "1 packet" or "7 packets": `one` as it is, or `several` with the number in place of its %1. Both are
/// translated by the caller. (Qt's %n would need a translation file, for English, too.)
template <typename Number>
QString counted(Number number, const QString& one, const QString& several) {
  return number == 1 ? one : several.arg(number);
}

}  // namespace widgets
