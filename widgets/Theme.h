// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

namespace widgets {

/// Colors with a meaning, chosen for the palette in use: all are legible on its base color, light or dark.
/// They are functions of the palette, so a repaint after a palette change suffices. Colors of teams and
/// classes are not here; they are data.
enum class Meaning : std::uint8_t { kGood, kNote, kWarning, kBad, kMuted };

/// Whether the palette's text is lighter than its base.
bool isDark(const QPalette& palette);
/// Whether the palette is that of high contrast: texts in white on black.
bool isHighContrast(const QPalette& palette);
/// The color for a meaning on the palette's base color.
QColor colorOf(Meaning meaning, const QPalette& palette);
/// Color of the n-th curve (from 0); they repeat after twelve.
QColor curveColor(int index, const QPalette& palette);
/// A pale or deep tone of the n-th curve's hue, for surfaces that are not to shine: never glaring, and of one
/// lightness for all. `saturation` from 0 (gray) to 1.
QColor calmColor(int index, double saturation, const QPalette& palette);
/// (1 - share) * a + share * b, alpha included; `share` from 0 to 1.
QColor mixed(const QColor& a, const QColor& b, double share);

}  // namespace widgets
