// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"
#include "widgets/models/TypedStreams.h"

namespace widgets {

/// What a curve shows: a stream of plot values (no field), or a number in the messages of any other stream.
struct PlotSource {
  std::string stream;     ///< "red1/models/ball"
  std::string field;      ///< "position_in_robot.x"; empty for plot values
  std::string type = {};  ///< of the stream's messages; empty where only the source's name is known
  bool operator==(const PlotSource& other) const { return stream == other.stream && field == other.field; }

  QString text() const;  ///< "red1/models/ball: position_in_robot.x"
  static PlotSource fromText(const QString& text);
};

/// All that can be plotted now: every stream's plot values and numbers, and those of packages that the
/// robots' processes exchange but do not yet tell, by the type they have. Pictures, drawings, texts and
/// tables are left out. In the natural order: "sonar 2" before "sonar 10", and fields as their messages have
/// them.
std::vector<PlotSource> plotSources(const robotlink::StreamStore& store);

/// The debug key to switch on so that this source is told; empty if none is known (yet) or it is on already.
std::string keyFor(const robotlink::StreamStore& store, const PlotSource& source, robotlink::Instant time);

/// Follows one source through a session's history.
class PlotSeries {
 public:
  struct Point {
    double time = 0;  ///< s
    double value = 0;
  };
  struct News {
    std::vector<Point> points;
    bool restarted = false;  ///< earlier points are no longer true
  };
  explicit PlotSeries(PlotSource source) : source_(std::move(source)) {}
  const PlotSource& source() const { return source_; }
  /// What came since the last call.
  News take(const robotlink::StreamStore& store);
  std::optional<double> last() const { return last_; }
  QString unit() const { return unit_; }

 private:
  std::optional<double> valueOf(const robotlink::StreamMessage& message);

  PlotSource source_;
  StreamCursor cursor_;
  std::optional<double> last_;
  QString unit_;
  bool unitKnown_ = false;
};

}  // namespace widgets
