// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/expressions/BoundExpression.h"
#include "robotlink/expressions/FieldPath.h"
#include "robotlink/series/Series.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/TypedStreams.h"

namespace widgets {

/// The source of a curve: a stream of plot values (no field), a value in the messages of any other stream, or
/// what an expression makes of several.
struct PlotSource {
  /// "red1/models/ball"; empty for expressions.
  std::string stream;
  /// "position_in_robot.x"; empty for streams of plot values.
  std::string field = {};
  /// Type of the stream's messages; empty if only the name of the source is known. Not compared.
  std::string type = {};
  /// The filter of the values, as robotlink::PointFilter parses it; empty: none.
  std::string filter = {};
  /// "sqrt(red1/models/ball.position.x^2)", see robotlink/expressions/EXPRESSIONS.md; empty: it is not an
  /// expression.
  std::string expression = {};
  /// The text() of the source that it is drawn over, instead of time; empty: over time.
  std::string across = {};
  bool operator==(const PlotSource& other) const {
    return stream == other.stream && field == other.field && filter == other.filter &&
           expression == other.expression && across == other.across;
  }
  bool isEmpty() const { return stream.empty() && expression.empty(); }

  /// "red1/models/ball: position.y | derivative", "= 2 * red1/models/ball.position.y", each perhaps with
  /// " over red1/models/ball: position.x" behind it.
  QString text() const;
  /// The inverse of text(), without the type. A text that is an expression with values is one without the =,
  /// too, unless it is nothing but one value: that is a stream and its field.
  static PlotSource fromText(const QString& text);
};

/// Completes a source that users wrote: streams that are named without a robot are those of `robot`, if it
/// has them. `streams` and `robots` are all that are known. Fails if an expression or a
/// filter is wrong.
robotlink::Result<PlotSource> completed(PlotSource source, const std::string& robot,
                                        const std::vector<std::string>& streams,
                                        const std::vector<std::string>& robots);

/// Names of values that are states rather than quantities: of enumerations, bools and texts.
class StateNames {
 public:
  static constexpr std::size_t kMax = 1000;

  void add(double value, const QString& name);
  /// Adds those that others know.
  void merge(const StateNames& others);
  std::size_t size() const { return states_.size(); }
  bool isEmpty() const { return states_.empty(); }
  /// Its name; a number without one is its own name.
  QString name(double value) const;
  /// A small number for its color, the same as long as it is known.
  int color(double value) const;

 private:
  struct State {
    QString name;
    /// The number of those known before.
    int place;
  };
  /// Null if it has no name.
  const State* find(double value) const;

  std::map<double, State> states_;
};

/// The debug key that must be switched on so that a stream is published; empty if none is known (yet) or it
/// is on already.
std::string keyFor(const robotlink::StreamStore& store, const std::string& stream, robotlink::Instant time);

/// Reads the values of one source from a session's history, each once. An expression has a point at each
/// instant at which one of its streams has a message, with the last values before of the others; a message
/// that arrives late counts from its arrival on.
class PlotReader {
 public:
  /// The values that have arrived since the last call.
  struct News {
    /// Times are seconds on the session's timeline.
    std::vector<robotlink::Series::Point> points;
    /// The clock went back: earlier points are no longer valid.
    bool restarted = false;
    /// Values before these are missing: the history dropped them before they were taken. These are all that
    /// it has in memory.
    bool missed = false;
    /// Appends what arrived later.
    void append(News later);
  };
  explicit PlotReader(PlotSource source);
  const PlotSource& source() const { return source_; }
  /// The streams that it needs, as far as they are known.
  const std::vector<std::string>& streams() const { return streams_; }
  /// Returns what arrived since the last call. Messages without the field are skipped.
  News take(const robotlink::StreamStore& store);
  /// Returns why there can be no values now: what is misspelled, or missing; empty: there can.
  QString problem(const robotlink::StreamStore& store) const;
  const StateNames& names() const { return names_; }
  /// The newest value.
  std::optional<double> last() const { return last_; }
  /// Empty: none, or not known before the first value.
  QString unit() const { return unit_; }

 private:
  /// Returns why the present messages have no value: of a field, of an expression. Empty: they have.
  QString missingField(const robotlink::StreamStore& store) const;
  QString missingValue(const robotlink::StreamStore& store) const;
  std::optional<double> valueOf(const robotlink::StreamMessage& message);
  /// The number of a value, whose name is remembered.
  std::optional<double> numberOf(const std::optional<robotlink::FieldValue>& value);
  News takeOfStream(const robotlink::StreamStore& store);
  News takeOfExpression(const robotlink::StreamStore& store);
  /// Binds the expression when there are other streams.
  void bind(const robotlink::StreamStore& store);

  PlotSource source_;
  std::vector<std::string> streams_;
  StateNames names_;
  std::optional<robotlink::BoundExpression> expression_;
  QString problem_;
  /// The store's list of streams that the expression was bound to last; 0: never.
  std::uint64_t listVersion_ = 0;
  /// The store's generation at the last call.
  std::optional<std::uint64_t> generation_;
  std::map<std::string, StreamCursor> cursors_;
  /// The time of the expression's newest point, in s.
  double newest_ = -std::numeric_limits<double>::infinity();
  /// Empty for streams of plot values, and if the field is no path.
  std::optional<robotlink::FieldPath> path_;
  std::optional<double> last_;
  QString unit_;
  bool unitKnown_ = false;
};

}  // namespace widgets
