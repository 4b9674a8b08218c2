// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/MessagesView.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "foxglove/Robot.pb.h"
#include "logplayer/search/MessageSource.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/messages/LevelDelegate.h"
#include "widgets/messages/LogFilter.h"

namespace widgets {

using robotlink::Instant;

namespace {

const ViewRegistration kMessagesViewRegistration{
    {"messages", QT_TRANSLATE_NOOP("View", "Messages"),
     QT_TRANSLATE_NOOP("View", "Shows the robots' text messages, with filters and a search."), "messages",
     true, create<MessagesView>}};

LogEntry logEntry(const robotlink::StreamMessage& message, const QString& robot, const foxglove::Log& log) {
  LogEntry entry;
  entry.time = message.time;
  entry.level = static_cast<LogEntry::Level>(std::clamp(static_cast<int>(log.level()), 0, 5));
  entry.robot = robot;
  entry.source = QString::fromStdString(log.name());
  entry.text = QString::fromStdString(log.message());
  return entry;
}

/// Identifies a message: equal for a message in a log and for the one that is published when the log is
/// played.
std::string keyOf(const LogEntry& entry) {
  return std::to_string(entry.time.time_since_epoch().count()) + ' ' + entry.source.toStdString() + ' ' +
         entry.text.toStdString();
}

}  // namespace

MessagesView::MessagesView(ViewContext& context, QWidget* parent)
    : View(context, parent), filter_(new LogFilter(this)), logs_(openLogs(context)) {
  setObjectName(QStringLiteral("messagesView"));
  createActions();
  createFilters();
  createViews();
  connectSignals();
  keep("level", level_);  // an entry for each level, in their order
  keep("regex", regex_);
  keep("filter", pattern_);
  keep("follow", follow_);
  keep("columns", table_->horizontalHeader());
  showState();
}

void MessagesView::createActions() {
  regex_ = makeToggle(this, "debug",
                      {"messagesRegex", tr("Regular expression"),
                       tr("Reads the filter as a regular expression"), tr("Ctrl+G")});
  regex_->setIcon({});
  regex_->setIconText(QStringLiteral(".*"));
  previous_ = makeAction(
      this, "previous",
      {"messagesPrevious", tr("Previous match"), tr("Goes to the match above"), QKeySequence::FindPrevious});
  next_ =
      makeAction(this, "next",
                 {"messagesNext", tr("Next match"), tr("Goes to the match below"), QKeySequence::FindNext});
  follow_ = makeToggle(this, "follow",
                       {"messagesFollow", tr("Follow"), tr("Keeps the newest message in view"), tr("Ctrl+E")},
                       true);
  pause_ = makeToggle(this, "pause",
                      {"messagesPause", tr("Pause"),
                       tr("Stops adding messages until it continues; none are lost"), tr("Ctrl+T")});
  copy_ = makeAction(this, "copy",
                     {"messagesCopy", tr("Copy"), tr("Copies the selected rows"), QKeySequence::Copy});
  clear_ =
      makeAction(this, "clear", {"messagesClear", tr("Clear"), tr("Empties the list"), tr("Ctrl+Shift+X")});
}

void MessagesView::createFilters() {
  level_ = new QComboBox(this);
  describe(*level_, {"messagesLevel", tr("Level"), tr("Shows messages that are at least this severe")});
  for (int level = 0; level <= static_cast<int>(LogEntry::Level::kError); ++level) {
    level_->addItem(level == 0 ? tr("all levels") : LogModel::levelName(static_cast<LogEntry::Level>(level)),
                    level);
  }
  robot_ = new QComboBox(this);
  describe(*robot_, {"messagesRobot", tr("Robot"), tr("Shows messages of one robot, or of all")});
  robot_->addItem(tr("all robots"), QString());
  robot_->hide();
  pattern_ = makeSearchField(
      this, {"messagesFilter", tr("Filter"), tr("Shows only messages whose text or source contains this")});
  search_ = makeSearchField(this, {"messagesSearch", tr("Search"),
                                   tr("Goes to the next message that contains this; Enter for the next")});
}

QWidget* MessagesView::createBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(level_);
  layout->addWidget(robot_);
  layout->addWidget(pattern_, 3);
  auto* regex = makeButton(this, regex_);
  regex->setToolButtonStyle(Qt::ToolButtonTextOnly);
  layout->addWidget(regex);
  layout->addSpacing(8);
  layout->addWidget(search_, 2);
  for (QAction* action : {previous_, next_}) layout->addWidget(makeButton(this, action));
  layout->addSpacing(8);
  for (QAction* action : {follow_, pause_, copy_, clear_}) layout->addWidget(makeButton(this, action));
  return bar;
}

void MessagesView::createViews() {
  filter_->setSourceModel(&model_);
  table_ = makeEventTable(this, {"messagesTable", tr("Messages"), {}}, filter_);
  table_->setItemDelegateForColumn(LogModel::kLevel, new LevelDelegate(table_));
  new ColumnFit(*table_, {ColumnKind::kNumber, ColumnKind::kName, ColumnKind::kName, ColumnKind::kName,
                          ColumnKind::kText});
  hint_ = new EmptyHint(table_);
  state_ = new QLabel(this);
  describe(*state_, {"messagesState", tr("Number of messages"), {}});
  problem_ = new QLabel(this);
  describe(*problem_, {"messagesProblem", tr("What is wrong with the filter"), {}});
  problem_->hide();
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(state_);
  bottom->addWidget(problem_, 1);
  bottom->addStretch();
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(createBar());
  layout->addWidget(table_, 1);
  layout->addLayout(bottom);
}

void MessagesView::connectSignals() {
  connect(level_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    filter_->setMinimumLevel(level_->currentData().toInt());
    showState();
  });
  connect(robot_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    filter_->setRobot(robot_->currentData().toString());
    showState();
  });
  connect(pattern_, &QLineEdit::textChanged, this, &MessagesView::setPattern);
  connect(regex_, &QAction::toggled, this, &MessagesView::setPattern);
  connect(search_, &QLineEdit::textChanged, this, [this] { find(0); });
  connect(search_, &QLineEdit::returnPressed, this, [this] { find(1); });
  connect(next_, &QAction::triggered, this, [this] { find(1); });
  connect(previous_, &QAction::triggered, this, [this] { find(-1); });
  connect(copy_, &QAction::triggered, this, [this] {
    copyRows(*table_, [](const QModelIndex& row) { return firstTexts(row, LogModel::kColumns); });
  });
  connect(clear_, &QAction::triggered, this, [this] {
    model_.clear();
    missed_.clear();
    showState();
  });
  connect(follow_, &QAction::toggled, this, [this](bool on) {
    if (on && !logs_.replay().open()) table_->scrollToBottom();
    shown_ = {};
  });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (logs_.replay().open()) logs_.replay().jumpTo(model_.entry(filter_->mapToSource(index).row()).time);
  });
  followEnd(*table_, *follow_);
}

void MessagesView::tick() {
  listRobots();
  model_.setOrigin(session().timeline().origin());
  if (!pause_->isChecked()) takeNew();
  showInstant();
}

void MessagesView::tickHidden() {
  if (!pause_->isChecked()) takeNew();
}

void MessagesView::showInstant() {
  const bool log = logs_.replay().open();
  const auto& timeline = session().timeline();
  const Instant shown = log ? logs_.replay().shown() : timeline.shown();
  model_.setShown(log ? shown : Instant::max());
  if (shown == shown_ || (log ? !follow_->isChecked() : timeline.live())) return;
  shown_ = shown;
  // A selection of several rows (for copying) is not changed while the log is played.
  if (log && table_->selectionModel()->selectedRows().size() > 1) return;
  const int row = model_.rowAt(shown_);
  const QModelIndex index = row < 0 ? QModelIndex() : filter_->mapFromSource(model_.index(row, 0));
  if (!index.isValid()) return;
  table_->setCurrentIndex(index);
  table_->scrollTo(index, log ? QAbstractItemView::PositionAtCenter : QAbstractItemView::EnsureVisible);
}

void MessagesView::takeLogs() {
  std::vector<LogEntry> entries;
  logged_.clear();
  model_.clear();
  for (const auto& log : logs_.logs()) {
    if (log->overview->texts == nullptr) continue;
    for (LogEntry entry : *log->overview->texts) {
      entry.time += log->offset;
      entry.robot = QString::fromStdString(
          robotlink::streams::robotOf(OpenLogs::sessionPath(*log, entry.robot.toStdString() + "/")));
      entry.logged = true;
      logged_.insert(keyOf(entry));
      entries.push_back(std::move(entry));
    }
  }
  model_.insert(std::move(entries));
}

void MessagesView::takeNew() {
  const auto generation = session().store().generation();
  decltype(listed_) logs;
  for (const auto& log : logs_.logs()) logs.emplace_back(log->overview->texts, log->offset);
  if (generation != generation_ || logs != listed_) {
    const bool sameLogs = logs == listed_;
    listed_ = std::move(logs);
    generation_ = generation;
    cursors_.clear();
    newest_.clear();
    missed_.clear();
    sameLogs ? model_.removePublished() : takeLogs();
    shown_ = {};
    showState();
  }
  std::vector<LogEntry> entries;
  for (const auto* stream : streamsOfType(session().store(), {}, "foxglove.Log")) {
    const QString robot = QString::fromStdString(robotlink::streams::robotOf(stream->path));
    const StreamCursor::News news = cursors_[stream->path].take(*stream);
    // The clock went back, as at a reset: later texts are not valid.
    if (news.restarted && !news.messages.empty()) removeLater(news.messages.front()->time, entries);
    if (!news.messages.empty()) {
      const auto known = newest_.find(stream->path);
      if (known == newest_.end() || news.missed)
        noteMissed(stream->path, known == newest_.end() ? Instant::min() : known->second,
                   news.messages.front()->time);
      newest_[stream->path] = news.messages.back()->time;
    }
    for (const auto* message : news.messages) {
      const auto* log = dynamic_cast<const foxglove::Log*>(message->value.get());
      if (log == nullptr) continue;
      LogEntry entry = logEntry(*message, robot, *log);
      if (logged_.empty() || !logged_.contains(keyOf(entry))) entries.push_back(std::move(entry));
    }
  }
  takeArchived();
  if (entries.empty()) return;
  model_.insert(std::move(entries));
  if (follow_->isChecked() && session().timeline().live() && !logs_.replay().open()) table_->scrollToBottom();
  showState();
}

void MessagesView::noteMissed(const std::string& stream, Instant from, Instant to) {
  const auto known = missed_.try_emplace(stream, robotlink::Stretch{from, to}).first;
  known->second.from = std::min(known->second.from, from);
  known->second.to = to;
}

MessagesView::Read MessagesView::readTexts(const Reading& reading, const std::stop_token& stop) {
  Read read{reading.generation};
  std::vector<std::string> streams;
  Instant from = Instant::max();
  for (const auto& [stream, stretch] : reading.stretches) {
    streams.push_back(stream);
    from = std::min(from, stretch.from);
  }
  const auto source = logplayer::historySource(reading.pieces);
  const auto cursor = source->read(streams, from);
  while (!stop.stop_requested()) {
    const auto message = cursor->next();
    if (!message) break;
    const auto& [begin, end] = reading.stretches.at(message->path);
    const auto* log = dynamic_cast<const foxglove::Log*>(message->value.get());
    if (log == nullptr || message->time <= begin || message->time >= end) continue;
    read.texts.push_back(
        logEntry(*message, QString::fromStdString(robotlink::streams::robotOf(message->path)), *log));
  }
  return read;
}

void MessagesView::takeArchived() {
  if (reader_) {
    auto read = reader_->take();
    if (read && read->generation == generation_ && !read->texts.empty()) {
      model_.insert(std::move(read->texts));
      showState();
    }
  }
  const auto* archive = session().history().archive();
  if (missed_.empty() || archive == nullptr || !logs_.logs().empty()) return missed_.clear();
  Reading reading{generation_, missed_, archive->pieces()};
  if (reading.pieces.empty()) return missed_.clear();
  if (!reader_)
    reader_ = std::make_unique<robotlink::Worker<Reading, Read>>(
        [this](const Reading& wanted, const std::stop_token& stop) {
          reader_->publish(readTexts(wanted, stop));
        });
  if (reader_->postIfFree(std::move(reading))) missed_.clear();
}

void MessagesView::removeLater(Instant time, std::vector<LogEntry>& unlisted) {
  model_.removePublished(time);
  std::erase_if(unlisted, [&](const LogEntry& entry) { return entry.time > time; });
}

void MessagesView::listRobots() {
  const auto& robots = session().robots();
  bool same = robot_->count() == static_cast<int>(robots.size()) + 1;
  for (int i = 1; same && i < robot_->count(); ++i) {
    same = robot_->itemData(i).toString().toStdString() == robots[static_cast<std::size_t>(i) - 1];
  }
  if (same) return;
  robot_->setVisible(robots.size() > 1);  // a choice of one robot would only take room from the filter
  const QString chosen = robot_->currentData().toString();
  const QSignalBlocker quiet(robot_);
  robot_->clear();
  robot_->addItem(tr("all robots"), QString());
  for (const std::string& robot : robots)
    robot_->addItem(QString::fromStdString(robot), QString::fromStdString(robot));
  robot_->setCurrentIndex(std::max(0, robot_->findData(chosen)));
  filter_->setRobot(robot_->currentData().toString());
}

void MessagesView::setPattern() {
  const QString problem = filter_->setPattern(pattern_->text(), regex_->isChecked());
  showOutcome(*problem_, problem, true);
  problem_->setVisible(!problem.isEmpty());
  showState();
}

robotlink::Result<void> MessagesView::setFilter(const std::string& text, bool isRegex) {
  regex_->setChecked(isRegex);
  pattern_->setText(QString::fromStdString(text));
  setPattern();
  if (problem_->text().isEmpty()) return {};
  return robotlink::failure("messages.filter", problem_->text().toStdString(), {}, {text});
}

void MessagesView::find(int step) {
  const QString text = search_->text();
  const int rows = filter_->rowCount();
  if (text.isEmpty() || rows == 0) return;
  const int current = table_->currentIndex().isValid() ? table_->currentIndex().row() : step > 0 ? -1 : 0;
  const int direction = step < 0 ? -1 : 1;
  for (int i = 0; i < rows; ++i) {
    const int row = ((current + step + i * direction) % rows + rows) % rows;
    if (!LogFilter::holds(*filter_, row, text)) continue;
    follow_->setChecked(false);
    table_->setCurrentIndex(filter_->index(row, LogModel::kText));
    return showState();
  }
  state_->setText(tr("“%1” was not found").arg(text));
}

void MessagesView::showState() {
  const int all = model_.rowCount();
  const int shown = filter_->rowCount();
  state_->setText(shown < all ? tr("%1 of %2 messages").arg(shown).arg(all)
                              : counted(all, tr("1 message"), tr("%1 messages")));
  if (all == 0) {
    hint_->setHint(logs_.replay().open()
                       ? tr("The log holds no messages.")
                       : tr("No messages yet. They appear here when a robot's program logs something."));
  } else {
    hint_->setHint(shown == 0 ? tr("No message passes the filters. Clear the filter or lower the level.")
                              : QString());
  }
}

}  // namespace widgets
