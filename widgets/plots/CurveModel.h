// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robotlink/series/PointFilter.h"
#include "robotlink/series/Series.h"
#include "widgets/log/MissingValues.h"
#include "widgets/plots/LoggedCurve.h"
#include "widgets/plots/PastValues.h"
#include "widgets/plots/PlotSource.h"

namespace widgets {

/// The names of curves for users, made of the text() of their sources: those of values of simulated sensors
/// are short, as in "red1/headPan", with a number where several values of a sensor are shown: "red1/laser
/// [0]". All others stay as they are. Pure.
std::vector<QString> curveTitles(const std::vector<QString>& texts);

/// The curves of a plot with their points: the data of its canvases and the rows of its legend. The oldest
/// points that sessions published are dropped when all curves together take more than kMaxBytes, what filters
/// made of them and of logs included; what filters make of a log ends there. Times are seconds on the
/// session's timeline. GUI thread.
class CurveModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// Source, newest value, its unit, and the value under the cursor.
  enum Column { kName, kValue, kUnit, kAtCursor, kColumns };
  /// Bound of the memory for points, without those that are read of logs.
  static constexpr std::size_t kMaxBytes = 512U << 20U;

  struct Curve {
    /// The filter and the expression of the source must be right.
    explicit Curve(const PlotSource& source);
    const PlotSource& source() const { return reader.source(); }
    /// The values of the log; null if it is not read.
    std::shared_ptr<const robotlink::Series> ofLog() const;
    /// All that is known of the curve: of the log as a whole, or what the session published.
    const robotlink::Series& points() const { return isLogged() ? *ofLog() : live; }
    /// Whether the log has the values that the session publishes, so that `live` adds nothing to them.
    bool isLogged() const { return logged && !isRecomputed && !ofLog()->empty(); }
    /// Whether its values are states, drawn as a strip: what the user chose, else whether they have names.
    bool isStrip() const { return !across && asStrip.value_or(!names.isEmpty() && source().filter.empty()); }
    /// A value in words: the name of a state, or a number.
    QString words(double value) const;
    /// The bytes of its points, without those that are read of logs.
    std::size_t bytes() const;
    /// The curves that it consists of: itself, and the one that it is drawn over.
    std::vector<Curve*> parts();
    std::vector<const Curve*> parts() const;
    /// The newest value that is not later than a time; empty without one.
    std::optional<double> valueAt(double time) const;
    /// The times of the first and the last point; empty without points.
    std::optional<std::pair<double, double>> times() const;
    /// The newest value that the session published, and the unit of the values; empty if not known.
    std::optional<double> last() const;
    QString unit() const;
    /// Takes the new values of the log; the filter's result ends at `bytes` bytes. Returns true if there is
    /// something.
    bool takeLogged(std::size_t bytes);
    /// The same for the session's values. `afresh`: if some of them were missed, the curve starts over with
    /// the values of the history.
    bool takeLive(const robotlink::StreamStore& store, bool afresh);
    /// Takes it for the next takeLive(), and changes nothing else.
    void hold(const robotlink::StreamStore& store);

    /// Reads the values from the session's store.
    PlotReader reader;
    /// Its name for users, see curveTitles().
    QString title = {};
    /// Index for curveColor(); the lowest that was free.
    int color = 0;
    /// The values that hold() took.
    PlotReader::News held = {};
    /// The values that the session published, behind those read of its history.
    robotlink::Series live;
    PastValues past;
    /// The part of the history that `live` lacked when it was last drawn.
    std::vector<MissingValues> missing = {};
    /// The same of the whole log, before the filter; null if it is not read.
    std::shared_ptr<const LoggedCurve> logged;
    /// The filter's result for `logged`; unused without a filter.
    std::shared_ptr<robotlink::Series> filtered = std::make_shared<robotlink::Series>();
    robotlink::PointFilter liveFilter, logFilter;
    /// Whether the program recomputes what the log has, so that both are of interest.
    bool isRecomputed = false;
    /// The points of `logged` at the last update(): how many, and when they began.
    std::size_t loggedBefore = 0;
    double loggedSince = 0;
    /// Whether its values belong to the axis on the right.
    bool isRight = false;
    /// The streams of the curve whose debug keys were requested.
    std::set<std::string> requested = {};
    /// Set for values that are states.
    StateNames names = {};
    /// Whether it is drawn as a strip; empty: as its values are.
    std::optional<bool> asStrip = {};
    /// The curve over which it is drawn instead of time; null: over time.
    std::unique_ptr<Curve> across = {};
    /// The reason why it had no values at the last update.
    QString problem = {};
    /// Whether what the filter makes of the log needs too much memory.
    bool isFilteredCut = false;
  };

  using QAbstractTableModel::QAbstractTableModel;
  /// Appends a curve. False if there is one of this source already, or the source has no stream or a wrong
  /// filter or expression.
  bool add(const PlotSource& source);
  void remove(int row);
  void clear();
  /// Adds the points that arrived since the last call. True if there is something new to draw. `afresh`: a
  /// curve of which some were missed starts over, so that they are read again.
  bool update(const robotlink::StreamStore& store, bool afresh = false);
  /// Takes the points that arrived for the next update(), before the history drops them.
  void hold(const robotlink::StreamStore& store);
  /// Sets the time that headers and csv() show as 0 s.
  void setOrigin(double seconds);
  /// Time under the cursor in s; empty: the cursor is not over the plot.
  void setCursor(std::optional<double> time);
  /// The curves, in the order of the rows; what draws them shares them.
  std::vector<std::shared_ptr<Curve>>& curves() { return curves_; }
  const std::vector<std::shared_ptr<Curve>>& curves() const { return curves_; }
  /// All points as text: a column "time_s", since the origin, then one per curve, empty where it has no value
  /// at that time; states by their names. A curve over another one has two columns.
  QString csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// The lowest color index that no curve has.
  int freeColor() const;
  /// Names all curves, since one that is added or removed may tell others apart.
  void nameCurves();
  /// The text of a cell of the legend.
  QVariant text(const Curve& curve, int column) const;
  QString toolTip(const Curve& curve) const;
  std::vector<std::shared_ptr<Curve>> curves_;
  double origin_ = 0;             ///< s
  std::optional<double> cursor_;  ///< s; empty: the cursor is not over the plot
};

}  // namespace widgets
