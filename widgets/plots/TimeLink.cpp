// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/TimeLink.h"

#include "widgets/log/OpenLogs.h"

namespace widgets {

TimeLink& TimeLink::of(OpenLogs& logs) {
  auto* known = logs.findChild<TimeLink*>(QString(), Qt::FindDirectChildrenOnly);
  return known != nullptr ? *known : *new TimeLink(logs);
}

TimeLink::TimeLink(OpenLogs& logs) : QObject(&logs) {}

}  // namespace widgets
