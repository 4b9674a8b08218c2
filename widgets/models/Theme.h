// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

namespace widgets {

/// Colours that mean something, for the palette in use: all of them read on its base colour, light or dark.
/// Follows the palette given, so a repaint after a palette change is enough. Team and class colours are not
/// here; they come from data.
enum class Meaning : std::uint8_t { kGood, kNote, kWarning, kBad, kMuted };

bool isDark(const QPalette& palette);
QColor colorOf(Meaning meaning, const QPalette& palette);
/// The colour of the n-th curve; twelve differ, then they repeat.
QColor curveColor(int index, const QPalette& palette);
/// `share` of b and the rest of a.
QColor mixed(const QColor& a, const QColor& b, double share);

}  // namespace widgets
