// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with the curves of plots: adding, removing, computing, asking for what is not published.
#include <QAction>
#include <QCoreApplication>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTreeView>
#include <algorithm>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/Requests.h"
#include "widgets/log/MissingValues.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/plots/HistoryCurves.h"
#include "widgets/plots/LoggedCurves.h"
#include "widgets/plots/PlotCanvas.h"
#include "widgets/plots/PlotsView.h"

namespace widgets {
namespace {

/// Returns the source in a replay of a stream that is a package of a log; empty for others.
std::optional<robotcontrol::ControlReplay::PackageSource> replayed(const robotcontrol::ReplayStatus& status,
                                                                   const std::string& stream) {
  for (const auto& package : status.packages()) {
    if (package.package() == stream && package.logged()) return package.source();
  }
  return std::nullopt;
}

/// A source as an expression, as the commands that step take it.
std::string expressionOf(const PlotSource& source) {
  if (!source.expression.empty()) return source.expression;
  return source.stream + '.' + (source.field.empty() ? "value" : source.field);
}

}  // namespace

void PlotsView::addSelected() {
  const QModelIndexList rows = tree_->selectionModel()->selectedRows();
  for (const QModelIndex& row : rows) {
    const QString source = row.data(PlotTreeModel::kSourceRole).toString();
    if (source.isEmpty()) continue;
    if (const auto added = addCurve(source); !added)
      state_->setText(QString::fromStdString(added.error().text));
  }
}

robotlink::Result<PlotSource> PlotsView::sourceOf(const QString& text) const {
  PlotSource written = PlotSource::fromText(text);
  std::set<std::string> streams;
  const bool isKnown = session().store().find(written.stream) != nullptr;
  if (!isKnown || !written.across.empty()) {
    for (const PlotChoice& choice : choices()) streams.insert(choice.source.stream);
    for (const auto* stream : session().store().streams()) streams.insert(stream->path);
  }
  return completed(std::move(written), session().selectedRobot(), {streams.begin(), streams.end()},
                   session().robots());
}

int PlotsView::rowOf(const QString& text) const {
  const int row = curves().indexOf(text);
  if (row >= 0) return row;
  const auto source = sourceOf(text);
  return source ? curves().indexOf(source->text()) : -1;
}

robotlink::Result<void> PlotsView::addCurve(const QString& text) {
  const auto source = sourceOf(text);
  if (!source) return tl::unexpected(source.error());
  if (!curves_.add(*source)) {
    const std::string name = source->text().toStdString();
    return robotlink::failure("plots.add", "there is a curve of " + name + " already", {}, {name});
  }
  curves_.update(session().store());
  requestMissing();
  logsVersion_ = 0;
  dirty_ = true;
  return {};
}

void PlotsView::addExpression() {
  const QString typed = expression_->text().trimmed();
  if (typed.isEmpty()) return;
  const bool isMarked = typed.startsWith(QLatin1Char('='));
  const bool isOneValue = !PlotSource::fromText(typed).field.empty();
  const auto added = addCurve(isMarked || isOneValue ? typed : QStringLiteral("= ") + typed);
  if (added) {
    state_->setText({});
    return expression_->clear();
  }
  const int column = added.error().where.column;
  if (column > 0) expression_->setCursorPosition(column - 1);
  const QString reason = QString::fromStdString(added.error().text);
  state_->setText(column > 0 ? tr("At character %1: %2").arg(column).arg(reason) : reason);
}

bool PlotsView::removeCurve(const QString& source) {
  const int row = rowOf(source);
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
  for (const PlotChoice& choice : choices()) {
    if (choice.isPlottable) texts << choice.source.text();
  }
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
  menu->addSeparator();
  menu->addActions({across_, strip_});
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
    if (const auto added = addCurve(text); !added)
      state_->setText(QString::fromStdString(added.error().text));
  }
}

void PlotsView::changeAxis() {
  const auto selected = selectedCurves();
  const bool isRight = std::ranges::all_of(selected, &CurveModel::Curve::isRight);
  for (CurveModel::Curve* curve : selected) curve->isRight = !isRight;
  dirty_ = true;
}

bool PlotsView::setStrip(const QString& source, bool on) {
  const int row = rowOf(source);
  if (row < 0) return false;
  curves_.curves()[static_cast<std::size_t>(row)]->asStrip = on;
  dirty_ = true;
  return true;
}

void PlotsView::changeStrips() {
  const auto selected = selectedCurves();
  if (selected.empty()) return state_->setText(tr("Select a curve below the plot first."));
  const bool areStrips = std::ranges::all_of(selected, &CurveModel::Curve::isStrip);
  for (CurveModel::Curve* curve : selected) curve->asStrip = !areStrips;
  dirty_ = true;
}

void PlotsView::addAcross() {
  QModelIndexList rows = legend_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  const auto curveOf = [this](const QModelIndex& row) {
    return curves_.curves()[static_cast<std::size_t>(row.row())].get();
  };
  if (rows.size() != 2 || curveOf(rows[0])->across || curveOf(rows[1])->across)
    return state_->setText(
        tr("Select two curves below the plot first: the upper one becomes the x axis, the lower one the y "
           "axis."));
  const QString text =
      curveOf(rows[1])->source().text() + QStringLiteral(" over ") + curveOf(rows[0])->source().text();
  if (const auto added = addCurve(text); !added) state_->setText(QString::fromStdString(added.error().text));
}

void PlotsView::stepChange(const char* direction) {
  auto selected = selectedCurves();
  if (selected.empty() && curves_.rowCount() == 1) selected = {curves_.curves().front().get()};
  if (selected.empty()) return state_->setText(tr("Select a curve below the plot first."));
  const auto done = context().commands.run(
      "timeline.step-change", {expressionOf(selected.front()->source()), std::string(direction)});
  if (!done) state_->setText(QString::fromStdString(done.error().text));
}

void PlotsView::askForTextMarks() {
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName(QStringLiteral("plotsMarkDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Mark texts"));
  dialog->setLabelText(
      tr("Messages that match this regular expression are marked in plots and timeline; empty: none"));
  TimeMarks& marks = TimeMarks::of(openLogs(context()));
  dialog->setTextValue(marks.pattern());
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, &marks](const QString& pattern) { state_->setText(marks.setPattern(pattern)); });
  dialog->open();
}

void PlotsView::removeSelected() {
  QModelIndexList rows = legend_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end(), [](const QModelIndex& a, const QModelIndex& b) { return b < a; });
  for (const QModelIndex& row : rows) curves_.remove(row.row());
  dirty_ = true;
}

void PlotsView::requestMissing() {
  for (auto& curve : curves_.curves()) {
    for (CurveModel::Curve* part : curve->parts()) {
      const PlotSource& source = part->reader.source();
      ports_.want(session(), portsNamedIn(source.field.empty() ? source.expression : source.field));
      for (const std::string& stream : part->reader.streams()) requestStream(*part, stream);
    }
  }
}

void PlotsView::requestStream(CurveModel::Curve& curve, const std::string& stream) {
  if (curve.requested.contains(stream)) return;
  if (replayed(openLogs(context()).replay().status(), stream) == robotcontrol::ControlReplay::AS_LOGGED)
    return;  // it is published without a debug key
  const std::string key = keyFor(session().store(), stream, session().timeline().newest());
  if (key.empty()) return;
  curve.requested.insert(stream);
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  const QString name = QString::fromStdString(key);
  state_->setText(tr("Asked %1 for %2 (debug key)")
                      .arg(QString::fromStdString(robotlink::streams::robotOf(stream)), name));
  ask(session(), robotlink::streams::robotOf(stream), std::move(request), this,
      [this, name](bool accepted, const QString& reason) {
        if (!accepted) state_->setText(tr("%1 was refused: %2").arg(name, reason));
      });
}

void PlotsView::followLogs() {
  OpenLogs& logs = openLogs(context());
  LoggedCurves& logged = LoggedCurves::of(logs);
  logged.tick();
  showWholeLogButton(!logs.logs().empty());
  const bool isOther = logsVersion_ != logs.version();
  for (auto& curve : curves_.curves()) {
    const auto isAnew = [&](const std::string& stream) {
      return replayed(logs.replay().status(), stream) == robotcontrol::ControlReplay::RECOMPUTED;
    };
    for (CurveModel::Curve* part : curve->parts()) {
      if (isOther) part->logged = wholeLog_->isChecked() ? logged.curve(part->source()) : nullptr;
      const bool isRecomputed = std::ranges::any_of(part->reader.streams(), isAnew);
      dirty_ = dirty_ || isOther || part->isRecomputed != isRecomputed;
      part->isRecomputed = isRecomputed;
    }
  }
  if (isOther) showBookmarks(logs);
  logsVersion_ = logs.version();
  followHistory();
  const QString ofLogs = logged.stateText();
  const QString text = ofLogs.isEmpty() ? HistoryCurves::of(logs).stateText() : ofLogs;
  if (text == readingText_) return;
  readingText_ = text;
  state_->setText(text);
}

void PlotsView::followHistory() {
  HistoryCurves& history = HistoryCurves::of(openLogs(context()));
  history.tick(session());
  for (const auto& curve : curves_.curves()) {
    for (CurveModel::Curve* part : curve->parts()) {
      PastValues& past = part->past;
      if (!past.isWanted()) continue;
      const std::pair begin(*past.begin(), *past.begin());
      const bool isOnDisk = !missingValues(session(), part->reader.streams(), begin, past.unread()).empty();
      isOnDisk ? past.read(history.curve(part->source())) : past.skip();
    }
  }
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

}  // namespace widgets
