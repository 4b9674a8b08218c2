// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TimeLineView that acts on ranges and files: cutting, exporting, repairing.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <set>

#include "widgets/log/LogBars.h"
#include "widgets/log/LogJobs.h"
#include "widgets/timeline/CutStreams.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets {

std::optional<std::pair<robotlink::Instant, robotlink::Instant>> TimeLineView::rangeOf(
    const OpenLogs::Log& log) const {
  auto range = logs_.replay().range();
  if (range) range = std::pair(range->first - log.offset, range->second - log.offset);
  return range;
}

QString TimeLineView::suggested(const OpenLogs::Log& log, const QString& suffix) const {
  const QFileInfo file(QString::fromStdString(log.path));
  return file.dir().filePath(file.completeBaseName() + suffix);
}

void TimeLineView::askForFile(const FileQuestion& question, std::function<void(const QString&)> chosen) {
  auto* dialog = new QFileDialog(this, question.title, question.suggestion, question.filter);
  dialog->setObjectName(QLatin1String(question.name));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(question.folder ? QFileDialog::AcceptOpen : QFileDialog::AcceptSave);
  dialog->setFileMode(question.folder ? QFileDialog::Directory : QFileDialog::AnyFile);
  if (question.folder) dialog->setOption(QFileDialog::ShowDirsOnly);
  const int suffix = question.suggestion.lastIndexOf(QLatin1Char('.'));
  if (!question.folder && suffix >= 0) dialog->setDefaultSuffix(question.suggestion.mid(suffix + 1));
  if (!question.folder) dialog->selectFile(question.suggestion);
  connect(dialog, &QFileDialog::fileSelected, this,
          [chosen = std::move(chosen)](const QString& file) { chosen(file); });
  dialog->open();
}

void TimeLineView::loopRange() {
  auto& replay = logs_.replay();
  const auto range = replay.range();
  if (!range) return;
  replay.setLoop(true);
  if (replay.shown() < range->first || replay.shown() >= range->second) replay.jumpTo(range->first);
  replay.play();
}

void TimeLineView::cut() {
  if (const auto range = logs_.replay().range()) writeCut(range, {});
}

void TimeLineView::cutStreams() {
  std::set<std::string> paths;
  for (const auto& open : logs_.logs()) {
    for (const auto& stream : open->overview->streams) paths.insert(stream.path);
  }
  auto* dialog = new CutStreams({paths.begin(), paths.end()}, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog] { writeCut(logs_.replay().range(), dialog->filter()); });
  dialog->open();
}

void TimeLineView::writeCut(const LogRange& range, const logplayer::StreamFilter& streams) {
  const auto* log = logs_.current();
  if (log == nullptr) return;
  const FileQuestion question{"cutDialog", tr("Cut into a new log"),
                              suggested(*log, QStringLiteral("-cut.mcap")), tr("Logs (*.mcap)")};
  askForFile(question, [this, range, streams](const QString& file) {
    std::vector<std::pair<std::string, robotlink::Duration>> inputs;
    for (const auto& open : logs_.logs()) {
      inputs.emplace_back(open->path, open->offset);
      if (QFileInfo(file) == QFileInfo(QString::fromStdString(open->path))) {
        Q_EMIT logs_.failed(tr("A log cannot be cut into itself; choose another name."));
        return;
      }
    }
    logs_.saveBookmarks();  // bookmarks in the range are copied into the new log
    job_->start(tr("Cutting into %1").arg(QFileInfo(file).fileName()),
                cutLogs(inputs, range, file.toStdString(), streams));
  });
}

void TimeLineView::exportImages() {
  const auto* log = logs_.current();
  if (log == nullptr || log->imageStream.empty()) return Q_EMIT logs_.failed(tr("This log holds no images."));
  const FileQuestion question{"exportImagesDialog",
                              tr("Export images into a folder"),
                              QFileInfo(QString::fromStdString(log->path)).path(),
                              {},
                              true};
  askForFile(question, [this, path = log->path, stream = log->imageStream,
                        range = rangeOf(*log)](const QString& folder) {
    job_->start(tr("Exporting images into %1").arg(folder),
                exportImagesOf(path, stream, range, folder.toStdString()));
  });
}

void TimeLineView::exportTable() {
  const auto* log = logs_.current();
  const std::string stream = logs_.replay().steppedStream();
  if (log == nullptr || stream.empty()) return;
  QString name = QString::fromStdString(stream);
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
  const FileQuestion question{
      "exportTableDialog", tr("Export %1 as a table").arg(QString::fromStdString(stream)),
      suggested(*log, QLatin1Char('-') + name + QStringLiteral(".csv")), tr("Tables (*.csv)")};
  askForFile(question, [this, path = log->path, stream, range = rangeOf(*log)](const QString& file) {
    job_->start(tr("Exporting %1").arg(QFileInfo(file).fileName()),
                exportTableOf(path, stream, range, file.toStdString()));
  });
}

void TimeLineView::exportTexts() {
  const auto* log = logs_.current();
  if (log == nullptr) return;
  const FileQuestion question{"exportTextsDialog", tr("Export texts"),
                              suggested(*log, QStringLiteral(".txt")), tr("Texts (*.txt)")};
  askForFile(question, [this, path = log->path, range = rangeOf(*log)](const QString& file) {
    job_->start(tr("Exporting %1").arg(QFileInfo(file).fileName()),
                exportTextsOf(path, range, file.toStdString()));
  });
}

void TimeLineView::addAligning(QMenu& menu, int band, robotlink::Instant time) {
  const auto* log = logAt(band);
  if (log == nullptr || logs_.logs().size() < 2) return;
  const auto nameOf = [](const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).fileName();
  };
  menu.addSeparator();
  menu.addAction(tr("Mark this event of %1, to find it in another log").arg(nameOf(log->path)), this,
                 [this, path = log->path, own = time - log->offset] {
                   marked_ = {path, own};
                 })
      ->setObjectName(QStringLiteral("markEvent"));
  const auto* other = marked_ ? logs_.find(marked_->first) : nullptr;
  if (other == nullptr || other == log) return;
  const robotlink::Instant meant = marked_->second + other->offset;
  menu.addAction(tr("This is the marked event of %1: align").arg(nameOf(other->path)), this,
                 [this, path = log->path, offset = log->offset + (meant - time)] {
                   logs_.replay().setOffset(path, offset);
                 })
      ->setObjectName(QStringLiteral("alignEvent"));
}

void TimeLineView::repair(const QString& path) {
  const auto* log = logs_.find(path.toStdString());
  if (log == nullptr) return;
  const FileQuestion question{"repairDialog", tr("Repair into a new log"),
                              suggested(*log, QStringLiteral("-repaired.mcap")), tr("Logs (*.mcap)")};
  askForFile(question, [this, from = log->path](const QString& file) {
    job_->start(tr("Repairing into %1").arg(QFileInfo(file).fileName()), repairLog(from, file.toStdString()));
  });
}

}  // namespace widgets
