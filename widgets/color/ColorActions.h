// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;
class QWidget;

// The actions that all views of the color tool have in common.
namespace widgets {

class ColorBench;

/// Undo and redo of the samples; owned by the view.
struct ColorActions {
  QAction* undo;
  QAction* redo;
};

/// Gives a view undo and redo of the samples (Ctrl+Z, Ctrl+Shift+Z), the digits that choose the class of the
/// next stroke (0: background), and N, which toggles "must not be of the class". The shortcuts work while the
/// focus is anywhere within the view. `prefix` begins the actions' object names: "colorClasses" gives
/// "colorClassesUndo". The bench must outlive the view.
ColorActions addColorActions(QWidget& view, const char* prefix, ColorBench& bench);

/// "1 stroke", "2 strokes"; translated.
QString strokesText(std::size_t count);

}  // namespace widgets
