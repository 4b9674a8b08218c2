// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/commands/CommandPalette.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QMenuBar>
#include <QVBoxLayout>
#include <algorithm>

#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/commands/PaletteDelegate.h"
#include "widgets/Controls.h"
#include "widgets/console/CommandLog.h"
#include "widgets/console/CommandTyping.h"

namespace app {
namespace {

constexpr int kMinPaletteWidth = 420, kMaxPaletteWidth = 820;
constexpr int kShownRows = 12;
constexpr int kBelowTop = 60;  // px below the window's edge

}  // namespace

CommandPalette::CommandPalette(const Parts& parts, QWidget* window) : QFrame(window), parts_(parts) {
  setObjectName(QStringLiteral("commandPalette"));
  setFrameShape(QFrame::StyledPanel);
  setFrameShadow(QFrame::Raised);
  setAutoFillBackground(true);
  createViews();
  connectSignals();
  hide();
}

void CommandPalette::createViews() {
  input_ = new QLineEdit(this);
  widgets::describe(*input_, {"paletteInput", tr("Command or menu entry"), {}});
  hint_ = widgets::makeNote(this, "paletteHint", tr("What comes next"));
  hint_->setTextFormat(Qt::RichText);
  list_ = new QListView(this);
  widgets::describe(*list_, {"paletteList", tr("Commands and menu entries"), {}});
  list_->setModel(&model_);
  list_->setItemDelegate(new PaletteDelegate(list_));
  list_->setUniformItemSizes(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  auto* layout = widgets::makeColumn(this, {6, 6, 6, 6}, 4);
  layout->addWidget(input_);
  layout->addWidget(hint_);
  layout->addWidget(list_, 1);
}

void CommandPalette::connectSignals() {
  input_->installEventFilter(this);
  parentWidget()->installEventFilter(this);
  connect(input_, &QLineEdit::textChanged, this, &CommandPalette::refresh);
  connect(list_, &QListView::clicked, this, &CommandPalette::accept);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (isVisible() && now != nullptr && !isAncestorOf(now)) {
      before_ = nullptr;  // the focus is where the person wants it
      hide();
    }
  });
}

void CommandPalette::open() {
  const auto* window = qobject_cast<QMainWindow*>(parentWidget());
  if (window != nullptr) show(paletteEntries(*window->menuBar(), parts_.commands), false);
}

void CommandPalette::openViews() {
  show(parts_.views(), true);
}

void CommandPalette::show(std::vector<PaletteEntry> entries, bool areViews) {
  if (!isVisible()) before_ = QApplication::focusWidget();
  entries_ = std::move(entries);
  areViews_ = areViews;
  input_->setPlaceholderText(areViews ? tr("Go to: words of a view's title")
                                      : tr("What to do: words of a command or menu entry"));
  input_->clear();
  refresh();
  place();
  parentWidget()->activateWindow();
  QFrame::show();
  raise();
  input_->setFocus(Qt::ShortcutFocusReason);
}

void CommandPalette::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  if (before_ != nullptr) before_->setFocus(Qt::OtherFocusReason);
}

void CommandPalette::place() {
  const QWidget& window = *parentWidget();
  const int width =
      std::min(std::clamp(window.width() / 2, kMinPaletteWidth, kMaxPaletteWidth), window.width());
  const int rowHeight = std::max(1, list_->sizeHintForRow(0));
  const int rows = std::min(kShownRows, model_.rowCount());
  list_->setVisible(rows > 0);
  list_->setFixedHeight(std::max(rows, 1) * rowHeight + 2);
  setFixedWidth(width);
  adjustSize();
  QFrame::move((window.width() - width) / 2, std::min(kBelowTop, window.height() / 8));
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) place();
  if (watched != input_) return false;
  if (event->type() == QEvent::KeyPress) return press(static_cast<QKeyEvent*>(event)->key());
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
  }
  return false;
}

bool CommandPalette::press(int key) {
  switch (key) {
    case Qt::Key_Escape:
      hide();
      return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
      move(key == Qt::Key_Up ? -1 : 1);
      return true;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      move(key == Qt::Key_PageUp ? -kShownRows : kShownRows);
      return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
      complete();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      accept();
      return true;
    default:
      return false;
  }
}

QString CommandPalette::begunCommand() const {
  if (areViews_) return {};
  const QString typed = input_->text();
  const int blank = typed.indexOf(QLatin1Char(' '));
  if (blank <= 0) return {};
  const QString name = typed.left(blank);
  const auto* command = parts_.commands.find(name.toStdString());
  return command != nullptr && command->run ? name : QString();
}

std::vector<PaletteEntry> CommandPalette::recentLines() const {
  std::vector<PaletteEntry> lines;
  for (const QString& id : areViews_ ? QStringList() : recent_) {
    const bool isLine = id.contains(QLatin1Char(' '));
    if (isLine) lines.push_back({id, tr("used before"), {}, id});
  }
  return lines;
}

void CommandPalette::refresh() {
  showHint({});
  if (!begunCommand().isEmpty()) {
    showArguments();
  } else {
    auto all = recentLines();
    all.insert(all.end(), entries_.begin(), entries_.end());
    model_.show(paletteMatches(all, input_->text(), recent_));
    list_->setCurrentIndex(model_.index(0));
    if (model_.rowCount() == 0) showHint(tr("No match. Try fewer or shorter words."));
  }
  place();
}

void CommandPalette::showArguments() {
  const auto typed = widgets::typedCommand(parts_.commands, input_->text(), input_->cursorPosition());
  std::vector<PaletteEntry> candidates;
  for (const QString& candidate : typed.candidates) candidates.push_back({candidate, {}, {}, candidate});
  model_.show(std::move(candidates));
  list_->setCurrentIndex({});
  showHint(typed.hint.isEmpty() ? tr("Return runs it.") : typed.hint);
}

void CommandPalette::move(int rows) {
  const int count = model_.rowCount();
  if (count == 0) return;
  const QModelIndex current = list_->currentIndex();
  const int row = current.isValid() ? current.row() + rows : rows > 0 ? 0 : count - 1;
  list_->setCurrentIndex(model_.index(std::clamp(row, 0, count - 1)));
}

void CommandPalette::take(const QString& candidate) {
  const auto typed = widgets::typedCommand(parts_.commands, input_->text(), input_->cursorPosition());
  const auto after = widgets::replaced({input_->text(), input_->cursorPosition()}, typed.from, candidate);
  input_->setText(after.line);
  input_->setCursorPosition(after.cursor);
}

void CommandPalette::complete() {
  const PaletteEntry* chosen = model_.entry(list_->currentIndex());
  if (begunCommand().isEmpty()) {
    if (chosen != nullptr && !chosen->line.isEmpty())
      input_->setText(areViews_ ? chosen->title : chosen->line + QLatin1Char(' '));
    return;
  }
  if (chosen != nullptr) return take(chosen->line);
  const auto after = widgets::completed(parts_.commands, {input_->text(), input_->cursorPosition()});
  input_->setText(after.line);
  input_->setCursorPosition(after.cursor);
}

void CommandPalette::accept() {
  const PaletteEntry* chosen = model_.entry(list_->currentIndex());
  if (!begunCommand().isEmpty()) return chosen != nullptr ? take(chosen->line) : runLine(input_->text());
  if (chosen != nullptr) run(PaletteEntry(*chosen));
}

void CommandPalette::run(const PaletteEntry& entry) {
  if (areViews_) {
    hide();
    return parts_.go(entry.line);
  }
  if (entry.isUnfinished) return input_->setText(entry.line + QLatin1Char(' '));
  if (!entry.line.isEmpty()) return runLine(entry.line);
  remember(entry.id());
  hide();
  if (entry.action) entry.action->trigger();
}

void CommandPalette::runLine(const QString& line) {
  const QString trimmed = line.trimmed();
  if (!parts_.actions.mayRun(trimmed.section(QLatin1Char(' '), 0, 0))) return;
  // The focus is back before the command runs, which may move it.
  const QPointer<QWidget> before = before_;
  hide();
  const auto done = parts_.log.run(trimmed);
  if (done) return remember(trimmed);
  open();
  before_ = before;
  input_->setText(trimmed);
  showHint(QString::fromStdString(done.error().text).toHtmlEscaped(), true);
  place();
}

void CommandPalette::remember(const QString& id) {
  recent_.removeAll(id);
  recent_ << id;
  while (recent_.size() > kMaxRecent) recent_.removeFirst();
}

void CommandPalette::setRecent(const QStringList& recent) {
  recent_.clear();
  for (const QString& id : recent.mid(std::max(0, recent.size() - kMaxRecent))) remember(id);
}

void CommandPalette::showHint(const QString& html, bool isBad) {
  hint_->setText(html);
  hint_->setVisible(!html.isEmpty());
  widgets::setMeaning(*hint_, isBad ? std::optional(widgets::Meaning::kBad) : std::nullopt);
}

}  // namespace app
