// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/RecordingToolBar.h"

#include <QActionGroup>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <cmath>
#include <utility>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/StreamChooser.h"
#include "logplayer/base/RecordedStreams.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/Icon.h"

namespace app {

using robotcontrol::ControlRecording;
using robotcontrol::RecordingStatus;

namespace {

QString duration(double seconds) {
  const int whole = static_cast<int>(seconds);
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString megabytes(std::uint64_t bytes) {
  return RecordingToolBar::tr("%1 MB").arg(1e-6 * static_cast<double>(bytes), 0, 'f', 1);
}

QString labelOf(ControlRecording::ImageCoding coding) {
  return coding == ControlRecording::JPEG  ? QStringLiteral("jpeg")
         : coding == ControlRecording::PNG ? QStringLiteral("png")
                                           : QStringLiteral("as-is");
}

QString labelOf(ControlRecording::Compression compression) {
  return compression == ControlRecording::LZ4    ? QStringLiteral("lz4")
         : compression == ControlRecording::ZSTD ? QStringLiteral("zstd")
                                                 : QStringLiteral("none");
}

void check(const QActionGroup& group, const QVariant& value) {
  for (QAction* action : group.actions()) action->setChecked(action->data() == value);
}

}  // namespace

RecordingToolBar::RecordingToolBar(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QToolBar(tr("Recording"), parent), workbench_(workbench), actions_(actions) {
  setObjectName(QStringLiteral("recordingToolBar"));
  createActions();
  createMenu();
  createWidgets();
  refresh();
}

void RecordingToolBar::createActions() {
  record_ = actions_.make(tr("Record"), "record", QStringLiteral("recording.toggle"), {},
                          {QKeySequence(QStringLiteral("Ctrl+Shift+R"))});
  record_->setCheckable(true);
  saveLast_ = actions_.make(tr("Save the last seconds"), "save", QStringLiteral("recording.save-last"), {},
                            {QKeySequence(QStringLiteral("Ctrl+Shift+S"))});
  bookmark_ = new QAction(widgets::icon("bookmark-recording"), tr("Mark this instant…"), this);
  bookmark_->setObjectName(QStringLiteral("recording.bookmark"));
  bookmark_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+B")));
  bookmark_->setShortcutContext(Qt::ApplicationShortcut);
  bookmark_->setToolTip(
      tr("Marks the shown instant in the recording; without one, saves the last seconds with the mark (%1)")
          .arg(bookmark_->shortcut().toString(QKeySequence::NativeText)));
  connect(bookmark_, &QAction::triggered, this, &RecordingToolBar::bookmark);
}

QActionGroup* RecordingToolBar::addChoices(const QString& title, const char* icon, const char* command,
                                           const std::vector<Choice>& choices) {
  QMenu* menu = menu_->addMenu(widgets::icon(icon), title);
  menu->setObjectName(QLatin1String(command));
  auto* group = new QActionGroup(menu);
  for (const Choice& choice : choices) {
    QAction* action = menu->addAction(choice.text);
    action->setObjectName(QLatin1String(command) + QLatin1Char('.') + choice.value.toString());
    action->setCheckable(true);
    action->setData(choice.value);
    group->addAction(action);
  }
  connect(group, &QActionGroup::triggered, this, [this, name = QLatin1String(command)](QAction* chosen) {
    if (chosen->data().type() == QVariant::Double) return actions_.run(name, {chosen->data().toDouble()});
    actions_.run(name, {chosen->data().toString().toStdString()});
  });
  return group;
}

void RecordingToolBar::createMenu() {
  menu_ = new QMenu(tr("Re&cording"), this);
  menu_->setObjectName(QStringLiteral("recordingMenu"));
  menu_->setToolTipsVisible(true);
  menu_->addActions({record_, saveLast_, bookmark_});
  menu_->addSeparator();
  keep_ = addChoices(tr("&Keep in memory"), "timing", "recording.keep",
                     {{tr("Nothing"), 0.0},
                      {tr("5 s"), 5.0},
                      {tr("10 s"), 10.0},
                      {tr("30 s"), 30.0},
                      {tr("60 s"), 60.0},
                      {tr("2 min"), 120.0}});
  trigger_ =
      menu_->addAction(widgets::icon("follow"), tr("&Trigger…"), this, &RecordingToolBar::chooseTrigger);
  trigger_->setObjectName(QStringLiteral("recording.trigger"));
  trigger_->setToolTip(tr("Saves the last seconds when a message arrives on a stream you choose"));
  menu_->addSeparator();
  QAction* streams =
      menu_->addAction(widgets::icon("check-all"), tr("&Streams…"), this, &RecordingToolBar::chooseStreams);
  streams->setObjectName(QStringLiteral("recording.streams"));
  streams->setToolTip(tr("What is recorded"));
  images_ = addChoices(tr("&Images"), "image", "recording.images",
                       {{tr("As they are"), QStringLiteral("as-is")},
                        {tr("JPEG (small, lossy)"), QStringLiteral("jpeg")},
                        {tr("PNG (lossless, slow)"), QStringLiteral("png")}});
  compression_ = addChoices(tr("&Compression"), "layers", "recording.compression",
                            {{tr("None"), QStringLiteral("none")},
                             {tr("LZ4 (fast)"), QStringLiteral("lz4")},
                             {tr("Zstandard (small)"), QStringLiteral("zstd")}});
  QAction* folder =
      menu_->addAction(widgets::icon("open"), tr("&Folder…"), this, &RecordingToolBar::chooseFolder);
  folder->setObjectName(QStringLiteral("recording.folder"));
  folder->setToolTip(tr("Where new recordings go"));
}

void RecordingToolBar::createWidgets() {
  auto* button = new QToolButton(this);
  button->setObjectName(QStringLiteral("recordButton"));
  button->setDefaultAction(record_);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setMenu(menu_);
  button->setPopupMode(QToolButton::MenuButtonPopup);
  addWidget(button);
  addAction(saveLast_);
  addAction(bookmark_);
  file_ = new QLabel(this);
  widgets::describe(*file_, {"recordingFile", tr("File of the recording"), {}});
  file_->setMargin(4);
  fileAction_ = addWidget(file_);
  status_ = new QLabel(this);
  widgets::describe(*status_, {"recordingStatus", tr("State of the recording"), {}});
  status_->setMargin(4);
  status_->setMinimumWidth(status_->fontMetrics().horizontalAdvance(tr("0:00  00.0 MB  keeps 30 s")));
  addWidget(status_);
}

QString RecordingToolBar::statusText(const RecordingStatus& status) {
  QStringList parts;
  if (status.recording()) parts << duration(status.seconds()) << megabytes(status.bytes());
  if (status.keep_last() > 0 && status.kept_seconds() > 0)
    parts << tr("keeps %1 s").arg(std::floor(status.kept_seconds()), 0, 'f', 0);
  if (status.dropped_messages() > 0)
    parts << widgets::counted(status.dropped_messages(), tr("1 message dropped"), tr("%1 messages dropped"));
  if (parts.isEmpty()) return status.failure().empty() ? tr("not recording") : tr("recording failed");
  return parts.join(QStringLiteral("  "));
}

QString RecordingToolBar::lengthText(const RecordingStatus& status) {
  return tr("%1 (%2)").arg(duration(status.seconds()), megabytes(status.bytes()));
}

/// Shows the name of the current file, or of the last one.
void RecordingToolBar::refreshFile(const RecordingStatus& status) {
  constexpr int kWidest = 220;  // pixels
  const QFileInfo file(QString::fromStdString(status.path()));
  const QString name = file_->fontMetrics().elidedText(file.fileName(), Qt::ElideLeft, kWidest);
  file_->setText(status.recording() ? name : tr("last: %1").arg(name));
  file_->setToolTip(QDir::toNativeSeparators(file.filePath()));
  fileAction_->setVisible(!status.path().empty());
}

void RecordingToolBar::refresh() {
  const RecordingStatus status = workbench_.recording().status();
  record_->setChecked(status.recording());
  // The text and the icon differ from those of STOP, which stops robots.
  record_->setText(status.recording() ? tr("End recording") : tr("Record"));
  if (std::exchange(showsEnd_, status.recording()) != status.recording()) {
    record_->setIcon(
        widgets::icon(status.recording() ? QStringLiteral("record-end") : QStringLiteral("record")));
  }
  refreshFile(status);
  saveLast_->setEnabled(status.kept_bytes() > 0);
  bookmark_->setEnabled(status.recording() || status.kept_bytes() > 0);
  status_->setText(statusText(status));
  QStringList details;
  if (status.recording()) details << tr("Recording into %1").arg(QString::fromStdString(status.path()));
  if (status.dropped_messages() > 0) {
    details << tr("The disk did not keep up: %1 were dropped").arg(megabytes(status.dropped_bytes()));
  }
  if (!status.recording() && !status.path().empty())
    details << tr("Last: %1").arg(QString::fromStdString(status.path()));
  if (!status.saved_path().empty())
    details << tr("Last seconds saved: %1").arg(QString::fromStdString(status.saved_path()));
  if (!status.failure().empty()) details << QString::fromStdString(status.failure());
  status_->setToolTip(details.isEmpty() ? tr("Nothing has been recorded yet")
                                        : details.join(QLatin1Char('\n')));
  if (!menu_->isVisible()) refreshChoices(status);
}

void RecordingToolBar::refreshChoices(const RecordingStatus& status) {
  check(*images_, labelOf(status.image_coding()));
  check(*compression_, labelOf(status.compression()));
  check(*keep_, status.keep_last());
  trigger_->setText(status.trigger().empty()
                        ? tr("&Trigger…")
                        : tr("&Trigger: %1…").arg(QString::fromStdString(status.trigger())));
}

void RecordingToolBar::chooseStreams() {
  std::vector<std::string> known;
  for (const auto* stream : workbench_.session().store().streams()) known.push_back(stream->path);
  StreamChooser chooser(workbench_.recording().status().selection(), std::move(known), this);
  if (chooser.exec() != QDialog::Accepted) return;
  actions_.run(QStringLiteral("recording.streams"), {logplayer::textOf(chooser.selection())});
}

void RecordingToolBar::chooseTrigger() {
  QStringList streams{QString()};
  for (const auto* stream : workbench_.session().store().streams())
    streams << QString::fromStdString(stream->path);
  const QString now = QString::fromStdString(workbench_.recording().status().trigger());
  if (!streams.contains(now)) streams.insert(1, now);
  bool accepted = false;
  const QString chosen =
      QInputDialog::getItem(this, tr("Trigger"),
                            tr("Saves the last seconds when a message arrives on this stream (* matches any "
                               "text). A debug key must be on to publish. Empty: never."),
                            streams, static_cast<int>(streams.indexOf(now)), true, &accepted);
  if (accepted) actions_.run(QStringLiteral("recording.trigger"), {chosen.trimmed().toStdString()});
}

void RecordingToolBar::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(
      this, tr("Folder for recordings"), QString::fromStdString(workbench_.recording().folder().string()));
  if (!folder.isEmpty()) actions_.run(QStringLiteral("recording.folder"), {folder.toStdString()});
}

void RecordingToolBar::bookmark() {
  // The bookmark has the time of the key press; the dialog for its text may take longer.
  const auto& timeline = workbench_.session().timeline();
  const robotlink::Instant time = timeline.shown();
  bool accepted = false;
  const QString text = QInputDialog::getText(
      this, tr("Mark this instant"),
      tr("What happens at %1 s:").arg(robotlink::seconds(timeline.sinceOrigin(time)), 0, 'f', 3),
      QLineEdit::Normal, {}, &accepted);
  if (!accepted) return;
  if (const auto done = workbench_.recording().bookmark(text.toStdString(), time); !done) {
    Q_EMIT actions_.refused(QString::fromStdString(done.error().text));
  }
}

}  // namespace app
