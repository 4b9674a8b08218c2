// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/console/CommandLog.h"

#include <utility>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/commands/ScriptLine.h"

namespace widgets {
namespace {

/// The most characters of a remembered line.
constexpr int kMaxLine = 1000;
/// The period at which a waiting line is checked.
constexpr int kTickMs = 20;
const QLatin1String kHelp("help");

QString asText(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace

CommandLog::CommandLog(robotlink::CommandTable& commands, robotlink::Session& session, QObject* parent)
    : QObject(parent), commands_(commands), script_({commands, session}) {
  script_.setOutput([this](const std::string& text) { add(Kind::kOutput, asText(text)); });
}

CommandLog::~CommandLog() = default;

robotlink::Result<void> CommandLog::run(const QString& line) {
  const QString words = line.simplified();
  if (words.isEmpty()) return {};
  remember(line.trimmed());
  add(Kind::kCommand, line.trimmed());
  if (words == kHelp || words.startsWith(kHelp + QLatin1Char(' '))) {
    help(words.mid(kHelp.size()).trimmed());
    return {};
  }
  using Word = robotlink::ScriptLine;
  const auto read = script_.withValuesOfVariables(line.toStdString()).and_then(&robotlink::readScriptLine);
  // Lines that cannot be read are refused by the script, with the column.
  if (read && read->kind == Word::Kind::kCommand) return runCommand(read->text);
  runWord(line.trimmed());
  return {};
}

robotlink::Result<void> CommandLog::runCommand(const std::string& line) {
  auto done = commands_.runLine(line);
  if (!done) add(Kind::kError, asText(done.error().text));
  return done;
}

void CommandLog::runWord(const QString& line) {
  if (!waiting_.isEmpty()) add(Kind::kOutput, tr("No longer waiting: %1").arg(waiting_));
  script_.cancel();
  waiting_ = line;
  script_.runLines({}, line.toStdString());
  if (timer_ == 0) timer_ = startTimer(kTickMs);
  tickScript();
}

void CommandLog::tickScript() {
  script_.tick(clock_.now());
  if (!script_.isIdle()) return;
  killTimer(std::exchange(timer_, 0));
  waiting_.clear();
  if (script_.failed()) add(Kind::kError, asText(script_.failed()->describe()));
}

void CommandLog::timerEvent(QTimerEvent* /*event*/) {
  tickScript();
}

void CommandLog::help(const QString& begin) {
  int found = 0;
  for (const auto& [name, command] : commands_.all()) {
    if (!command.run || !asText(name).startsWith(begin)) continue;
    ++found;
    const std::string arguments = robotlink::argumentsInWords(command);
    add(Kind::kOutput, asText(name + (arguments.empty() ? "" : " " + arguments)) + QStringLiteral("\n    ") +
                           asText(command.help));
  }
  if (found == 0) add(Kind::kError, tr("No command begins with %1.").arg(begin));
}

void CommandLog::add(Kind kind, const QString& text) {
  const Entry entry{kind, text};
  entries_.push_back(entry);
  if (entries_.size() > kMaxEntries) entries_.pop_front();
  Q_EMIT added(entry);
}

void CommandLog::clear() {
  entries_.clear();
  Q_EMIT cleared();
}

void CommandLog::remember(const QString& line) {
  if (line.isEmpty() || line.size() > kMaxLine) return;
  history_.removeAll(line);
  history_ << line;
  while (history_.size() > kMaxHistory) history_.removeFirst();
}

void CommandLog::setHistory(const QStringList& lines) {
  history_.clear();
  for (const QString& line : lines.mid(std::max(0, lines.size() - kMaxHistory))) remember(line);
}

CommandLog& commandLog(ViewContext& context) {
  if (context.commandLog == nullptr)
    context.commandLog = std::make_shared<CommandLog>(context.commands, context.session);
  return *context.commandLog;
}

}  // namespace widgets
