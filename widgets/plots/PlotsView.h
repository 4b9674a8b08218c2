// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <tuple>

#include "widgets/HiddenTick.h"
#include "widgets/View.h"
#include "widgets/plots/CursorModel.h"
#include "widgets/plots/CurveModel.h"
#include "widgets/plots/PlotTreeModel.h"
#include "widgets/ports/PortSubscription.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QSortFilterProxyModel;
class QSplitter;
class QTreeView;

namespace widgets {

class EmptyHint;
class OpenLogs;
class PathCanvas;
class PlotCanvas;
class SpectrumCanvas;

/// Plots of values over time: any plot value, and any number in the messages of any stream. Curves are added
/// from a searchable tree by double click, Enter or drag and drop. If a robot does not yet publish a value,
/// its debug key is requested, and the state line says so. The legend shows the current values and those
/// under the cursor, another table what is at and between two cursors. The time axes of several plots can be
/// linked. Of what a log has, the whole log is drawn, which is read in the background. States are strips
/// below the curves; curves over other ones are drawn next to them, and spectra below.
///
/// PlotsViewTools.cpp has its controls, PlotsViewCurves.cpp what is done with curves, PlotsViewState.cpp
/// files and what it keeps of itself. It draws in each tick in which something is new. Registered as "plots".
/// GUI thread.
class PlotsView final : public View, public HiddenTick {
  Q_OBJECT
 public:
  /// Returns the name of the file to write; empty: canceled. Tests replace the dialog by it.
  using FileQuestion = std::function<QString(const QString& title, const QString& suffix)>;

  explicit PlotsView(ViewContext& context, QWidget* parent = nullptr);
  void setFileQuestion(FileQuestion question) { askForFile_ = std::move(question); }
  /// Adds a curve by PlotSource::text(); streams in expressions may be named without their robot. Fails if
  /// there is one already, or if something is wrong with the text.
  robotlink::Result<void> addCurve(const QString& source);
  /// Appends new points and redraws if something changed.
  void tick() override;
  void tickHidden() override;
  QJsonObject saveState() const override;
  void followNames(const Renamed& renamed) override;
  /// Takes kMaxRestored curves at most, and says so below the plot if there were more.
  void restoreState(const QJsonObject& state) override;
  /// All points of all curves as a table (.csv), the spectra that are shown as one (.spectrum.csv), or the
  /// picture of the plots (.png, .svg).
  robotlink::Result<void> saveTo(const QString& file) override;
  /// All points of all curves, as saveTo() writes them.
  std::optional<QString> numbers() override;
  /// removeCurve() and clear() remove one or all curves; removeCurve() returns false if there is none by this
  /// text, which is completed as by addCurve().
  bool removeCurve(const QString& source);
  void clear();
  /// Draws a curve as a strip of states, or as a curve. False if there is none by this text.
  bool setStrip(const QString& source, bool on);
  /// Shows spectra of the selected curves, or of all; `window` is a name as in SpectrumCanvas, empty: as it
  /// is.
  void setSpectrum(bool on, const QString& window);
  /// Whether units have the same length on both axes of curves over each other.
  void setEqualAxes(bool on);
  /// The PlotSource::text() of all curves, and of all that could be one.
  QStringList curves() const;
  QStringList sources() const;
  static constexpr int kMaxRestored = 100;
  /// The time window as long as the user chooses none, in s.
  static constexpr int kUsualWindow = 10;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void createActions();
  /// The actions that change what is shown of curves.
  void createLookActions();
  /// The tree of sources with its search field, and the field for expressions.
  void createTree();
  /// The table of the curves below the plot.
  void createLegend();
  /// The table of what is between the cursors.
  void createStatistics();
  void createViews();
  /// The row of tools above the plots.
  QWidget* createTools();
  void connectSignals();
  void connectCanvas();
  void connectExports();
  /// The source that a text of the user means; fails if something is wrong with it.
  robotlink::Result<PlotSource> sourceOf(const QString& text) const;
  /// The row of the curve that a text of the user means; -1: there is none.
  int rowOf(const QString& text) const;
  /// Adds the sources that are selected in the tree.
  void addSelected();
  /// The curves that are selected in the legend.
  std::vector<CurveModel::Curve*> selectedCurves();
  /// A menu of what can be computed of the selected curves.
  QMenu* createFilterMenu();
  /// Adds what was typed as an expression.
  void addExpression();
  /// Shows the selected curves as strips of states, or as curves again.
  void changeStrips();
  /// Adds the lower one of two selected curves over the upper one.
  void addAcross();
  /// Shows the instant before or behind the shown one at which the selected curve changes.
  void stepChange(const char* direction);
  /// Asks which texts are marked.
  void askForTextMarks();
  /// Adds curves of which this is computed of the selected ones.
  void addFiltered(const robotlink::PointFilter::Kind& kind);
  /// Moves the selected curves to the axis on the right; if all are there, to the one on the left.
  void changeAxis();
  /// Shows the cursors and what is between them, or hides both.
  void setCursors(const CursorModel::Cursors& cursors);
  /// Follows another plot that was moved, if both are linked.
  void followLink(const QObject* plot, double from, double to);
  /// Removes the curves that are selected in the legend.
  void removeSelected();
  /// Marks the bookmarks of the open logs.
  void showBookmarks(const OpenLogs& logs);
  /// Marks texts and what a search found.
  void showTimeMarks();
  /// Draws paths and spectra, if there are some to be shown.
  void showPaths(double shown);
  void showSpectrum();
  /// Finds out what of the history the curves lack, and has it hatched.
  void showMissing();
  /// Draws what is new.
  void draw();
  /// Everything that could be a curve.
  std::vector<PlotChoice> choices() const;
  /// Rebuilds the tree when there is something else to choose; what was unfolded stays so.
  void listSources();
  /// Unfolds the streams of robots; while something is searched for, all that was found.
  void unfoldRobots();
  void unfoldAgain(const QModelIndex& parent, const std::set<QString>& unfolded);
  /// Requests the debug keys of curves whose source is not published, each once.
  void requestMissing();
  /// Goes back to the session's time when another log or simulation begins: the old times are not in it.
  void followSession(double origin);
  /// Lets the curves of open logs be read, and what of live robots is on disk, and says how far that is.
  void followLogs();
  void followHistory();
  /// Requests the debug key of a stream of a curve, once.
  void requestStream(CurveModel::Curve& curve, const std::string& stream);
  void showWholeLogButton(bool on);
  /// Asks for a file with this suffix and saves to it.
  void exportAs(const QString& title, const QString& suffix);
  /// The end of the time axis while following: the shown time, or half a window later if the log is known.
  double followedEnd(double time, double length) const;
  /// The timeline's shown instant, in s.
  double shownTime() const;
  /// Name of the joint that "positions[1]" of a JointRequest refers to; empty for other sources.
  QString jointOf(const PlotSource& source) const;
  /// Shows the values at a time (in s) in the legend, and a line in the plot.
  void showCursor(std::optional<double> time);

  PlotTreeModel sources_;
  /// Requests the sensors of a scene that curves show.
  PortSubscription ports_;
  CurveModel curves_;
  CursorModel between_{curves_};
  /// The tree's model filtered by the search field.
  QSortFilterProxyModel* filter_;
  FileQuestion askForFile_;
  PlotCanvas* canvas_ = nullptr;
  PathCanvas* paths_ = nullptr;
  SpectrumCanvas* spectrum_ = nullptr;
  /// The area that pictures contain: the canvases.
  QWidget* area_ = nullptr;
  QTreeView* tree_ = nullptr;
  QWidget* treePanel_ = nullptr;
  QTreeView* legend_ = nullptr;
  /// The statistics between the cursors.
  QTreeView* statistics_ = nullptr;
  QLineEdit* search_ = nullptr;
  QLineEdit* expression_ = nullptr;
  /// Length of the time window while following, in s; 0: all.
  QComboBox* window_ = nullptr;
  QLabel* state_ = nullptr;
  QSplitter* splitter_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* showTree_ = nullptr;
  QAction* add_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* follow_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* fit_ = nullptr;
  QAction* wholeLog_ = nullptr;
  QAction* csv_ = nullptr;
  QAction* png_ = nullptr;
  QAction* svg_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* link_ = nullptr;
  QAction* cursors_ = nullptr;
  QAction* right_ = nullptr;
  QAction* strip_ = nullptr;
  QAction* across_ = nullptr;
  QAction* equal_ = nullptr;
  QAction* showSpectrum_ = nullptr;
  QAction* mark_ = nullptr;
  QAction* previousChange_ = nullptr;
  QAction* nextChange_ = nullptr;
  QAction* spectrumCsv_ = nullptr;
  /// The inputs of the tree: versions of the store's list of streams and of the open logs,
  /// and the tables of debug keys.
  std::tuple<std::uint64_t, std::uint64_t, std::vector<robotlink::PackagePtr>> listed_{};
  /// Generation of the store and origin in s, in the last tick.
  std::optional<std::pair<std::uint64_t, double>> sessionBegin_;
  /// The texts and reasons that the tree shows.
  std::vector<std::pair<QString, QString>> shownChoices_;
  /// The folders and streams that the user has unfolded.
  std::set<QString> unfolded_;
  /// TimeMarks::version() of what is marked.
  std::uint64_t marksVersion_ = 0;
  /// Version of the open logs in which the curves were looked up; 0: they must be looked up again.
  std::uint64_t logsVersion_ = 0;
  /// The last text about the reading of logs.
  QString readingText_;
  /// Counts ticks from one spectrum to the next.
  int ticks_ = 0;
  /// Whether it was not ticked before: what the history dropped meanwhile is read again.
  bool isShownAnew_ = false;
  /// Whether something changed since the last drawing.
  bool dirty_ = true;
  /// Whether something was drawn since spectra were.
  bool isSpectrumOld_ = false;
  /// The shown instant when the plot was drawn last, in s.
  double drawnTime_ = -1;
};

}  // namespace widgets
