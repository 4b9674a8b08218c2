// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>

class QHeaderView;

// Functions that save and restore how the user arranged the columns of a table.
namespace widgets {

/// The columns of a table as the user arranged them: their order, widths and how they are sorted, as JSON.
/// The width of a column that ColumnFit fits is 0.
QJsonValue headerState(const QHeaderView& header);

/// Applies what headerState() returned. A state that does not name exactly the header's columns is ignored,
/// including the binary states that former versions saved (Qt's own QHeaderView::restoreState() crashes on
/// damaged ones); widths are clamped. GUI thread.
void restoreHeader(QHeaderView& header, const QJsonValue& state);

}  // namespace widgets
