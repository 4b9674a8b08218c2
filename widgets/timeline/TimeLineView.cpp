// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TimeLineView that shows logs and connects controls. TimeLineJobs.cpp has the actions on ranges
// and files, TimeLineHistory.cpp what concerns live robots.
#include "widgets/timeline/TimeLineView.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QJsonArray>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <filesystem>
#include <utility>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/ShownText.h"
#include "widgets/log/LogBars.h"
#include "widgets/log/ReplayKeys.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/timeline/TimeLineCanvas.h"

namespace widgets {

using robotlink::Instant;

namespace {

const ViewRegistration kTimeLineViewRegistration{
    {"time-line", QT_TRANSLATE_NOOP("View", "Timeline"),
     QT_TRANSLATE_NOOP("View",
                       "Shows logs over time: images, messages, warnings, bookmarks; lets you jump, select, "
                       "cut and export. Of live robots, lets you look back while they continue."),
     "time-line", false, create<TimeLineView>}};

QString withKey(const QString& text, ReplayKey key) {
  return QStringLiteral("%1 (%2)").arg(text, keySequence(key).toString(QKeySequence::NativeText));
}

}  // namespace

void TimeLineView::setImageAspect(TimeLineBand& band) {
  for (const auto& [time, image] : band.thumbnails) {
    if (image.isNull()) continue;
    band.imageAspect = static_cast<double>(image.width()) / image.height();
    return;
  }
}

TimeLineView::TimeLineView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      logs_(openLogs(context)),
      tracks_(context.session, logs_),
      strips_(context.session) {
  setObjectName(QStringLiteral("timeLineView"));
  createActions();
  createHistoryActions();
  createRangeActions();
  createSteps();
  createViews();
  connectSignals();
  connectBookmarks();
  keep("follow", follow_);
  keep(
      "tracks", [this] { return QJsonValue(QJsonArray::fromStringList(tracks_.sources())); },
      [this](const QJsonValue& saved) { tracks_.setSources(saved.toVariant().toStringList()); },
      Names::kObjects);
  tick();
}

void TimeLineView::createActions() {
  bookmark_ =
      makeAction(this, "bookmark",
                 {"timeLineBookmark", tr("Bookmark"),
                  withKey(tr("Adds a bookmark at this moment, and lets you name it"), ReplayKey::kBookmark)});
  undo_ = makeAction(
      this, "undo",
      {"timeLineUndo", tr("Undo"), tr("Undoes the last change of the bookmarks"), QKeySequence::Undo});
  redo_ = makeAction(this, "redo",
                     {"timeLineRedo", tr("Redo"), tr("Redoes what was undone"), QKeySequence::Redo});
  zoomOut_ =
      makeAction(this, "zoom-out",
                 {"timeLineZoomOut", tr("Zoom out"), tr("Shows more time (also: wheel)"), Qt::Key_Minus});
  zoomIn_ = makeAction(
      this, "zoom-in",
      {"timeLineZoomIn", tr("Zoom in"), tr("Shows less time, larger (also: the wheel)"), Qt::Key_Plus});
  fit_ = makeAction(this, "fit", {"timeLineFit", tr("Fit"), tr("Shows all of the logs"), Qt::Key_F});
  follow_ =
      makeToggle(this, "follow", {"timeLineFollow", tr("Follow"), tr("Keeps the playhead in view")}, true);
}

void TimeLineView::createRangeActions() {
  loop_ = makeAction(this, "loop", {"rangeLoop", tr("Loop"), tr("Plays the selected range in a loop")});
  cut_ = makeAction(this, "cut", {"rangeCut", tr("Cut…"), tr("Writes the selected range into a new log")});
  export_ = makeAction(
      this, "export",
      {"rangeExport", tr("Export"),
       tr("Writes the selected range, or all, as images, a table, texts, a log of some streams, or a "
          "video of a view")});
  clear_ = makeAction(this, "clear", {"rangeClear", tr("Clear range"), tr("Clears the selection (Esc)")});
  exportMenu_ = new QMenu(this);
  exportMenu_->setObjectName(QStringLiteral("exportMenu"));
  exportMenu_->setToolTipsVisible(true);
  const auto add = [this](const QString& text, const char* name, void (TimeLineView::*act)()) {
    logExports_.push_back(exportMenu_->addAction(text, this, act));
    logExports_.back()->setObjectName(QLatin1String(name));
  };
  add(tr("Images as &PNG…"), "exportImages", &TimeLineView::exportImages);
  add(tr("The stepped stream as &CSV…"), "exportTable", &TimeLineView::exportTable);
  add(tr("&Texts…"), "exportTexts", &TimeLineView::exportTexts);
  add(tr("Some &streams as a new log…"), "exportStreams", &TimeLineView::cutStreams);
  QAction* view = exportMenu_->addAction(tr("A &view as video or images…"), this, &View::exportWanted);
  view->setObjectName(QStringLiteral("exportView"));
  view->setToolTip(tr("Writes what an open view shows in the selected range"));
  export_->setMenu(exportMenu_);
}

QWidget* TimeLineView::createBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(4, 2, 4, 2);
  layout->setSpacing(2);
  for (QAction* action : {back_, pause_, on_}) history_.push_back(makeButton(bar, action));
  history_.push_back(makeLabeledButton(bar, live_));
  for (QToolButton* button : history_) layout->addWidget(button);
  for (QAction* action : {bookmark_, undo_, redo_}) layout->addWidget(makeButton(bar, action));
  layout->addSpacing(10);
  for (QAction* action : {zoomOut_, zoomIn_, fit_, follow_}) layout->addWidget(makeButton(bar, action));
  layout->addSpacing(10);
  images_ = new QComboBox(bar);
  describe(*images_, {"timeLineImages", tr("Images"), tr("Whose images are shown")});
  images_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  layout->addWidget(images_);
  layout->addWidget(stepBy_);
  for (QAction* action : {changeBack_, changeOn_}) layout->addWidget(makeButton(bar, action));
  layout->addStretch(1);
  range_ = new QLabel(bar);
  range_->setObjectName(QStringLiteral("rangeText"));
  layout->addWidget(range_);
  layout->addSpacing(4);
  for (QAction* action : {loop_, cut_, export_, clear_}) {
    auto* button = makeButton(bar, action);
    button->setPopupMode(QToolButton::InstantPopup);
    layout->addWidget(button);
  }
  return bar;
}

void TimeLineView::createViews() {
  canvas_ = new TimeLineCanvas(this);
  hint_ = new EmptyHint(canvas_->viewport());
  job_ = new LogJobBar(this);
  damage_ = new LogDamageBar(this);
  auto* layout = makeColumn(this);
  layout->addWidget(createBar());
  layout->addWidget(damage_);
  layout->addWidget(job_);
  layout->addWidget(canvas_, 1);
  setFocusProxy(canvas_);
}

void TimeLineView::connectSignals() {
  auto& replay = logs_.replay();
  connect(zoomIn_, &QAction::triggered, canvas_, [this] { canvas_->zoom(1.25); });
  connect(zoomOut_, &QAction::triggered, canvas_, [this] { canvas_->zoom(1 / 1.25); });
  connect(fit_, &QAction::triggered, canvas_, &TimeLineCanvas::fit);
  connect(follow_, &QAction::toggled, canvas_, &TimeLineCanvas::setFollow);
  connect(loop_, &QAction::triggered, this, &TimeLineView::loopRange);
  connect(cut_, &QAction::triggered, this, &TimeLineView::cut);
  connect(clear_, &QAction::triggered, this, [&replay] { replay.clearRange(); });
  connect(canvas_, &TimeLineCanvas::jumpWanted, this, [this, &replay](Instant time) {
    replay.open() ? replay.jumpTo(time) : session().history().show(time);
  });
  connect(canvas_, &TimeLineCanvas::rangeWanted, this,
          [&replay](Instant from, Instant to) { replay.setRange(from, to); });
  connect(canvas_, &TimeLineCanvas::rangeDropped, this, [&replay] { replay.clearRange(); });
  connect(canvas_, &TimeLineCanvas::streamChosen, this, &TimeLineView::chooseStream);
  connect(canvas_, &TimeLineCanvas::offsetWanted, this, [this](int band, robotlink::Duration offset) {
    if (const auto* log = logAt(band)) logs_.replay().setOffset(log->path, offset);
  });
  connect(canvas_, &TimeLineCanvas::collapseWanted, this, [this](int band, bool collapsed) {
    if (auto* log = logAt(band)) logs_.setCollapsed(*log, collapsed);
    showBands();
  });
  connect(canvas_, &TimeLineCanvas::tracksDropped, this, [this](const QStringList& sources) {
    for (const QString& source : sources) {
      if (const auto added = addTrack(source); !added)
        Q_EMIT logs_.failed(QString::fromStdString(added.error().text));
    }
  });
  connect(canvas_, &TimeLineCanvas::looked, this, &TimeLineView::wantThumbnails);
  connect(images_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    const std::string stream = images_->itemText(index).toStdString();
    for (const auto& log : logs_.logs()) {
      if (log->overview->find(stream) != nullptr) logs_.setImageStream(*log, stream);
    }
  });
  connect(damage_, &LogDamageBar::repairWanted, this, &TimeLineView::repair);
  connect(job_, &LogJobBar::openWanted, this, [this](const QString& file) {
    const auto done = context().commands.run("log.open", {file.toStdString()});
    if (!done) Q_EMIT logs_.failed(QString::fromStdString(done.error().describe()));
  });
}

void TimeLineView::connectBookmarks() {
  connect(bookmark_, &QAction::triggered, this, [this] {
    const auto* log = logs_.current();
    for (int band = 0; band < static_cast<int>(logs_.logs().size()); ++band) {
      if (logAt(band) == log) addBookmark(band, logs_.replay().shown());
    }
  });
  connect(undo_, &QAction::triggered, &logs_.undoStack(), &QUndoStack::undo);
  connect(redo_, &QAction::triggered, &logs_.undoStack(), &QUndoStack::redo);
  connect(canvas_, &TimeLineCanvas::bookmarkWanted, this, &TimeLineView::addBookmark);
  connect(canvas_, &TimeLineCanvas::bookmarkChanged, this,
          [this](int band, const logplayer::Bookmark& bookmark) {
            if (auto* log = logAt(band)) logs_.changeBookmark(*log, bookmark);
            showBands();
          });
  connect(canvas_, &TimeLineCanvas::bookmarkDropped, this, [this](int band, std::uint64_t id) {
    if (auto* log = logAt(band)) logs_.removeBookmark(*log, id);
    canvas_->chooseBookmark(-1, 0);
    showBands();
  });
}

OpenLogs::Log* TimeLineView::logAt(int band) {
  const auto& logs = logs_.logs();
  return band >= 0 && band < static_cast<int>(logs.size()) ? logs[static_cast<std::size_t>(band)].get()
                                                           : nullptr;
}

void TimeLineView::chooseStream(int band, const std::string& path) {
  if (const auto* log = logAt(band)) logs_.replay().setSteppedStream(OpenLogs::sessionPath(*log, path));
}

void TimeLineView::showSteppedStream() {
  const std::string& stepped = logs_.replay().steppedStream();
  for (int band = 0; band < static_cast<int>(logs_.logs().size()); ++band) {
    const auto* log = logAt(band);
    for (const auto& stream : log->overview->streams) {
      if (OpenLogs::sessionPath(*log, stream.path) == stepped)
        return canvas_->setSteppedStream(band, stream.path);
    }
  }
  canvas_->setSteppedStream(-1, {});
}

void TimeLineView::addBookmark(int band, Instant time) {
  OpenLogs::Log* log = logAt(band);
  if (log == nullptr || !log->bookmarks) return;
  const Instant own = time - log->offset;
  const auto range = logs_.replay().range();
  const bool whole = range && range->first <= time && range->second >= time && range->first == time;
  const auto id = logs_.addBookmark(*log, own, whole ? range->second - log->offset : own,
                                    tr("Bookmark %1").arg(log->bookmarks->all().size() + 1));
  showBands();
  canvas_->chooseBookmark(band, id);
  canvas_->editBookmark(band, id);
}

std::optional<QString> TimeLineView::numbers() {
  TabTable table(
      {QStringLiteral("log"), QStringLiteral("time s"), QStringLiteral("what"), QStringLiteral("value")});
  const TimeLineLook& look = canvas_->look();
  const auto add = [&](const QString& log, robotlink::Duration time, const QString& what,
                       const QString& value) {
    table.add({log, QString::number(robotlink::seconds(time), 'f', 6), what, value});
  };
  for (const TimeLineBand& band : canvas_->bands()) {
    const auto since = [&](robotlink::Instant time) { return time + band.offset - look.origin; };
    for (const logplayer::Bookmark& mark : band.bookmarks)
      add(band.title, since(mark.from), QStringLiteral("bookmark"), QString::fromStdString(mark.text));
    if (const auto* said = saidOf(band)) {
      for (const LogEntry& entry : *said)
        add(band.title, since(entry.time), entry.robot + QLatin1Char('/') + entry.source, entry.text);
    }
    const double from = robotlink::seconds(look.scale.from),
                 to = robotlink::seconds(look.scale.time(look.size.width()));
    for (const TimeLineTrack& track : band.tracks) {
      if (track.series == nullptr) continue;
      for (std::size_t i = track.series->firstFrom(from); i < track.series->firstAfter(to); ++i) {
        const auto [time, value] = (*track.series)[i];
        add(band.title, robotlink::Instant(robotlink::fromSeconds(time)) - look.origin, track.source,
            QString::number(value, 'g', 9));
      }
    }
  }
  return table.text();
}

void TimeLineView::tickHidden() {
  TimeMarks::of(logs_).tick(session());
  tracks_.tick(false);
}

void TimeLineView::tick() {
  job_->tick();
  const bool open = logs_.replay().open();
  hint_->setHint(
      open || hasHistory()
          ? QString()
          : tr("Nothing is open.\nStart a simulation, connect to a robot, or open a log with File > "
               "Open log…"));
  canvas_->setOrigin(session().timeline().origin());
  if (open) {
    canvas_->setExtent(logs_.replay().begin(), logs_.replay().end());
    canvas_->setShown(logs_.replay().shown());
  } else {
    showHistory();
  }
  tracks_.tick(std::exchange(isShownAnew_, false));
  showBands();
  showMarks();
  showHistoryActions();
  canvas_->setRange(logs_.replay().range());
  showSteppedStream();
  showRange();
  showImageStreams();
  showDamage();
  wantThumbnails();
  undo_->setEnabled(logs_.undoStack().canUndo());
  redo_->setEnabled(logs_.undoStack().canRedo());
  const auto* current = logs_.current();
  bookmark_->setEnabled(current != nullptr && current->bookmarks.has_value());
  for (QAction* action : {zoomIn_, zoomOut_, fit_, changeBack_, changeOn_})
    action->setEnabled(open || hasHistory());
}

void TimeLineView::showBands() {
  std::vector<TimeLineBand> bands;
  for (const auto& log : logs_.logs()) {
    TimeLineBand band;
    band.title = QString::fromStdString(std::filesystem::path(log->path).filename().string());
    band.offset = log->offset;
    band.showsOffset = logs_.logs().size() > 1;
    band.collapsed = log->collapsed;
    band.log = log->overview;
    if (log->bookmarks) band.bookmarks = log->bookmarks->all();
    band.hasImages = !log->imageStream.empty();
    band.thumbnails = log->thumbnails;
    setImageAspect(band);
    for (const auto& stream : log->overview->streams) {
      if (!log->hidden.contains(stream.path)) band.streams.push_back(stream.path);
    }
    bands.push_back(std::move(band));
  }
  if (bands.empty() && hasHistory()) bands = historyBands();
  if (auto tracks = tracks_.shown(); !bands.empty() && !tracks.empty()) {
    TimeLineBand band;
    band.title = tr("values");
    band.tracks = std::move(tracks);
    bands.push_back(std::move(band));
  }
  canvas_->setBands(std::move(bands));
}

void TimeLineView::showRange() {
  const auto range = logs_.replay().range();
  const QString text =
      !range ? QString()
             : tr("%1 – %2 s (%3 s)")
                   .arg(logs_.replay().shownText(range->first), logs_.replay().shownText(range->second),
                        timeText(range->second - range->first));
  if (range_->text() != text) range_->setText(text);
  const bool open = logs_.replay().open(), free = open && !job_->busy();
  clear_->setEnabled(range.has_value());
  loop_->setEnabled(open && range.has_value());
  cut_->setEnabled(free && range.has_value());
  export_->setEnabled(free || hasHistory());
  for (QAction* action : logExports_) action->setEnabled(free);
  damage_->setBusy(job_->busy());
}

void TimeLineView::showImageStreams() {
  if (shownVersion_ == logs_.version()) return;
  shownVersion_ = logs_.version();
  QStringList streams;
  QString chosen;
  for (const auto& log : logs_.logs()) {
    for (const std::string& stream : log->overview->imageStreams()) streams << QString::fromStdString(stream);
    if (chosen.isEmpty()) chosen = QString::fromStdString(log->imageStream);
  }
  images_->clear();
  images_->addItems(streams);
  images_->setCurrentText(chosen);
  images_->setVisible(streams.size() > static_cast<int>(logs_.logs().size()));
}

void TimeLineView::showDamage() {
  std::vector<LogDamageBar::Damage> damages;
  for (const auto& log : logs_.logs()) {
    const QString& failure = log->overview->failure;
    QString text = failure.isEmpty() ? log->overview->damage : failure;
    for (const auto& played : logs_.replay().status().logs()) {
      // Problems during the replay are newer than those found when the log was opened.
      if (failure.isEmpty() && played.path() == log->path && !played.damage().empty())
        text = QString::fromStdString(played.damage());
    }
    if (!text.isEmpty()) damages.push_back({log->path, text, failure.isEmpty() && !log->overview->converted});
  }
  damage_->setDamages(std::move(damages));
}

void TimeLineView::wantThumbnails() {
  const int height = static_cast<int>(thumbnailHeight() * devicePixelRatioF());
  for (int band = 0; band < static_cast<int>(canvas_->bands().size()); ++band) {
    auto* log = logAt(band);
    if (log != nullptr && !log->imageStream.empty())
      logs_.wantThumbnails(*log, canvas_->missingThumbnails(band), height);
  }
  if (!logs_.logs().empty() || !hasHistory()) return;
  int band = 0;
  for (const std::string& robot : session().robots()) {
    if (band < static_cast<int>(canvas_->bands().size()))
      strips_.want(robot, canvas_->missingThumbnails(band++), height);
  }
}

void TimeLineView::showEvent(QShowEvent* event) {
  ticks_ = 0;
  isShownAnew_ = true;
  View::showEvent(event);
}

void TimeLineView::keyPressEvent(QKeyEvent* event) {
  const auto key = replayKey(*event);
  if (key && hasHistory()) return pressInHistory(*key, *event);
  if (!key || !logs_.replay().open()) return View::keyPressEvent(event);
  if (*key == ReplayKey::kBookmark) {
    bookmark_->trigger();
  } else {
    press(*key, logs_.replay());
  }
}

bool TimeLineView::removeTrack(const QString& source) {
  const int before = tracks_.sources().size();
  tracks_.remove(source);
  showBands();
  return tracks_.sources().size() < before;
}

void TimeLineView::addTrackEntry(QMenu& menu, const QPoint& at) {
  const TimeLineLayout all = canvas_->layout();
  const auto* lane = all.laneAt(at);
  if (lane == nullptr || lane->kind != TimeLineLayout::Kind::kTrack) return;
  const QString source = QString::fromStdString(lane->stream);
  menu.addAction(tr("&Remove the curve of %1").arg(source), this, [this, source] { removeTrack(source); })
      ->setObjectName(QStringLiteral("removeTrack"));
  menu.addSeparator();
}

void TimeLineView::addRangeEnds(QMenu& menu) {
  auto& replay = logs_.replay();
  menu.addAction(withKey(tr("Start range here"), ReplayKey::kRangeStart), this,
                 [&replay] { replay.beginRangeHere(); });
  menu.addAction(withKey(tr("End range here"), ReplayKey::kRangeEnd), this,
                 [&replay] { replay.endRangeHere(); });
}

void TimeLineView::contextMenuEvent(QContextMenuEvent* event) {
  if (!logs_.replay().open() && !hasHistory()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setObjectName(QStringLiteral("timeLineMenu"));
  const QPoint at = canvas_->viewport()->mapFromGlobal(event->globalPos());
  addTrackEntry(*menu, at);
  if (hasHistory()) {
    fillHistoryMenu(*menu);
    return menu->popup(event->globalPos());
  }
  const TimeLineLayout all = canvas_->layout();
  const auto* stream = all.laneAt(at);
  menu->addAction(bookmark_);
  addRangeEnds(*menu);
  menu->addActions({loop_, cut_, clear_});
  if (stream != nullptr && stream->kind == TimeLineLayout::Kind::kStream) {
    const QString name = QString::fromStdString(stream->stream);
    menu->addSeparator();
    menu->addAction(tr("Step messages of %1").arg(name), this,
                    [this, band = stream->band, path = stream->stream] { chooseStream(band, path); });
    menu->addAction(tr("Hide %1").arg(name), this, [this, band = stream->band, path = stream->stream] {
      if (auto* log = logAt(band)) logs_.setHidden(*log, path, true);
    });
  }
  if (stream != nullptr) addAligning(*menu, stream->band, canvas_->snappedTimeAt(at));
  menu->popup(event->globalPos());
}

}  // namespace widgets
