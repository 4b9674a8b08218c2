// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace widgets {

class OpenLogs;

/// Keeps the time axes of several plots alike: one that the user has moved says so here, and the others
/// follow. One for all plots of a window. GUI thread; owned by the logs, which are shared in the same way.
class TimeLink final : public QObject {
  Q_OBJECT
 public:
  /// The one of a window, created on the first call.
  static TimeLink& of(OpenLogs& logs);

 Q_SIGNALS:
  /// A plot shows these times now, in s.
  void moved(const QObject* plot, double from, double to);

 private:
  explicit TimeLink(OpenLogs& logs);
};

}  // namespace widgets
