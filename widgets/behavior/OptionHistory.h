// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QRectF>
#include <QString>
#include <map>
#include <vector>

#include "robotlink/session/StreamStore.h"

class QPainter;

namespace robotcontrol {
class BehaviorState;
}

namespace widgets {

/// The states of a behavior's options over time, as strips: a row for each option, the present at the right.
/// A plain value with an update; GUI thread.
class OptionHistory {
 public:
  /// The length of the history, s.
  static constexpr double kSpan = 60;
  static constexpr double kRow = 18, kNames = 110;

  /// A time during which an option was in a state, s; an option that is not active has none.
  struct Segment {
    double from = 0, to = 0;
    QString state;
    QString reason;
  };
  struct Row {
    QString option;
    std::vector<Segment> segments;
  };

  /// Reads what is new of a stream of BehaviorState up to an instant; everything, if the instant is before
  /// the last one or the stream is another one. Null: nothing is known.
  void read(const robotlink::StreamStore::Stream* stream, robotlink::Instant until);
  void add(double time, const robotcontrol::BehaviorState& state);
  void clear();

  /// In the order in which the options became active first.
  const std::vector<Row>& rows() const { return rows_; }
  /// The newest time, s.
  double end() const { return end_; }
  double height() const { return kRow * static_cast<double>(rows_.size()); }
  /// The segment under a point of a picture of some width; null if there is none.
  const Segment* at(const QPointF& point, double width) const;
  /// The tooltip about a segment, as rich text.
  static QString toolTip(const Segment& segment);
  /// Pure. The rows are painted at the top of `area`.
  void paint(QPainter& painter, const QRectF& area, const QPalette& palette) const;

 private:
  void addState(double time, const QString& option, const QString& state, const QString& reason);
  QRectF rectOf(std::size_t row, const Segment& segment, double width) const;

  std::vector<Row> rows_;
  /// States by name, for their colors.
  std::map<QString, int> colors_;
  double end_ = 0;
  /// The message before that of `end_`, s.
  double before_ = -1;
  std::string path_;
  std::uint64_t generation_ = 0;
};

}  // namespace widgets
