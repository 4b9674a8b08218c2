// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/ProblemReport.h"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QJsonDocument>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QSysInfo>
#include <QVBoxLayout>
#include <algorithm>
#include <thread>

#include "app/core/Workbench.h"
#include "app/core/platform/PlatformFeed.h"
#include "app/core/remote/RemoteRobots.h"
#include "foxglove/Robot.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/console/CommandLog.h"

namespace app {
namespace {

constexpr std::size_t kMaxMessages = 200, kMaxLayout = 64U << 10U;
constexpr int kMaxCommands = 100;

QString section(const QString& title, const QString& body) {
  return QStringLiteral("\n## %1\n\n%2\n").arg(title, body.isEmpty() ? QStringLiteral("(none)") : body);
}

QString verbatim(QString text) {
  if (!text.endsWith(QLatin1Char('\n'))) text += QLatin1Char('\n');
  return QStringLiteral("```\n%1```").arg(text);
}

QString versions() {
  QStringList lines{
      QStringLiteral("RobotControl %1").arg(QApplication::applicationVersion()),
      QStringLiteral("Qt %1, built with %2, platform %3")
          .arg(QLatin1String(qVersion()), QLatin1String(QT_VERSION_STR), QApplication::platformName()),
      QStringLiteral("%1, kernel %2, %3, %4 cores")
          .arg(QSysInfo::prettyProductName(), QSysInfo::kernelVersion(), QSysInfo::currentCpuArchitecture())
          .arg(std::thread::hardware_concurrency()),
      QStringLiteral("Locale %1").arg(QLocale::system().name())};
  for (const QScreen* screen : QApplication::screens()) {
    lines << QStringLiteral("Screen of %1x%2, scale %3")
                 .arg(screen->geometry().width())
                 .arg(screen->geometry().height())
                 .arg(screen->devicePixelRatio());
  }
  return lines.join(QLatin1Char('\n'));
}

QString opened(const Workbench& workbench) {
  QStringList lines;
  if (const LoadedPlatform* loaded = workbench.loaded()) {
    lines << QStringLiteral("Platform: %1").arg(QString::fromStdString(loaded->adapter));
    for (const std::string& source : loaded->sources)
      lines << QStringLiteral("Source: %1").arg(QString::fromStdString(source));
    for (const auto& [name, description] : loaded->robots) {
      lines << QStringLiteral("Robot: %1%2")
                   .arg(QString::fromStdString(name),
                        description ? QStringLiteral(" (%1)").arg(QString::fromStdString(description->name))
                                    : QString());
    }
    for (const std::string& lost : loaded->lostChoices) lines << QString::fromStdString(lost);
  }
  for (const auto& connection : workbench.remote().connections()) {
    lines << QStringLiteral("Connection: %1, %2")
                 .arg(QString::fromStdString(connection.url), QString::fromStdString(connection.text));
  }
  return lines.join(QLatin1Char('\n'));
}

QString layoutText(const LoadedPlatform* loaded) {
  if (loaded == nullptr || loaded->layout.empty()) return {};
  const auto text = robotlink::readFile(loaded->layout, kMaxLayout);
  const QString file = QString::fromStdString(loaded->layout.string());
  if (!text) return QString::fromStdString(text.error().describe());
  return file + QStringLiteral("\n\n") + verbatim(QString::fromStdString(*text));
}

/// The last texts of all robots in the order of time.
QString lastMessages(robotlink::Session& session) {
  std::vector<std::pair<robotlink::Instant, QString>> messages;
  for (const auto* stream : session.store().streams()) {
    for (const auto& message : stream->messages) {
      const auto* log = dynamic_cast<const foxglove::Log*>(message.value.get());
      if (log == nullptr) continue;
      messages.emplace_back(
          message.time, QStringLiteral("%1  %2  %3  %4: %5")
                            .arg(robotlink::seconds(message.time), 0, 'f', 3)
                            .arg(QString::fromStdString(foxglove::Log::Level_Name(log->level())),
                                 QString::fromStdString(stream->path), QString::fromStdString(log->name()),
                                 QString::fromStdString(log->message())));
    }
  }
  std::ranges::stable_sort(messages, {}, [](const auto& message) { return message.first; });
  if (messages.size() > kMaxMessages) messages.erase(messages.begin(), messages.end() - kMaxMessages);
  QStringList lines;
  for (const auto& [time, text] : messages) lines << text;
  return lines.isEmpty() ? QString() : verbatim(lines.join(QLatin1Char('\n')));
}

QString commands(const widgets::CommandLog& log) {
  QStringList lines;
  for (const auto& entry : log.entries()) {
    const bool typed = entry.kind == widgets::CommandLog::Kind::kCommand;
    lines << (typed ? QStringLiteral("> ") + entry.text : entry.text);
  }
  lines = lines.mid(std::max<int>(0, lines.size() - kMaxCommands));
  return lines.isEmpty() ? QString() : verbatim(lines.join(QLatin1Char('\n')));
}

}  // namespace

QString problemReport(Workbench& workbench, const widgets::CommandLog& log, const QJsonObject& window) {
  QString report = section(QStringLiteral("Versions"), versions());
  report += section(QStringLiteral("Open"), opened(workbench));
  report += section(QStringLiteral("Layout"), layoutText(workbench.loaded()));
  report += section(QStringLiteral("Last messages"), lastMessages(workbench.session()));
  report += section(QStringLiteral("Commands and errors"), commands(log));
  report += section(QStringLiteral("Window"), verbatim(QString::fromUtf8(QJsonDocument(window).toJson())));
  const QString home = QDir::homePath();
  if (home.size() <= 1) return report;
  // The match must not be the beginning of another folder's name.
  const QRegularExpression whole(QRegularExpression::escape(home) + QStringLiteral("(?![\\w-])"),
                                 QRegularExpression::UseUnicodePropertiesOption);
  return report.replace(whole, QStringLiteral("~"));
}

ProblemDialog::ProblemDialog(QString report, QWidget* window) : QDialog(window), report_(std::move(report)) {
  setObjectName(QStringLiteral("problemDialog"));
  setWindowTitle(tr("Report a problem"));
  createWidgets();
  resize(QSize(720, 640).boundedTo(window->screen()->availableSize() * 0.9));
}

void ProblemDialog::createWidgets() {
  auto* layout = new QVBoxLayout(this);
  auto* question = new QLabel(tr("&What did you do, what did you expect, and what happened?"), this);
  story_ = new QPlainTextEdit(this);
  widgets::describe(*story_, {"problemStory", tr("What happened"), {}});
  question->setBuddy(story_);
  layout->addWidget(question);
  layout->addWidget(story_, 1);
  auto* note = new QLabel(
      tr("The report also contains the following. It is only saved or copied, never sent; it has names of "
         "files and robots, so read it before you pass it on."),
      this);
  note->setWordWrap(true);
  layout->addWidget(note);
  auto* shown = new QPlainTextEdit(report_, this);
  widgets::describe(*shown, {"problemReport", tr("Contents of the report"), {}});
  shown->setReadOnly(true);
  layout->addWidget(shown, 2);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Close, this);
  buttons->button(QDialogButtonBox::Save)->setText(tr("&Save…"));
  auto* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
  copy->setObjectName(QStringLiteral("problemCopy"));
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });
  connect(buttons->button(QDialogButtonBox::Save), &QPushButton::clicked, this, &ProblemDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
}

QString ProblemDialog::text() const {
  const QString story = story_->toPlainText().trimmed();
  return QStringLiteral("# A problem with RobotControl\n\n%1\n")
             .arg(story.isEmpty() ? QStringLiteral("(nothing written)") : story) +
         report_;
}

void ProblemDialog::save() {
  const QString name = QStringLiteral("robotcontrol-problem-%1.md")
                           .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save the report"), name, tr("Reports (*.md);;All files (*)"));
  if (file.isEmpty()) return;
  const auto written = robotlink::writeFileAtomically(file.toStdString(), text().toStdString());
  if (written) return accept();
  QMessageBox::warning(this, tr("Report a problem"), QString::fromStdString(written.error().describe()));
}

}  // namespace app
