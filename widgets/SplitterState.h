// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>

class QSplitter;

// Functions that save and restore how the user divided a view.
namespace widgets {

/// The sizes of a splitter's parts, as text.
QJsonValue splitterState(const QSplitter& splitter);

/// Applies the sizes of what splitterState() returned. Everything else in it is left alone, since a damaged
/// state can make Qt's own QSplitter::restoreState() allocate gigabytes, or make the handle so wide that no
/// screen holds the window; so is a state of another number of parts. GUI thread.
void restoreSplitter(QSplitter& splitter, const QJsonValue& state);

}  // namespace widgets
