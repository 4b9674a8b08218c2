// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotsView.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/EmptyHint.h"
#include "widgets/log/MissingValues.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/plots/PathCanvas.h"
#include "widgets/plots/PlotCanvas.h"
#include "widgets/plots/PlotPicture.h"
#include "widgets/plots/SpectrumCanvas.h"
#include "widgets/plots/TimeLink.h"

namespace widgets {
namespace {

const ViewRegistration kPlotsViewRegistration{
    {"plots", QT_TRANSLATE_NOOP("View", "Plots"),
     QT_TRANSLATE_NOOP("View", "Draws plot values and numbers of any stream over time."), "plots", true,
     create<PlotsView>}};

/// Spectra are drawn once in this many ticks, five times a second.
constexpr int kTicksPerSpectrum = 6;

}  // namespace

PlotsView::PlotsView(ViewContext& context, QWidget* parent)
    : View(context, parent), filter_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("plotsView"));
  askForFile_ = [this](const QString& title, const QString& suffix) {
    return QFileDialog::getSaveFileName(this, title, QStringLiteral("plot.") + suffix,
                                        QStringLiteral("*.") + suffix);
  };
  createActions();
  createTree();
  createLegend();
  createStatistics();
  createViews();
  connectSignals();
}

void PlotsView::connectSignals() {
  connect(showTree_, &QAction::toggled, treePanel_, &QWidget::setVisible);
  connect(add_, &QAction::triggered, this, &PlotsView::addSelected);
  connect(tree_, &QTreeView::activated, this, &PlotsView::addSelected);
  connect(tree_, &QTreeView::expanded, this, [this](const QModelIndex& index) {
    unfolded_.insert(index.data(PlotTreeModel::kPathRole).toString());
  });
  connect(tree_, &QTreeView::collapsed, this, [this](const QModelIndex& index) {
    unfolded_.erase(index.data(PlotTreeModel::kPathRole).toString());
  });
  connect(expression_, &QLineEdit::returnPressed, this, &PlotsView::addExpression);
  connect(remove_, &QAction::triggered, this, &PlotsView::removeSelected);
  connect(strip_, &QAction::triggered, this, &PlotsView::changeStrips);
  connect(across_, &QAction::triggered, this, &PlotsView::addAcross);
  connect(mark_, &QAction::triggered, this, &PlotsView::askForTextMarks);
  connect(previousChange_, &QAction::triggered, this, [this] { stepChange("previous"); });
  connect(nextChange_, &QAction::triggered, this, [this] { stepChange("next"); });
  connect(equal_, &QAction::toggled, paths_, &PathCanvas::setEqual);
  connect(showSpectrum_, &QAction::toggled, this, [this](bool on) {
    spectrum_->setVisible(on);
    dirty_ = true;
  });
  connect(fit_, &QAction::triggered, this, [this] {
    follow_->setChecked(false);
    canvas_->fit();
    paths_->fit();
  });
  connect(follow_, &QAction::toggled, this, [this] { dirty_ = true; });
  connect(wholeLog_, &QAction::toggled, this, [this] { logsVersion_ = 0; });
  connect(window_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    follow_->setChecked(true);
    dirty_ = true;
  });
  connect(right_, &QAction::triggered, this, &PlotsView::changeAxis);
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->setFilterFixedString(text);
    if (!text.isEmpty()) tree_->expandAll();
  });
  connect(legend_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { dirty_ = true; });
  connectCanvas();
  connectExports();
}

void PlotsView::connectCanvas() {
  connect(undo_, &QAction::triggered, canvas_, &PlotCanvas::undo);
  connect(redo_, &QAction::triggered, canvas_, &PlotCanvas::redo);
  TimeLink& link = TimeLink::of(openLogs(context()));
  connect(canvas_, &PlotCanvas::timesTouched, this, [this, &link](double from, double to) {
    dirty_ = true;
    if (link_->isChecked()) Q_EMIT link.moved(this, from, to);
  });
  connect(&link, &TimeLink::moved, this, &PlotsView::followLink);
  connect(cursors_, &QAction::triggered, this, [this](bool on) {
    const auto [from, to] = canvas_->shownTimes();
    setCursors(on ? CursorModel::Cursors({from + (to - from) / 4, to - (to - from) / 4}) : std::nullopt);
  });
  connect(canvas_, &PlotCanvas::cursorSet, this, [this](bool isSecond, double time) {
    auto times = between_.cursors().value_or(std::pair(time, time));
    (isSecond ? times.second : times.first) = time;
    setCursors(times);
  });
  connect(canvas_, &PlotCanvas::touched, this, [this] { follow_->setChecked(false); });
  connect(canvas_, &PlotCanvas::sourcesDropped, this, [this](const QStringList& sources) {
    for (const QString& source : sources) addCurve(source);
  });
  connect(canvas_, &PlotCanvas::cursorMoved, this, &PlotsView::showCursor);
}

void PlotsView::connectExports() {
  connect(copy_, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setPixmap(plotsPicture(*area_)); });
  connect(csv_, &QAction::triggered, this,
          [this] { exportAs(tr("Export the points as CSV"), QStringLiteral("csv")); });
  connect(spectrumCsv_, &QAction::triggered, this,
          [this] { exportAs(tr("Export the spectrum as CSV"), QStringLiteral("spectrum.csv")); });
  connect(png_, &QAction::triggered, this,
          [this] { exportAs(tr("Export the picture"), QStringLiteral("png")); });
  connect(svg_, &QAction::triggered, this,
          [this] { exportAs(tr("Export the drawing"), QStringLiteral("svg")); });
}

void PlotsView::setCursors(const CursorModel::Cursors& cursors) {
  cursors_->setChecked(cursors.has_value());
  between_.setCursors(cursors);
  canvas_->setCursors(cursors);
  statistics_->setVisible(cursors.has_value());
  dirty_ = true;
  if (cursors) state_->setText(tr("From A to B: %1 s").arg(cursors->second - cursors->first, 0, 'f', 3));
}

void PlotsView::followLink(const QObject* plot, double from, double to) {
  if (plot == this || !link_->isChecked()) return;
  follow_->setChecked(false);
  canvas_->showTimes(from, to);
}

std::vector<PlotChoice> PlotsView::choices() const {
  std::vector<LoggedStream> logged;
  for (const auto& log : openLogs(context()).logs()) {
    for (const auto& stream : log->overview->streams)
      logged.push_back({OpenLogs::sessionPath(*log, stream.path), stream.type});
  }
  return plotChoices(session().store(), logged);
}

void PlotsView::listSources() {
  const auto& store = session().store();
  decltype(listed_) now{store.listVersion(), openLogs(context()).version(), keyTables(store)};
  if (now == listed_) return;
  listed_ = std::move(now);
  const auto all = choices();
  std::vector<std::pair<QString, QString>> shown;
  for (const PlotChoice& choice : all) shown.emplace_back(choice.source.text(), choice.missing);
  if (shown == shownChoices_) return;
  shownChoices_ = std::move(shown);
  const std::set<QString> unfolded = unfolded_;
  sources_.setChoices(all, [this](const PlotSource& source) { return jointOf(source); });
  unfoldRobots();
  unfoldAgain({}, unfolded);
}

void PlotsView::unfoldRobots() {
  if (!search_->text().isEmpty()) return tree_->expandAll();
  // The streams of the world have hundreds of values each, and would hide those of robots below them.
  for (int row = 0; row < filter_->rowCount(); ++row) {
    const QModelIndex index = filter_->index(row, 0);
    if (filter_->hasChildren(filter_->index(0, 0, index))) tree_->expand(index);
  }
}

void PlotsView::unfoldAgain(const QModelIndex& parent, const std::set<QString>& unfolded) {
  for (int row = 0; row < filter_->rowCount(parent); ++row) {
    const QModelIndex index = filter_->index(row, 0, parent);
    if (!unfolded.contains(index.data(PlotTreeModel::kPathRole).toString())) continue;
    tree_->expand(index);
    unfoldAgain(index, unfolded);
  }
}

/// Returns "headPan" for "positions[1]" of a JointRequest; the robot's description numbers the joints.
QString PlotsView::jointOf(const PlotSource& source) const {
  constexpr std::string_view kPositions = "positions[";
  const auto robot = context().robots.find(robotlink::streams::robotOf(source.stream));
  if (source.type != "robotcontrol.JointRequest" || !source.field.starts_with(kPositions) ||
      robot == context().robots.end())
    return {};
  const std::size_t number = std::strtoul(source.field.c_str() + kPositions.size(), nullptr, 10);
  const auto& joints = robot->second->joints;
  return number < joints.size() ? QString::fromStdString(joints[number].name) : QString();
}

void PlotsView::showCursor(std::optional<double> time) {
  curves_.setCursor(time);
  canvas_->setCursorLine(time);
}

double PlotsView::shownTime() const {
  return robotlink::seconds(session().timeline().shown());
}

double PlotsView::followedEnd(double time, double length) const {
  std::optional<std::pair<double, double>> log;
  for (const auto& curve : curves_.curves()) {
    if (!curve->isLogged()) continue;
    const auto here = *curve->times();
    log = log ? std::pair(std::min(log->first, here.first), std::max(log->second, here.second)) : here;
  }
  if (!log) return time;
  return std::max(std::min(time + length / 2, log->second), std::max(time, log->first + length));
}

void PlotsView::showWholeLogButton(bool on) {
  findChild<QToolButton*>(QStringLiteral("plotsWholeLog"))->setVisible(on);
}

void PlotsView::showTimeMarks() {
  TimeMarks& marks = TimeMarks::of(openLogs(context()));
  marks.tick(session());
  if (marksVersion_ == marks.version()) return;
  marksVersion_ = marks.version();
  const auto meaningOf = [](LogEntry::Level level) {
    return level >= LogEntry::Level::kError     ? Meaning::kBad
           : level == LogEntry::Level::kWarning ? Meaning::kWarning
                                                : Meaning::kNote;
  };
  std::vector<PlotMarker> lines;
  for (const TimeMark& text : marks.texts())
    lines.push_back(
        {robotlink::seconds(text.from), robotlink::seconds(text.to), text.text, meaningOf(text.level)});
  for (const TimeMark& hit : marks.hits())
    lines.push_back({robotlink::seconds(hit.from), robotlink::seconds(hit.to), hit.text, Meaning::kGood});
  std::ranges::stable_sort(lines, {}, &PlotMarker::from);
  canvas_->setTextMarks(std::move(lines));
}

void PlotsView::showPaths(double shown) {
  const bool has =
      std::ranges::any_of(curves_.curves(), [](const auto& curve) { return curve->across != nullptr; });
  paths_->setVisible(has);
  findChild<QToolButton*>(QStringLiteral("plotsEqual"))->setVisible(has);
  const auto [from, to] = canvas_->shownTimes();
  if (has) paths_->refresh(from, to, shown);
}

void PlotsView::setSpectrum(bool on, const QString& window) {
  if (!window.isEmpty()) spectrum_->setWindow(window);
  showSpectrum_->setChecked(on);
}

void PlotsView::setEqualAxes(bool on) {
  equal_->setChecked(on);
}

void PlotsView::showSpectrum() {
  if (!showSpectrum_->isChecked()) return;
  const auto selected = selectedCurves();
  std::vector<std::shared_ptr<CurveModel::Curve>> curves;
  for (const auto& curve : curves_.curves()) {
    const bool isWanted = selected.empty() || std::ranges::find(selected, curve.get()) != selected.end();
    if (isWanted && !curve->across && !curve->isStrip()) curves.push_back(curve);
  }
  const auto cursors = between_.cursors();
  const auto [from, to] = cursors ? std::pair(std::min(cursors->first, cursors->second),
                                              std::max(cursors->first, cursors->second))
                                  : canvas_->shownTimes();
  spectrum_->showSpectra(std::move(curves), from, to);
}

void PlotsView::showMissing() {
  std::vector<MissingValues> all;
  for (const auto& curve : curves_.curves()) {
    const auto times = curve->isLogged() || curve->across ? std::nullopt : curve->times();
    curve->missing = times ? missingValues(session(), curve->reader.streams(), *times, curve->past.unread())
                           : std::vector<MissingValues>();
    all.insert(all.end(), curve->missing.begin(), curve->missing.end());
  }
  canvas_->setMissing(joined(std::move(all)));
}

void PlotsView::draw() {
  const double time = shownTime();
  const bool live = session().timeline().live();
  drawnTime_ = time;
  const bool hasFuture = std::ranges::any_of(curves_.curves(), [&](const auto& curve) {
    return curve->isLogged() && curve->times()->second > time;
  });
  canvas_->setMark(live && !hasFuture ? std::optional<double>() : time);
  const double length = window_->currentData().toInt();
  showMissing();
  canvas_->refresh(follow_->isChecked(), followedEnd(time, length), length, session().remoteRobots());
  showPaths(time);
  isSpectrumOld_ = true;
}

void PlotsView::followSession(double origin) {
  const std::pair begin(session().store().generation(), origin);
  if (sessionBegin_ && *sessionBegin_ != begin) {
    follow_->setChecked(true);
    dirty_ = true;
  }
  sessionBegin_ = begin;
}

void PlotsView::showEvent(QShowEvent* event) {
  isShownAnew_ = true;
  View::showEvent(event);
}

void PlotsView::tickHidden() {
  TimeMarks::of(openLogs(context())).tick(session());
  if (pause_->isChecked())
    curves_.hold(session().store());
  else
    dirty_ = curves_.update(session().store()) || dirty_;
}

void PlotsView::tick() {
  listSources();
  requestMissing();
  followLogs();
  showTimeMarks();
  const double origin = robotlink::seconds(session().timeline().origin());
  canvas_->setOrigin(origin);
  curves_.setOrigin(origin);
  followSession(origin);
  const bool empty = curves_.rowCount() == 0;
  hint_->setHint(!empty ? QString()
                 : sources_.rowCount() == 0
                     ? tr("Nothing to plot yet. Start a simulation or connect to a robot.")
                     : tr("Choose values on the left: double click, Enter or drag them here."));
  undo_->setEnabled(canvas_->history().canUndo());
  redo_->setEnabled(canvas_->history().canRedo());
  ticks_ = (ticks_ + 1) % kTicksPerSpectrum;
  if (pause_->isChecked()) return curves_.hold(session().store());
  dirty_ = curves_.update(session().store(), std::exchange(isShownAnew_, false)) || dirty_;
  // A transform of many points takes a while.
  if (ticks_ == 0 && std::exchange(isSpectrumOld_, false)) showSpectrum();
  dirty_ = dirty_ || (!session().timeline().live() && shownTime() != drawnTime_);
  if (!dirty_) return;
  dirty_ = false;
  draw();
}

}  // namespace widgets
