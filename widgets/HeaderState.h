// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>

class QHeaderView;

namespace widgets {

/// The columns of a table as a person arranged them: their order, widths and how they are sorted, as JSON.
/// The width of a column that ColumnFit fits is 0.
QJsonValue headerState(const QHeaderView& header);

/// Arranges them again. Ignores what does not fit, also the binary states of former versions: Qt's own
/// QHeaderView::restoreState() crashes on damaged ones. GUI thread.
void restoreHeader(QHeaderView& header, const QJsonValue& state);

}  // namespace widgets
