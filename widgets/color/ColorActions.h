// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;
class QWidget;

namespace widgets {

class ColorBench;

/// What can be done in every colour view.
struct ColorActions {
  QAction* undo;
  QAction* redo;
};

/// Gives a view undo and redo of the samples (Ctrl+Z, Ctrl+Shift+Z), the digits that choose the class of the
/// next stroke (0: background), and N: it must not be of it. They work wherever the focus is within the
/// view. `prefix` begins the names of the actions: "colorClasses" makes "colorClassesUndo". The bench must
/// outlive the view.
ColorActions addColorActions(QWidget& view, const char* prefix, ColorBench& bench);

/// "1 stroke", "2 strokes".
QString strokesText(std::size_t count);

}  // namespace widgets
