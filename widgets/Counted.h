// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <cstdint>

namespace widgets {

/// Returns a count with its noun: "1 packet" or "7 packets". `one` is used as it is, `several` with the
/// number in place of its %1; the caller translates both. (Qt's %n would need a translation file even for
/// English.)
template <typename Number>
QString counted(Number number, const QString& one, const QString& several) {
  return number == 1 ? one : several.arg(number);
}

/// "1.4 MB"
inline QString bytesText(std::uint64_t bytes) {
  return QLocale::c().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

}  // namespace widgets
