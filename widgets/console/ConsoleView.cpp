// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/console/ConsoleView.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QEvent>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTextDocumentFragment>
#include <QToolButton>

#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Theme.h"
#include "widgets/console/CommandInput.h"
#include "widgets/console/CommandTyping.h"

namespace widgets {
namespace {

const ViewRegistration kConsoleViewRegistration{
    {"console", QT_TRANSLATE_NOOP("View", "Console"),
     QT_TRANSLATE_NOOP("View", "Runs typed commands and shows their results."), "console", true,
     create<ConsoleView>}};

}  // namespace

ConsoleView::ConsoleView(ViewContext& context, QWidget* parent)
    : View(context, parent), log_(commandLog(context)) {
  setObjectName(QStringLiteral("consoleView"));
  createActions();
  createViews();
  connectSignals();
  showAll();
  showHint();
}

void ConsoleView::createActions() {
  copy_ = makeAction(this, "copy", {"consoleCopy", tr("Copy"), tr("Copies the selection, or everything")});
  clear_ = makeAction(this, "clear", {"consoleClear", tr("Clear"), tr("Removes all output")});
}

void ConsoleView::createViews() {
  const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  output_ = new QPlainTextEdit(this);
  describe(*output_, {"consoleOutput", tr("Output of commands"), {}});
  output_->setReadOnly(true);
  output_->setFont(fixed);
  output_->setMaximumBlockCount(2 * static_cast<int>(CommandLog::kMaxEntries));
  empty_ = new EmptyHint(output_->viewport());
  empty_->setHint(
      tr("Type a command below: Tab completes it, Up recalls earlier ones. "
         "help lists all commands."));
  input_ = new CommandInput(context().commands, log_, this);
  describe(*input_, {"consoleInput", tr("Command"), {}});
  input_->setPlaceholderText(tr("Command, as in scripts"));
  input_->setFont(fixed);
  hint_ = new QLabel(this);
  describe(*hint_, {"consoleHint", tr("What the command takes"), {}});
  hint_->setTextFormat(Qt::RichText);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout;
  row->addWidget(input_, 1);
  for (QAction* action : {copy_, clear_}) row->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(output_, 1);
  layout->addWidget(hint_);
  layout->addLayout(row);
  setFocusProxy(input_);
}

void ConsoleView::connectSignals() {
  connect(input_, &CommandInput::submitted, this, [this](const QString& line) {
    // Errors are shown as entries of the log, too.
    static_cast<void>(log_.run(line));
  });
  connect(input_, &CommandInput::ambiguous, this, [this](const QStringList& candidates) {
    log_.add(CommandLog::Kind::kOutput, candidates.join(QStringLiteral("  ")));
  });
  connect(input_, &QLineEdit::textChanged, this, &ConsoleView::showHint);
  connect(input_, &QLineEdit::cursorPositionChanged, this, &ConsoleView::showHint);
  connect(&log_, &CommandLog::added, this, &ConsoleView::append);
  connect(&log_, &CommandLog::cleared, this, &ConsoleView::showAll);
  connect(clear_, &QAction::triggered, &log_, &CommandLog::clear);
  connect(copy_, &QAction::triggered, this, [this] {
    const QString selected = output_->textCursor().selection().toPlainText();
    QApplication::clipboard()->setText(selected.isEmpty() ? output_->toPlainText() : selected);
  });
}

void ConsoleView::append(const CommandLog::Entry& entry) {
  using Kind = CommandLog::Kind;
  const bool isCommand = entry.kind == Kind::kCommand;
  QString text = (isCommand ? QStringLiteral("> ") + entry.text : entry.text).toHtmlEscaped();
  text.replace(QLatin1Char('\n'), QLatin1String("<br/>"));
  const QColor color = entry.kind == Kind::kError ? colorOf(Meaning::kBad, palette())
                       : isCommand
                           ? palette().color(QPalette::Text)
                           : mixed(palette().color(QPalette::Text), palette().color(QPalette::Base), 0.25);
  output_->appendHtml(
      QStringLiteral("<span style=\"white-space: pre-wrap; color: %1%2\">%3</span>")
          .arg(color.name(), isCommand ? QStringLiteral("; font-weight: bold") : QString(), text));
  empty_->hide();
}

void ConsoleView::showAll() {
  output_->clear();
  for (const CommandLog::Entry& entry : log_.entries()) append(entry);
  empty_->setVisible(log_.entries().empty());
}

void ConsoleView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && output_ != nullptr) showAll();
  View::changeEvent(event);
}

void ConsoleView::showHint() {
  hint_->setText(typedCommand(context().commands, input_->text(), input_->cursorPosition()).hint);
}

}  // namespace widgets
