// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/expressions/FieldPath.h"
#include "robotlink/series/Series.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/TypedStreams.h"

namespace widgets {

/// What a curve shows: a stream of plot values (no field), or a number in the messages of any other stream.
struct PlotSource {
  /// "red1/models/ball"
  std::string stream;
  /// "position_in_robot.x"; empty for streams of plot values.
  std::string field;
  /// Type of the stream's messages; empty if only the name of the source is known. Not compared.
  std::string type = {};
  /// What is computed of the values, as robotlink::PointFilter parses it; empty: nothing.
  std::string filter = {};
  bool operator==(const PlotSource& other) const {
    return stream == other.stream && field == other.field && filter == other.filter;
  }

  /// "red1/models/ball: position_in_robot.x | derivative"
  QString text() const;
  /// The inverse of text(), without the type.
  static PlotSource fromText(const QString& text);
};

/// Everything that can be plotted now: plot values and numbers of all streams, and the numbers of packages
/// that the robots' processes exchange but do not publish. Images, drawings, texts and tables are left out.
/// Streams are in natural order ("sonar 2" before "sonar 10"), fields in the order of their messages.
std::vector<PlotSource> plotSources(const robotlink::StreamStore& store);

/// The debug key that must be switched on so that the source is published; empty if none is known (yet) or it
/// is on already.
std::string keyFor(const robotlink::StreamStore& store, const PlotSource& source, robotlink::Instant time);

/// Reads the values of one source from a session's history, each once.
class PlotReader {
 public:
  /// What has arrived since the last call.
  struct News {
    /// Times are seconds on the session's timeline.
    std::vector<robotlink::Series::Point> points;
    /// The clock went back: earlier points are no longer valid.
    bool restarted = false;
  };
  explicit PlotReader(PlotSource source);
  const PlotSource& source() const { return source_; }
  /// Returns what arrived since the last call. Messages without the field are skipped.
  News take(const robotlink::StreamStore& store);
  /// The newest value.
  std::optional<double> last() const { return last_; }
  /// Empty: none, or not known before the first value.
  QString unit() const { return unit_; }

 private:
  std::optional<double> valueOf(const robotlink::StreamMessage& message);

  PlotSource source_;
  /// Empty for streams of plot values, and if the field is no path.
  std::optional<robotlink::FieldPath> path_;
  StreamCursor cursor_;
  std::optional<double> last_;
  QString unit_;
  bool unitKnown_ = false;
};

}  // namespace widgets
