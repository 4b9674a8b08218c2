// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>

class QHeaderView;

// Saving and restoring how the user arranged the columns of a table.
namespace widgets {

/// Order and widths of the columns and the sort column, as JSON: {"columns": [[logical index, width in
/// pixels], ...] in visual order, "sorted_by": logical index, "descending": bool}.
QJsonValue headerState(const QHeaderView& header);

/// Applies what headerState() returned. A state that does not name exactly the header's columns is ignored,
/// including the binary states that former versions saved (Qt's own QHeaderView::restoreState() crashes on
/// damaged ones); widths are clamped. GUI thread.
void restoreHeader(QHeaderView& header, const QJsonValue& state);

}  // namespace widgets
