// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace app {

/// Whether a saved state of the window's toolbars, as QMainWindow::saveState() writes it, is whole and of a
/// window without dock widgets of Qt's own. QMainWindow::restoreState() believes the numbers of lines and
/// toolbars in it, and reads on for minutes behind its end.
bool isToolBarState(const QByteArray& state);

}  // namespace app
