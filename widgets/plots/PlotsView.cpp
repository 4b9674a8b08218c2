// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotsView.h"

#include <QAction>
#include <QBoxLayout>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <cstdlib>

#include "robotlink/config/RobotDescription.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/plots/LoggedCurves.h"
#include "widgets/plots/PlotCanvas.h"
#include "widgets/plots/TimeLink.h"

namespace widgets {
namespace {

const ViewRegistration kPlotsViewRegistration{
    {"plots", QT_TRANSLATE_NOOP("View", "Plots"),
     QT_TRANSLATE_NOOP("View", "Draws plot values and numbers of any stream over time."), "plots", true,
     create<PlotsView>}};

constexpr int kTicks = 6;                               // of this many ticks (at 30 Hz)...
constexpr int kDrawn = 5;                               // ...at most this many draw: 25 Hz
constexpr int kWindows[] = {1, 2, 5, 10, 30, 60, 300};  // s

/// How a stream is replayed that is a package of a log; empty for others.
std::optional<robotcontrol::ControlReplay::PackageSource> replayed(const robotcontrol::ReplayStatus& status,
                                                                   const std::string& stream) {
  for (const auto& package : status.packages()) {
    if (package.package() == stream && package.logged()) return package.source();
  }
  return std::nullopt;
}

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

void PlotsView::createActions() {
  showTree_ = makeToggle(
      this, "filter",
      {"plotsShowTree", tr("Values"), tr("Shows the tree of what can be plotted"), tr("Ctrl+Shift+V")}, true);
  showTree_->setIcon({});
  add_ = makeAction(this, "add",
                    {"plotsAdd", tr("Add"), tr("Adds the selected values as curves"), tr("Ctrl+Return")});
  remove_ = makeAction(
      this, "remove", {"plotsRemove", tr("Remove"), tr("Removes the selected curves"), QKeySequence::Delete});
  follow_ =
      makeToggle(this, "follow",
                 {"plotsFollow", tr("Follow"), tr("Keeps the newest values in view"), tr("Ctrl+E")}, true);
  pause_ = makeToggle(this, "pause",
                      {"plotsPause", tr("Pause"), tr("Freezes the plot; nothing is lost"), tr("Ctrl+T")});
  wholeLog_ = makeToggle(
      this, "time-line",
      {"plotsWholeLog", tr("Whole log"), tr("Reads the curves of the whole log, without playing it")}, true);
  fit_ = makeAction(this, "fit", {"plotsFit", tr("Fit"), tr("Shows all points of the curves"), tr("Ctrl+0")});
  csv_ = makeAction(this, "save",
                    {"plotsCsv", tr("Export CSV"), tr("Writes all points to a table"),
                     QKeySequence(QStringLiteral("Ctrl+Shift+E"))});
  png_ = makeAction(this, "camera", {"plotsPng", tr("Export PNG"), tr("Writes the picture to a file")});
  svg_ = makeAction(this, "export", {"plotsSvg", tr("Export SVG"), tr("Writes the drawing to a file")});
  copy_ = makeAction(this, "copy",
                     {"plotsCopy", tr("Copy picture"), tr("Copies the picture"), QKeySequence::Copy});
  undo_ = makeAction(this, "undo",
                     {"plotsUndo", tr("Previous view"), tr("Shows what was shown before"),
                      QKeySequence(QStringLiteral("Alt+Left"))});
  redo_ = makeAction(this, "redo",
                     {"plotsRedo", tr("Next view"), tr("Shows what was shown before going back"),
                      QKeySequence(QStringLiteral("Alt+Right"))});
  link_ = makeToggle(this, "lock",
                     {"plotsLink", tr("Link"), tr("Shows the same times as the other linked plots")});
  cursors_ = makeToggle(this, "select-area",
                        {"plotsCursors", tr("Cursors"),
                         tr("Shows what is at and between two cursors; a click sets A, Shift+click sets B")});
  right_ = makeAction(
      this, "two-pictures",
      {"plotsRight", tr("Other axis"), tr("Moves the selected curves to the axis on the right, or back")});
}

void PlotsView::createTree() {
  treePanel_ = new QWidget(this);
  search_ = makeSearchField(
      treePanel_, {"plotsSearch", tr("Search values"), tr("Shows the values whose path contains this")});
  tree_ = new QTreeView(treePanel_);
  styleTree(*tree_);
  describe(*tree_, {"plotsTree", tr("Values that can be plotted"),
                    tr("Double click, Enter or drag into the plot to add a curve")});
  filter_->setSourceModel(&sources_);
  filter_->setRecursiveFilteringEnabled(true);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  filter_->setFilterRole(PlotTreeModel::kSourceRole);
  tree_->setModel(filter_);
  tree_->setHeaderHidden(true);
  new ColumnFit(*tree_, {ColumnKind::kName, ColumnKind::kNumber});
  tree_->setTextElideMode(Qt::ElideMiddle);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setDragEnabled(true);
  tree_->setDragDropMode(QAbstractItemView::DragOnly);
  auto* layout = makeColumn(treePanel_, {}, 4);
  layout->addWidget(search_);
  layout->addWidget(tree_, 1);
}

void PlotsView::createLegend() {
  legend_ = new QTreeView(this);
  styleTree(*legend_);
  describe(*legend_, {"plotsLegend", tr("Curves"), {}});
  legend_->setModel(&curves_);
  legend_->setRootIsDecorated(false);
  legend_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  new ColumnFit(*legend_, {ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kNumber});
  legend_->setTextElideMode(Qt::ElideMiddle);
}

void PlotsView::createStatistics() {
  statistics_ = new QTreeView(this);
  styleTree(*statistics_);
  describe(*statistics_, {"plotsStatistics", tr("Between the cursors"), {}});
  statistics_->setModel(&between_);
  statistics_->setRootIsDecorated(false);
  std::vector<ColumnKind> columns(CursorModel::kColumns, ColumnKind::kNumber);
  columns.front() = ColumnKind::kName;
  new ColumnFit(*statistics_, std::move(columns));
  statistics_->setTextElideMode(Qt::ElideMiddle);
  statistics_->hide();
}

void PlotsView::createViews() {
  canvas_ = new PlotCanvas(curves_, this);
  hint_ = new EmptyHint(canvas_);
  window_ = new QComboBox(this);
  describe(*window_,
           {"plotsWindow", tr("Time window"), tr("What is shown while following: the last seconds, or all")});
  for (const int seconds : kWindows) window_->addItem(tr("%1 s").arg(seconds), seconds);
  window_->addItem(tr("all"), 0);
  window_->setCurrentIndex(window_->findData(kUsualWindow));
  state_ = new QLabel(this);
  describe(*state_, {"plotsState", tr("State of the plots"), {}});
  auto* top = new QHBoxLayout;
  auto* showTree = makeButton(this, showTree_);
  showTree->setToolButtonStyle(Qt::ToolButtonTextOnly);
  top->addWidget(showTree);
  for (QAction* action : {add_, remove_, right_}) top->addWidget(makeButton(this, action));
  top->addWidget(makeMenuButton(
      this, {"plotsCompute", tr("Compute"), tr("Adds what is computed of the selected curves")},
      createFilterMenu()));
  top->addSpacing(8);
  top->addWidget(window_);
  for (QAction* action : {follow_, pause_, fit_, undo_, redo_, link_, cursors_, wholeLog_})
    top->addWidget(makeButton(this, action));
  top->addWidget(state_, 1);
  for (QAction* action : {copy_, csv_, png_, svg_}) top->addWidget(makeButton(this, action));
  auto* right =
      makeSplitter(this, "plotsLegendSplitter", Qt::Vertical, {{canvas_, 4}, {legend_, 1}, {statistics_, 1}});
  right->setSizes({400, 100, 100});
  splitter_ = makeSplitter(this, "plotsSplitter", Qt::Horizontal, {{treePanel_, 1}, {right, 3}});
  splitter_->setSizes({260, 640});
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addLayout(top);
  layout->addWidget(splitter_, 1);
}

void PlotsView::connectSignals() {
  connect(showTree_, &QAction::toggled, treePanel_, &QWidget::setVisible);
  connect(add_, &QAction::triggered, this, &PlotsView::addSelected);
  connect(tree_, &QTreeView::activated, this, &PlotsView::addSelected);
  connect(remove_, &QAction::triggered, this, &PlotsView::removeSelected);
  connect(fit_, &QAction::triggered, this, [this] {
    follow_->setChecked(false);
    canvas_->fit();
  });
  connect(follow_, &QAction::toggled, this, [this] { dirty_ = true; });
  connect(wholeLog_, &QAction::toggled, this, [this] { logsVersion_ = 0; });
  connect(window_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    follow_->setChecked(true);
    dirty_ = true;
  });
  connect(undo_, &QAction::triggered, canvas_, &PlotCanvas::undo);
  connect(redo_, &QAction::triggered, canvas_, &PlotCanvas::redo);
  connect(right_, &QAction::triggered, this, &PlotsView::changeAxis);
  connect(copy_, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setPixmap(canvas_->picture()); });
  TimeLink& link = TimeLink::of(openLogs(context()));
  connect(canvas_, &PlotCanvas::timesTouched, this, [this, &link](double from, double to) {
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
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->setFilterFixedString(text);
    if (!text.isEmpty()) tree_->expandAll();
  });
  connect(csv_, &QAction::triggered, this,
          [this] { exportAs(tr("Export the points as CSV"), QStringLiteral("csv")); });
  connect(png_, &QAction::triggered, this,
          [this] { exportAs(tr("Export the picture"), QStringLiteral("png")); });
  connect(svg_, &QAction::triggered, this,
          [this] { exportAs(tr("Export the drawing"), QStringLiteral("svg")); });
}

void PlotsView::addSelected() {
  const QModelIndexList rows = tree_->selectionModel()->selectedRows();
  for (const QModelIndex& row : rows) {
    const QString source = row.data(PlotTreeModel::kSourceRole).toString();
    if (!source.isEmpty()) addCurve(source);
  }
}

bool PlotsView::addCurve(const QString& source) {
  if (!curves_.add(PlotSource::fromText(source))) return false;
  curves_.update(session().store());
  requestMissing();
  logsVersion_ = 0;
  dirty_ = true;
  return true;
}

bool PlotsView::removeCurve(const QString& source) {
  const auto row = curves().indexOf(source);
  if (row < 0) return false;
  curves_.remove(row);
  dirty_ = true;
  return true;
}

void PlotsView::clear() {
  curves_.clear();
  dirty_ = true;
}

QStringList PlotsView::curves() const {
  QStringList texts;
  for (const auto& curve : curves_.curves()) texts << curve->source().text();
  return texts;
}

QStringList PlotsView::sources() const {
  QStringList texts;
  for (const PlotSource& source : plotSources(session().store())) texts << source.text();
  return texts;
}

std::vector<CurveModel::Curve*> PlotsView::selectedCurves() {
  std::vector<CurveModel::Curve*> selected;
  for (const QModelIndex& row : legend_->selectionModel()->selectedRows())
    selected.push_back(curves_.curves()[static_cast<std::size_t>(row.row())].get());
  return selected;
}

QMenu* PlotsView::createFilterMenu() {
  auto* menu = new QMenu(this);
  for (const auto& kind : robotlink::PointFilter::kinds()) {
    const QString name = QCoreApplication::translate("PointFilter", kind.name);
    QAction* action = menu->addAction(kind.number == nullptr ? name : tr("%1…").arg(name));
    action->setObjectName(QStringLiteral("plotsCompute-") + QLatin1String(kind.name));
    connect(action, &QAction::triggered, this, [this, &kind] { addFiltered(kind); });
  }
  return menu;
}

void PlotsView::addFiltered(const robotlink::PointFilter::Kind& kind) {
  const auto selected = selectedCurves();
  if (selected.empty()) {
    state_->setText(tr("Select a curve below the plot first."));
    return;
  }
  QString step = QLatin1String(kind.name);
  if (kind.number != nullptr) {
    bool isChosen = false;
    constexpr double kMost = 1e9;
    constexpr int kDecimals = 4;
    const double number = QInputDialog::getDouble(this, QCoreApplication::translate("PointFilter", kind.name),
                                                  QCoreApplication::translate("PointFilter", kind.number),
                                                  kind.usual, -kMost, kMost, kDecimals, &isChosen);
    if (!isChosen) return;
    step += QLatin1Char(' ') + QString::number(number, 'g', 12);
  }
  for (const CurveModel::Curve* curve : selected) {
    const QString text = curve->source().text() + QStringLiteral(" | ") + step;
    if (!addCurve(text)) state_->setText(tr("%1 cannot be added.").arg(text));
  }
}

void PlotsView::changeAxis() {
  const auto selected = selectedCurves();
  const bool isRight = std::ranges::all_of(selected, &CurveModel::Curve::isRight);
  for (CurveModel::Curve* curve : selected) curve->isRight = !isRight;
  dirty_ = true;
}

void PlotsView::setCursors(const CursorModel::Cursors& cursors) {
  cursors_->setChecked(cursors.has_value());
  between_.setCursors(cursors);
  canvas_->setCursors(cursors);
  statistics_->setVisible(cursors.has_value());
  if (cursors) state_->setText(tr("From A to B: %1 s").arg(cursors->second - cursors->first, 0, 'f', 3));
}

void PlotsView::followLink(const QObject* plot, double from, double to) {
  if (plot == this || !link_->isChecked()) return;
  follow_->setChecked(false);
  canvas_->showTimes(from, to);
}

void PlotsView::removeSelected() {
  QModelIndexList rows = legend_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end(), [](const QModelIndex& a, const QModelIndex& b) { return b < a; });
  for (const QModelIndex& row : rows) curves_.remove(row.row());
  dirty_ = true;
}

void PlotsView::requestMissing() {
  for (auto& curve : curves_.curves()) {
    if (curve->requested) continue;
    const PlotSource& source = curve->source();
    if (replayed(openLogs(context()).replay().status(), source.stream) ==
        robotcontrol::ControlReplay::AS_LOGGED)
      continue;  // it is published without a debug key
    const std::string key = keyFor(session().store(), source, session().timeline().newest());
    if (key.empty()) continue;
    curve->requested = true;
    robotcontrol::Request request;
    request.mutable_set_key()->set_name(key);
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    const QString name = QString::fromStdString(key);
    state_->setText(
        tr("Asked %1 for %2 (debug key)").arg(QString::fromStdString(robotPart(source.stream)), name));
    ask(session(), robotPart(source.stream), std::move(request), this,
        [this, name](bool accepted, const QString& reason) {
          if (!accepted) state_->setText(tr("%1 was refused: %2").arg(name, reason));
        });
  }
}

void PlotsView::followLogs() {
  OpenLogs& logs = openLogs(context());
  LoggedCurves& logged = LoggedCurves::of(logs);
  logged.tick();
  findChild<QToolButton*>(QStringLiteral("plotsWholeLog"))->setVisible(!logs.logs().empty());
  const bool isOther = logsVersion_ != logs.version();
  for (auto& curve : curves_.curves()) {
    if (isOther) curve->logged = wholeLog_->isChecked() ? logged.curve(curve->source()) : nullptr;
    const bool isRecomputed =
        replayed(logs.replay().status(), curve->source().stream) == robotcontrol::ControlReplay::RECOMPUTED;
    dirty_ = dirty_ || isOther || curve->isRecomputed != isRecomputed;
    curve->isRecomputed = isRecomputed;
  }
  if (isOther) showBookmarks(logs);
  logsVersion_ = logs.version();
  const QString text = logged.stateText();
  if (text == readingText_) return;
  readingText_ = text;
  state_->setText(text);
}

void PlotsView::showBookmarks(const OpenLogs& logs) {
  std::vector<PlotMarker> markers;
  for (const auto& log : logs.logs()) {
    if (!log->bookmarks) continue;
    for (const logplayer::Bookmark& bookmark : log->bookmarks->all()) {
      markers.push_back({robotlink::seconds(bookmark.from + log->offset),
                         robotlink::seconds(bookmark.to + log->offset),
                         QString::fromStdString(bookmark.text)});
    }
  }
  canvas_->setMarkers(std::move(markers));
}

void PlotsView::listSources() {
  if (listVersion_ == session().store().listVersion()) return;
  listVersion_ = session().store().listVersion();
  sources_.setSources(plotSources(session().store()),
                      [this](const PlotSource& source) { return jointOf(source); });
  tree_->expandToDepth(search_->text().isEmpty() ? 0 : 9);
}

/// Returns "headPan" for "positions[1]" of a JointRequest; the robot's description numbers the joints.
QString PlotsView::jointOf(const PlotSource& source) const {
  constexpr std::string_view kPositions = "positions[";
  const auto robot = context().robots.find(robotPart(source.stream));
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

void PlotsView::tick() {
  listSources();
  requestMissing();
  followLogs();
  const double origin = robotlink::seconds(session().timeline().origin());
  canvas_->setOrigin(origin);
  curves_.setOrigin(origin);
  const bool empty = curves_.rowCount() == 0;
  hint_->setHint(!empty ? QString()
                 : sources_.rowCount() == 0
                     ? tr("Nothing to plot yet. Start a simulation or connect to a robot.")
                     : tr("Choose values on the left: double click, Enter or drag them here."));
  undo_->setEnabled(canvas_->history().canUndo());
  redo_->setEnabled(canvas_->history().canRedo());
  ticks_ = (ticks_ + 1) % kTicks;
  if (pause_->isChecked()) return;
  dirty_ = curves_.update(session().store()) || dirty_;
  const double time = shownTime();
  const bool live = session().timeline().live();
  dirty_ = dirty_ || (!live && time != drawnTime_);
  if (!dirty_ || ticks_ >= kDrawn) return;
  dirty_ = false;
  drawnTime_ = time;
  const bool hasFuture = std::ranges::any_of(curves_.curves(), [&](const auto& curve) {
    return curve->isLogged() && curve->times()->second > time;
  });
  canvas_->setMark(live && !hasFuture ? std::optional<double>() : time);
  const double length = window_->currentData().toInt();
  canvas_->refresh(follow_->isChecked(), followedEnd(time, length), length, session().remoteRobots());
}

}  // namespace widgets
