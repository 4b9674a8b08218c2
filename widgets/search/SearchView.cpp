// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/search/SearchView.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/log/TimeMarks.h"

namespace widgets {

using robotlink::Result;

namespace {

constexpr int kFollowInterval = 100;  // ms

const ViewRegistration kSearchViewRegistration{
    {"search", QT_TRANSLATE_NOOP("View", "Search"),
     QT_TRANSLATE_NOOP("View", "Searches whole logs for conditions and texts, without playing them."),
     "search", false, create<SearchView>}};

QString searchErrorText(const robotlink::Error& error) {
  const QString reason = QString::fromStdString(error.text);
  return error.where.column > 0 ? SearchView::tr("At character %1: %2").arg(error.where.column).arg(reason)
                                : reason;
}

}  // namespace

SearchView::SearchView(ViewContext& context, QWidget* parent)
    : View(context, parent), logs_(openLogs(context)) {
  setObjectName(QStringLiteral("searchView"));
  createActions();
  createViews();
  connectSignals();
  keep("kind", kind_);  // condition, texts
  keep("wanted", wanted_, Names::kObjects);
  keep("columns", table_->horizontalHeader());
  follow_.setInterval(kFollowInterval);
  tick();
}

SearchView::~SearchView() {
  TimeMarks::of(logs_).setHits({});
}

void SearchView::createActions() {
  search_ = makeAction(this, "search",
                       {"searchStart", tr("Search"), tr("Searches all open logs completely (Enter)")});
  cancel_ =
      makeAction(this, "stop", {"searchCancel", tr("Cancel"), tr("Stops the search; its results are kept")});
  previous_ = makeAction(this, "previous",
                         {"searchPrevious", tr("Previous hit"), tr("Jumps to the hit before the shown time"),
                          QKeySequence::FindPrevious});
  next_ = makeAction(this, "next",
                     {"searchNext", tr("Next hit"), tr("Jumps to the next hit"), QKeySequence::FindNext});
}

void SearchView::createViews() {
  kind_ = new QComboBox(this);
  describe(*kind_,
           {"searchKind", tr("What is searched for"), tr("A condition on values, or a part of messages")});
  kind_->addItem(tr("Condition"));
  kind_->addItem(tr("Texts"));
  wanted_ = makeSearchField(this, {"searchWanted", tr("Search logs"),
                                   tr("A condition, such as models/ball.position.x > 1, or, for texts, a "
                                      "regular expression; Enter searches")});
  table_ = makeTable(this, {"searchTable", tr("Hits"), {}}, &model_);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  new ColumnFit(*table_, {ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kName, ColumnKind::kText,
                          ColumnKind::kName});
  hint_ = new EmptyHint(table_);
  state_ = makeNote(this, "searchState", tr("State of the search"));
  setFocusProxy(wanted_);
  auto* row = makeToolRow(this, 0);
  row->addWidget(kind_);
  row->addWidget(wanted_, 1);
  for (QAction* action : {search_, cancel_, previous_, next_}) row->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(row->parentWidget());
  layout->addWidget(table_, 1);
  layout->addWidget(state_);
}

void SearchView::connectSignals() {
  connect(search_, &QAction::triggered, this, &SearchView::searchTyped);
  connect(wanted_, &QLineEdit::returnPressed, this, &SearchView::searchTyped);
  connect(cancel_, &QAction::triggered, this, &SearchView::cancel);
  for (const auto& [action, direction] : {std::pair(previous_, -1), std::pair(next_, 1)}) {
    connect(action, &QAction::triggered, this, [this, direction = direction] {
      if (const auto done = go(direction); !done)
        showOutcome(*state_, QString::fromStdString(done.error().text), true);
    });
  }
  connect(&follow_, &QTimer::timeout, this, &SearchView::tick);
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) { jumpTo(index.row()); });
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) { jumpTo(index.row()); });
}

void SearchView::searchTyped() {
  const auto begun = search(wanted_->text(), kind_->currentIndex() == 1);
  if (!begun) showOutcome(*state_, searchErrorText(begun.error()), true);
}

Result<void> SearchView::search(const QString& wanted, bool isTexts) {
  const bool isHistory = logs_.logs().empty();
  if (isHistory && !hasHistory())
    return robotlink::failure("search.log",
                              "no log is open, and no robot is running; open a log first: log.open FILE");
  if (wanted.trimmed().isEmpty()) return robotlink::failure("search.empty", "type what to search for");
  std::optional<LogSearcher::History> history;
  if (isHistory) {
    auto found = LogSearcher::historyOf(session(), wanted.trimmed().toStdString(), isTexts);
    if (!found) return tl::unexpected(found.error());
    history = *std::move(found);
    searchedGeneration_ = session().store().generation();
  } else {
    searchedGeneration_.reset();
  }
  wanted_->setText(wanted);
  kind_->setCurrentIndex(isTexts ? 1 : 0);
  plan_ = {{}, wanted.trimmed().toStdString(), isTexts, std::move(history), logs_.computation()};
  offsets_.clear();
  for (const auto& log : logs_.logs()) {
    plan_.logs.push_back({log->path, log->offset, log->robots});
    offsets_.push_back(log->offset);
  }
  model_.clear();
  showMarks();
  isSearching_ = true;
  cancel_->setEnabled(true);
  searcher_.begin(plan_);
  plan_.history.reset();
  follow_.start();
  showOutcome(*state_, tr("Searching…"), false);
  return {};
}

void SearchView::cancel() {
  if (!isSearching_) return;
  searcher_.cancel();
  takeNews();
  showOutcome(*state_, tr("Canceled; hits so far: %1").arg(model_.rowCount()), false);
}

void SearchView::jumpTo(int row) {
  if (row < 0 || row >= model_.rowCount()) return;
  const robotlink::Instant time = model_.row(row).from;
  // The views that follow the selection show the robot of the hit.
  session().selectRobot(model_.row(row).robot.toStdString());
  searchedGeneration_ ? session().history().show(time) : logs_.replay().jumpTo(time);
}

robotlink::Instant SearchView::shownInstant() const {
  return searchedGeneration_ ? session().history().chosen() : logs_.replay().shown();
}

bool SearchView::hasHistory() const {
  return !session().robots().empty() && !session().store().streams().empty();
}

Result<void> SearchView::go(int direction) {
  followOffsets();
  const robotlink::Instant shown = shownInstant();
  const int at = model_.rowAt(shown);
  int row = at + 1;
  if (direction < 0) {
    row = at;
    while (row >= 0 && model_.row(row).from >= shown) --row;
  }
  // The only hit is the next and the previous one, wherever one is.
  if (model_.rowCount() == 1) row = 0;
  if (row < 0 || row >= model_.rowCount())
    return robotlink::failure("search.end",
                              direction > 0 ? "there is no later hit" : "there is no earlier hit");
  table_->selectRow(row);
  jumpTo(row);
  return {};
}

void SearchView::takeNews() {
  const LogSearcher::News news = searcher_.take();
  std::vector<SearchRow> rows;
  for (const LogSearcher::Hit& hit : news.hits) {
    const bool isLive = searchedGeneration_.has_value();
    const auto moved = isLive ? robotlink::Duration(0) : offsets_[hit.log] - plan_.logs[hit.log].offset;
    const QString of =
        isLive ? tr("live") : QFileInfo(QString::fromStdString(plan_.logs[hit.log].path.string())).fileName();
    const QString text = QString::fromStdString(plan_.isTexts || !hit.text.empty() ? hit.text : plan_.wanted);
    const auto until = hit.until ? std::optional(*hit.until + moved) : std::nullopt;
    rows.push_back({hit.from + moved, until, QString::fromStdString(hit.robot), text, of, hit.log});
  }
  model_.add(rows);
  if (!rows.empty()) showMarks();
  isSearching_ = !news.isDone;
  showState(news);
}

void SearchView::followOffsets() {
  bool isMoved = false;
  for (std::size_t i = 0; i < plan_.logs.size(); ++i) {
    const OpenLogs::Log* log = logs_.find(plan_.logs[i].path.string());
    if (log == nullptr || log->offset == offsets_[i]) continue;
    model_.move(i, log->offset - offsets_[i]);
    offsets_[i] = log->offset;
    isMoved = true;
  }
  if (isMoved) showMarks();
}

void SearchView::showState(const LogSearcher::News& news) {
  constexpr double kPercent = 100;
  const QString count = counted(model_.rowCount(), tr("1 hit"), tr("%1 hits"));
  if (!news.isDone) {
    const QString running = news.computed.empty() ? tr("Searching: %1 %, %2") : tr("Computing: %1 %, %2");
    return showOutcome(*state_, running.arg(static_cast<int>(news.progress * kPercent)).arg(count), false);
  }
  if (news.failure) return showOutcome(*state_, searchErrorText(*news.failure), true);
  QStringList lines{news.isCut ? tr("%1; there are more, which are not shown").arg(count) : count};
  if (!news.computed.empty()) {
    QStringList streams;
    for (const std::string& stream : news.computed) streams << QString::fromStdString(stream);
    lines << tr("Computed by the program: %1").arg(streams.join(QStringLiteral(", ")));
  }
  for (const std::string& loss : news.losses) lines << QString::fromStdString(loss);
  showOutcome(*state_, lines.join(QLatin1Char('\n')), false);
}

void SearchView::showMarks() {
  std::vector<TimeMark> marks;
  marks.reserve(model_.rows().size());
  const auto end = searchedGeneration_ ? session().timeline().newest() : logs_.replay().end();
  for (const SearchRow& row : model_.rows())
    marks.push_back({row.from, row.until.value_or(end), row.text, LogEntry::Level::kInfo});
  TimeMarks::of(logs_).setHits(std::move(marks));
}

void SearchView::forgetOthers() {
  const bool isThere = searchedGeneration_
                           ? *searchedGeneration_ == session().store().generation() && logs_.logs().empty()
                           : !logs_.logs().empty();
  if (isThere || (model_.rowCount() == 0 && !isSearching_)) return;
  if (searchedGeneration_) {
    searcher_.cancel();
    searcher_.take();
    isSearching_ = false;
  }
  model_.clear();
  showMarks();
  showOutcome(*state_, {}, false);
}

void SearchView::tick() {
  model_.setOrigin(session().timeline().origin());
  const bool isOpen = !logs_.logs().empty() || hasHistory();
  forgetOthers();
  followOffsets();
  if (isSearching_) takeNews();
  if (!isSearching_ && model_.rowCount() == 0) follow_.stop();
  search_->setEnabled(isOpen);
  cancel_->setEnabled(isSearching_);
  for (QAction* action : {previous_, next_}) action->setEnabled(model_.rowCount() > 0);
  hint_->setHint(
      !isOpen ? tr("There is nothing to search.\nOpen a log with File > Open log…, or drop log files onto "
                   "the window; or start a simulation, or connect to a robot.")
      : model_.rowCount() > 0 || isSearching_
          ? QString()
          : tr("Type a condition, such as models/ball.position.x > 1, or choose Texts, and press "
               "Enter."));
}

Result<void> SearchView::saveTo(const QString& file) {
  if (!file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) return View::saveTo(file);
  return robotlink::writeFileAtomically(file.toStdString(), model_.csv().toStdString());
}

}  // namespace widgets
