// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace app {

/// Whether a saved layout of docks is whole: containers that each hold one splitter or area, splitters whose
/// parts are as many as their sizes, and each dock once. The docking library stops in the middle of a layout
/// that is not, and then follows pointers to areas that are in no window; it also goes as deep as a file
/// says.
bool isDockLayout(const QByteArray& xml);

}  // namespace app
