// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/LogToolBar.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <cmath>

#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/bars/SimulationToolBar.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/log/TimeScale.h"

namespace app {

using widgets::ReplayKey;

LogToolBar::LogToolBar(CommandActions& actions, widgets::OpenLogs& logs, QWidget* parent)
    : QToolBar(tr("Log"), parent), actions_(actions), logs_(logs) {
  setObjectName(QStringLiteral("logToolBar"));
  createSteps();
  createLongSteps();
  createRangeActions();
  createOptions();
  createFields();
  createBar();
  connect(&logs_.replay(), &widgets::ReplayControl::steppedStreamChanged, this, &LogToolBar::refreshTips);
  refreshTips();
  refresh();
}

QAction* LogToolBar::make(const Text& text, std::function<void()> action) {
  auto* made = new QAction(widgets::icon(text.icon), text.text, this);
  made->setObjectName(QLatin1String(text.name));
  made->setToolTip(text.tip);
  made->setStatusTip(text.tip);
  connect(made, &QAction::triggered, this, [action = std::move(action)] { action(); });
  return made;
}

QAction* LogToolBar::make(ReplayKey key, const Text& text, std::function<void()> action) {
  QAction* made = make(text, std::move(action));
  const QKeySequence keys = widgets::keySequence(key);
  made->setToolTip(QStringLiteral("%1 (%2)").arg(text.tip, keys.toString(QKeySequence::NativeText)));
  // The shortcut is only displayed, in menus and in the list of shortcuts. The key is handled by WindowKeys
  // or press(), so that it is not taken from other widgets.
  made->setShortcut(keys);
  made->setShortcutContext(Qt::WidgetShortcut);
  keyed_[key] = made;
  return made;
}

void LogToolBar::createSteps() {
  const auto run = [this](const char* command, Values values = {}) {
    return [this, command, values] { actions_.run(QLatin1String(command), values); };
  };
  make(ReplayKey::kPlayOrPause, {"log.playOrPause", "play", tr("Play"), tr("Plays the log, or pauses it")},
       [this] {
         actions_.run(logs_.replay().status().playing() ? QStringLiteral("log.pause")
                                                        : QStringLiteral("log.play"));
       });
  stop_ = make({"log.stop", "halt", tr("Stop"), tr("Pauses at the start of the log")}, run("log.stop"));
  make(ReplayKey::kFrameBack,
       {"log.frameBack", "step-back", tr("Frame back"), tr("Back one frame of the process")},
       run("log.step", {-1.0}));
  make(ReplayKey::kFrameOn,
       {"log.frameOn", "step", tr("Frame forward"), tr("Forward one frame of the process")},
       run("log.step", {1.0}));
  const auto message = [this](double count) {
    return [this, count] {
      actions_.run(QStringLiteral("log.step-message"), {logs_.replay().steppedStream(), count});
    };
  };
  make(ReplayKey::kMessageBack, {"log.messageBack", "message-back", tr("Message back"), {}}, message(-1));
  make(ReplayKey::kMessageOn, {"log.messageOn", "message-on", tr("Message forward"), {}}, message(1));
}

void LogToolBar::createLongSteps() {
  auto& replay = logs_.replay();
  const auto frames = [this](double count) {
    return [this, count] { actions_.run(QStringLiteral("log.step"), {count}); };
  };
  const auto key = [&replay](ReplayKey what) { return [&replay, what] { widgets::press(what, replay); }; };
  make(ReplayKey::kTenFramesBack,
       {"log.tenFramesBack", "step-back", tr("10 frames back"), tr("Back ten frames of the process")},
       frames(-10));
  make(ReplayKey::kTenFramesOn,
       {"log.tenFramesOn", "step", tr("10 frames forward"), tr("Forward ten frames of the process")},
       frames(10));
  make(ReplayKey::kSecondBack, {"log.secondBack", "step-back", tr("1 s back"), tr("Back one second")},
       key(ReplayKey::kSecondBack));
  make(ReplayKey::kSecondOn, {"log.secondOn", "step", tr("1 s forward"), tr("Forward one second")},
       key(ReplayKey::kSecondOn));
  make(ReplayKey::kStart,
       {"log.toStart", "step-back", tr("To the start"), tr("Jumps to the start of the log")},
       key(ReplayKey::kStart));
  make(ReplayKey::kEnd, {"log.toEnd", "step", tr("To the end"), tr("Jumps to the end of the log")},
       key(ReplayKey::kEnd));
}

void LogToolBar::createRangeActions() {
  auto& replay = logs_.replay();
  make(ReplayKey::kRangeStart,
       {"log.rangeStart", "grab", tr("Start range here"), tr("Selects from the shown moment")},
       [&replay] { replay.beginRangeHere(); });
  make(ReplayKey::kRangeEnd,
       {"log.rangeEnd", "grab", tr("End range here"), tr("Selects up to the shown moment")},
       [&replay] { replay.endRangeHere(); });
  clearRange_ = make({"log.clearRange", "clear", tr("Clear range"), tr("Clears the selection")},
                     [&replay] { replay.clearRange(); });
  make(ReplayKey::kBookmark,
       {"log.bookmarkHere", "bookmark", tr("Bookmark"), tr("Adds a bookmark at the shown moment")},
       [this] { logs_.addBookmarkHere(); });
}

void LogToolBar::createOptions() {
  const auto option = [this](const Text& text, const char* command) {
    QAction* action = make(text, [] {});
    action->setCheckable(true);
    connect(action, &QAction::triggered, this,
            [this, command](bool on) { actions_.run(QLatin1String(command), {on}); });
    return action;
  };
  loop_ =
      option({"log.loop", "loop", tr("Loop"), tr("Loops the selected range, or the whole log")}, "log.loop");
  timeStamps_ =
      make({"log.timeStamps", "timing", tr("Timestamps"),
            tr("Shows the messages' own timestamps in all views, instead of times since the log's start")},
           [] {});
  timeStamps_->setCheckable(true);
  connect(timeStamps_, &QAction::toggled, this, [this](bool on) {
    logs_.replay().setShowsTimeStamps(on);
    refresh();
  });
  skipGaps_ = option(
      {"log.skipGaps", "skip-gaps", tr("Skip gaps"), tr("Skips gaps of more than a second in the log")},
      "log.skip-gaps");
}

void LogToolBar::createFields() {
  const int digit = fontMetrics().horizontalAdvance(QLatin1Char('0'));
  const auto field = [&](int digits) {
    auto* edit = new QLineEdit(this);
    edit->setAlignment(Qt::AlignRight);
    edit->setFixedWidth(digit * digits + 16);
    return edit;
  };
  time_ = field(11);
  widgets::describe(*time_, {"logTime", tr("Time in seconds"),
                             tr("The shown time in seconds. Type another one to jump there: 12.5, 1:02.5, or "
                                "+2 and -2 from here")});
  frame_ = field(7);
  widgets::describe(
      *frame_, {"logFrame", tr("Frame"), tr("The shown frame's number. Type another one to jump there")});
  end_ = new QLabel(this);
  widgets::describe(*end_, {"logEnd", tr("End of the log"), tr("The time of the log's end")});
  frames_ = new QLabel(this);
  widgets::describe(*frames_, {"logFrames", tr("Frames"),
                               tr("The shown frame, and how many frames of the process the log holds")});
  process_ = new QComboBox(this);
  widgets::describe(*process_,
                    {"logProcess", tr("Process"), tr("The process whose frames are stepped and counted")});
  process_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  speed_ = new QComboBox(this);
  widgets::describe(*speed_, {"logSpeed", tr("Speed"), tr("Playback speed, relative to real time")});
  for (const double speed : speeds()) speed_->addItem(SimulationToolBar::speedText(speed), speed);
  connect(time_, &QLineEdit::returnPressed, this, &LogToolBar::jumpToTypedTime);
  connect(frame_, &QLineEdit::returnPressed, this, &LogToolBar::jumpToTypedFrame);
  const auto activated = QOverload<int>::of(&QComboBox::activated);
  connect(process_, activated, this, [this](int index) {
    actions_.run(QStringLiteral("log.step-process"), {process_->itemText(index).toStdString()});
  });
  connect(speed_, activated, this, [this](int index) {
    actions_.run(QStringLiteral("log.speed"), {speed_->itemData(index).toDouble()});
  });
}

void LogToolBar::createBar() {
  const auto add = [this](const QString& text, std::initializer_list<QWidget*> fields) {
    auto* label = new QLabel(text, this);
    label->setMargin(4);
    addWidget(label);
    for (QWidget* widget : fields) addWidget(widget);
  };
  for (const auto key : {ReplayKey::kMessageBack, ReplayKey::kFrameBack, ReplayKey::kPlayOrPause,
                         ReplayKey::kFrameOn, ReplayKey::kMessageOn}) {
    addAction(keyed_.at(key));
  }
  addAction(stop_);
  addSeparator();
  add(tr("Time:"), {time_, end_});
  addAction(timeStamps_);
  add(tr("Frame:"), {frame_, frames_});
  add(tr("of"), {process_});
  addSeparator();
  add(tr("Speed:"), {speed_});
  addAction(loop_);
  addAction(skipGaps_);
  addSeparator();
  addAction(keyed_.at(ReplayKey::kBookmark));
}

void LogToolBar::fillMenu(QMenu& menu) {
  const auto add = [&](std::initializer_list<ReplayKey> keys) {
    for (const auto key : keys) menu.addAction(keyed_.at(key));
  };
  add({ReplayKey::kPlayOrPause});
  menu.addAction(stop_);
  menu.addSeparator();
  add({ReplayKey::kFrameBack, ReplayKey::kFrameOn, ReplayKey::kTenFramesBack, ReplayKey::kTenFramesOn,
       ReplayKey::kMessageBack, ReplayKey::kMessageOn, ReplayKey::kSecondBack, ReplayKey::kSecondOn,
       ReplayKey::kStart, ReplayKey::kEnd});
  menu.addSeparator();
  QMenu* speed = menu.addMenu(tr("S&peed"));
  for (const double value : speeds()) {
    speed->addAction(SimulationToolBar::speedText(value), this,
                     [this, value] { actions_.run(QStringLiteral("log.speed"), {value}); });
  }
  menu.addActions({loop_, skipGaps_, timeStamps_});
  menu.addSeparator();
  add({ReplayKey::kRangeStart, ReplayKey::kRangeEnd});
  menu.addAction(clearRange_);
  add({ReplayKey::kBookmark});
}

bool LogToolBar::press(const QKeyEvent& event) {
  const auto key = widgets::replayKey(event);
  if (!key || !logs_.replay().open()) return false;
  keyed_.at(*key)->trigger();
  return true;
}

void LogToolBar::jumpToTypedTime() {
  auto& replay = logs_.replay();
  const auto origin = replay.origin();
  const auto time = widgets::timeFromText(time_->text(), replay.shown() - origin);
  if (!time)
    return Q_EMIT logs_.failed(
        tr("\"%1\" is not a time; type seconds (12.5), minutes and seconds (1:02.5), or +2 and -2 from here.")
            .arg(time_->text()));
  replay.jumpTo(origin + *time);
  time_->clearFocus();
}

void LogToolBar::jumpToTypedFrame() {
  bool ok = false;
  const double frame = static_cast<double>(frame_->text().trimmed().toULongLong(&ok));
  if (!ok) return Q_EMIT logs_.failed(tr("\"%1\" is not a frame number.").arg(frame_->text()));
  actions_.run(QStringLiteral("log.jump-frame"), {frame});
  frame_->clearFocus();
}

void LogToolBar::refreshProcesses() {
  if (process_->view()->isVisible()) return;
  const auto& status = logs_.replay().status();
  QStringList names;
  for (const auto& process : status.processes()) names << QString::fromStdString(process.name());
  QStringList shown;
  for (int i = 0; i < process_->count(); ++i) shown << process_->itemText(i);
  if (names != shown) {
    process_->clear();
    process_->addItems(names);
  }
  const int chosen = names.indexOf(QString::fromStdString(status.step_process()));
  if (chosen != process_->currentIndex()) process_->setCurrentIndex(chosen);
}

void LogToolBar::refreshFields() {
  const auto& status = logs_.replay().status();
  const auto show = [](QLineEdit* edit, const QString& text) {
    if (!edit->hasFocus() && edit->text() != text) edit->setText(text);
  };
  show(time_, logs_.replay().shownText(logs_.replay().shown()));
  show(frame_, QString::number(status.frame()));
  end_->setText(tr(" / %1 s ").arg(logs_.replay().shownText(logs_.replay().end())));
  std::uint64_t frames = 0;
  for (const auto& process : status.processes()) {
    if (process.name() == status.step_process()) frames = process.frames();
  }
  frames_->setText(tr(" (%1 / %2) ").arg(status.frame_index()).arg(frames));
  if (speed_->view()->isVisible()) return;
  int index = -1;
  for (int i = 0; i < speed_->count(); ++i) {
    if (std::abs(speed_->itemData(i).toDouble() - status.speed()) < 1e-9) index = i;
  }
  if (index < 0 && status.speed() > 0) {
    speed_->addItem(SimulationToolBar::speedText(status.speed()), status.speed());
    index = speed_->count() - 1;
  }
  if (index != speed_->currentIndex()) speed_->setCurrentIndex(index);
}

void LogToolBar::refreshTips() {
  const std::string stream = logs_.replay().steppedStream();
  const QString name = stream.empty() ? tr("the chosen stream") : QString::fromStdString(stream);
  const auto tip = [this](ReplayKey key, const QString& text) {
    keyed_.at(key)->setToolTip(
        QStringLiteral("%1 (%2)").arg(text, widgets::keySequence(key).toString(QKeySequence::NativeText)));
    keyed_.at(key)->setEnabled(logs_.replay().open() && !logs_.replay().steppedStream().empty());
  };
  tip(ReplayKey::kMessageBack, tr("Back to the last message of %1").arg(name));
  tip(ReplayKey::kMessageOn, tr("Forward to the next message of %1").arg(name));
}

void LogToolBar::refresh() {
  const bool open = logs_.replay().open();
  if (open != wasOpen_) {
    wasOpen_ = open;
    setVisible(open);
    for (const auto& [key, action] : keyed_) action->setEnabled(open);
    for (QAction* action : {stop_, loop_, skipGaps_}) action->setEnabled(open);
    refreshTips();
  }
  clearRange_->setEnabled(logs_.replay().range().has_value());
  if (!open) return;
  const auto& status = logs_.replay().status();
  QAction* play = keyed_.at(ReplayKey::kPlayOrPause);
  const QString text = status.playing() ? tr("Pause") : tr("Play");
  if (play->text() != text) {
    play->setText(text);
    play->setIcon(widgets::icon(status.playing() ? "pause" : "play"));
    play->setToolTip(
        QStringLiteral("%1 (%2)").arg(status.playing() ? tr("Pauses the log") : tr("Plays the log"),
                                      play->shortcut().toString(QKeySequence::NativeText)));
  }
  loop_->setChecked(status.loop());
  skipGaps_->setChecked(status.skip_gaps());
  refreshProcesses();
  refreshFields();
}

}  // namespace app
