// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TimeLineView that looks back at live robots while they continue.
#include <QAction>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/timeline/HistoryLimits.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets {

using robotlink::Instant;

namespace {

/// The extent grows that seldom while live, in ticks: the picture need not be painted 30 times a second.
constexpr int kGrowEvery = 6;

}  // namespace

bool TimeLineView::hasHistory() const {
  const auto& store = session().store();
  return store.find(robotlink::streams::kReplay) == nullptr && store.bytes() > 0 &&
         !session().robots().empty();
}

void TimeLineView::run(const char* command, const std::vector<robotlink::CommandTable::Value>& arguments) {
  const auto done = context().commands.run(command, arguments);
  if (!done) Q_EMIT logs_.failed(QString::fromStdString(done.error().text));
}

void TimeLineView::createHistoryActions() {
  back_ = makeAction(
      this, "step-back",
      {"historyBack", tr("Frame back"), tr("Shows the frame before (Left), while the robots continue")});
  pause_ = makeToggle(
      this, "pause",
      {"historyPause", tr("Pause"),
       tr("All views show one instant, while the robots continue (Space). What you switch, tune or "
          "steer acts on the robots as they are now.")});
  on_ = makeAction(
      this, "step",
      {"historyOn", tr("Frame forward"), tr("Shows the next frame (Right), while the robots continue")});
  live_ = makeAction(this, "play", {"historyLive", tr("Live"), tr("Returns to what happens now (End)")});
  connect(back_, &QAction::triggered, this, [this] { run("timeline.step", {-1.0}); });
  connect(on_, &QAction::triggered, this, [this] { run("timeline.step", {1.0}); });
  connect(live_, &QAction::triggered, this, [this] { run("timeline.live"); });
  connect(pause_, &QAction::triggered, this,
          [this](bool on) { run(on ? "timeline.pause" : "timeline.live"); });
}

std::vector<TimeLineBand> TimeLineView::historyBands() {
  std::vector<TimeLineBand> bands;
  const auto& remote = session().remoteRobots();
  std::vector<robotlink::Stretch> kept = session().history().kept();
  // The ends move with every message; a canvas is painted again when they differ.
  kept.back().to = std::max(kept.back().from, canvas_->look().end);
  for (const std::string& robot : session().robots()) {
    TimeLineBand& band = bands.emplace_back();
    band.title = QString::fromStdString(robot);
    band.kept = kept;
    // The horizon is the beginning of time until something was dropped.
    band.inMemory = std::max(session().store().horizon(), kept.front().from);
    const HistoryStrips::Strip& strip = strips_.of(robot);
    band.hasImages = !strip.imageStream.empty();
    band.thumbnails = strip.thumbnails;
    band.said = strip.said;
    setImageAspect(band);
    if (const auto found = remote.find(robot); found != remote.end()) band.gaps = found->second.gaps;
  }
  return bands;
}

void TimeLineView::showHistory() {
  if (!hasHistory()) return canvas_->setExtent({}, {});
  strips_.tick();
  const auto& history = session().history();
  const std::uint64_t generation = session().store().generation();
  const Instant newest = session().timeline().newest(), oldest = history.kept().front().from;
  const bool isOther = earliest_.first != generation || newest < earliest_.second;
  earliest_ = {generation, isOther ? oldest : std::min(earliest_.second, oldest)};
  const bool live = session().timeline().live();
  const bool isDue = ticks_++ % kGrowEvery == 0;
  if (isOther || isDue || newest < canvas_->look().end) {
    canvas_->setExtent(earliest_.second, newest);
    if (live) canvas_->setShown(newest);
  }
  if (!live) canvas_->setShown(history.chosen());
}

void TimeLineView::showHistoryActions() {
  const bool has = hasHistory(), live = session().timeline().live();
  canvas_->setScrubsEverywhere(has);
  for (QToolButton* button : history_) button->setVisible(has);
  pause_->setChecked(!live);
  live_->setEnabled(!live);
}

void TimeLineView::pressInHistory(ReplayKey key, QKeyEvent& event) {
  const auto seekBy = [this](double seconds) {
    const auto time = session().history().chosen() + robotlink::fromSeconds(seconds);
    run("timeline.seek", {std::max(0.0, robotlink::seconds(session().timeline().sinceOrigin(time)))});
  };
  switch (key) {
    case ReplayKey::kPlayOrPause:
      return run(session().timeline().live() ? "timeline.pause" : "timeline.live");
    case ReplayKey::kFrameBack:
      return run("timeline.step", {-1.0});
    case ReplayKey::kFrameOn:
      return run("timeline.step", {1.0});
    case ReplayKey::kTenFramesBack:
      return run("timeline.step", {-10.0});
    case ReplayKey::kTenFramesOn:
      return run("timeline.step", {10.0});
    case ReplayKey::kSecondBack:
      return seekBy(-1);
    case ReplayKey::kSecondOn:
      return seekBy(1);
    case ReplayKey::kStart:
      return session().history().show(session().history().kept().front().from);
    case ReplayKey::kEnd:
      return run("timeline.live");
    case ReplayKey::kRangeStart:
      return logs_.replay().beginRangeHere();
    case ReplayKey::kRangeEnd:
      return logs_.replay().endRangeHere();
    default:
      return View::keyPressEvent(&event);
  }
}

void TimeLineView::fillHistoryMenu(QMenu& menu) {
  menu.addActions({pause_, back_, on_, live_});
  menu.addSeparator();
  addRangeEnds(menu);
  menu.addAction(clear_);
  menu.addSeparator();
  menu.addAction(tr("How much is &kept…"), this, &TimeLineView::askForLimits)
      ->setObjectName(QStringLiteral("historyLimits"));
}

void TimeLineView::askForLimits() {
  auto* dialog = new HistoryLimits(session(), this);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    run("timeline.memory", {static_cast<double>(dialog->memoryMib())});
    run("timeline.disk", {static_cast<double>(dialog->diskMib())});
  });
  dialog->open();
}

}  // namespace widgets
