// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/RecordedBar.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QUrl>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/bars/RecordingToolBar.h"
#include "widgets/Icon.h"

namespace app {

using robotcontrol::RecordingStatus;

RecordedBar::RecordedBar(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      actions_(actions),
      saved_(workbench.recording().status().saved_path()) {
  setObjectName(QStringLiteral("recordedBar"));
  createWidgets();
  hide();
}

void RecordedBar::createWidgets() {
  text_ = new QLabel(this);
  text_->setObjectName(QStringLiteral("recordedText"));
  text_->setAccessibleName(tr("Where the recording went"));
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // The whole path is in the tooltip; a long one must not widen the window.
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(text_, 1);
  const auto add = [&](const char* name, const char* icon, const QString& text, const QString& help) {
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setIcon(widgets::icon(icon));
    button->setText(text);
    button->setToolTip(help);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    layout->addWidget(button);
    return button;
  };
  connect(add("recordedOpen", "time-line", tr("Open"),
              tr("Opens the recording as a log, in place of what is open now")),
          &QToolButton::clicked, this, &RecordedBar::open);
  connect(
      add("recordedFolder", "open", tr("Show in folder"), tr("Opens the folder that the recording is in")),
      &QToolButton::clicked, this, &RecordedBar::showFolder);
  auto* dismiss = add("recordedDismiss", "close", tr("Dismiss"), tr("Hides this"));
  dismiss->setToolButtonStyle(Qt::ToolButtonIconOnly);
  connect(dismiss, &QToolButton::clicked, this, &QWidget::hide);
}

void RecordedBar::refresh() {
  const RecordingStatus status = workbench_.recording().status();
  noticeRecording(status);
  noticeSaved(status);
}

void RecordedBar::noticeRecording(const RecordingStatus& status) {
  if (status.recording()) {
    if (!recording_) {
      files_.clear();
      hide();
    }
    recording_ = true;
    if (!status.path().empty() && (files_.empty() || files_.back() != status.path()))
      files_.push_back(status.path());
    return;
  }
  if (!recording_ || status.queued_bytes() > 0) return;  // not everything is written yet
  recording_ = false;
  if (files_.empty()) return;
  const QString how = status.failure().empty()
                          ? tr("Recorded")
                          : tr("The recording ended early (%1), and is readable up to there:")
                                .arg(QString::fromStdString(status.failure()));
  const int others = static_cast<int>(files_.size()) - 1;
  const QString more =
      others > 0 ? tr(" (the last of %1 files: each reset starts a new one)").arg(others + 1) : QString();
  const QString length = RecordingToolBar::lengthText(status);
  showFile(QString::fromStdString(files_.back()),
           [&](const QString& place) { return tr("%1 %2 into %3").arg(how, length, place) + more; });
}

void RecordedBar::noticeSaved(const RecordingStatus& status) {
  if (status.saved_path() == saved_) return;
  saved_ = status.saved_path();
  if (!saved_.empty())
    showFile(QString::fromStdString(saved_),
             [](const QString& place) { return tr("The last seconds are in %1").arg(place); });
}

void RecordedBar::showFile(const QString& file, const std::function<QString(const QString& place)>& text) {
  file_ = file;
  const QFileInfo info(file);
  text_->setText(text(tr("%1, in %2").arg(info.fileName(), QDir::toNativeSeparators(info.absolutePath()))));
  text_->setToolTip(QDir::toNativeSeparators(info.absoluteFilePath()));
  show();
}

void RecordedBar::open() {
  workbench_.recording().recorder().finish();  // a log is complete when its summary is written
  hide();
  actions_.run(QStringLiteral("log.open"), {QFileInfo(file_).absoluteFilePath().toStdString()});
}

void RecordedBar::showFolder() {
  const QString folder = QFileInfo(file_).absolutePath();
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) {
    Q_EMIT actions_.refused(tr("No file manager was found on this computer. The recording is %1").arg(file_));
  }
}

}  // namespace app
