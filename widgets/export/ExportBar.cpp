// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ExportBar.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QUrl>

#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/export/ViewExport.h"

namespace widgets {
namespace {

constexpr int kExportSteps = 1000;

QToolButton* makeTextButton(QWidget* parent, const ControlText& text, const char* icon) {
  auto* button = new QToolButton(parent);
  describe(*button, text);
  button->setText(text.text);
  button->setIcon(widgets::icon(icon));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  return button;
}

}  // namespace

ExportBar::ExportBar(ViewExport& exporting, QWidget* parent)
    : QWidget(parent), export_(exporting), text_(new QLabel(this)), progress_(new QProgressBar(this)) {
  setObjectName(QStringLiteral("exportBar"));
  text_->setObjectName(QStringLiteral("exportText"));
  text_->setAccessibleName(tr("Export of a view"));
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // The whole path is in the tooltip; a long one must not widen the window.
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  progress_->setObjectName(QStringLiteral("exportProgress"));
  progress_->setAccessibleName(tr("Progress of the export"));
  progress_->setRange(0, kExportSteps);
  cancel_ = makeTextButton(
      this, {"exportCancel", tr("Cancel"), tr("Cancels the export; a video is deleted, written images stay")},
      "close");
  folder_ = makeTextButton(
      this, {"exportFolder", tr("Show in folder"), tr("Opens the folder with the exported files")}, "open");
  dismiss_ = makeTextButton(this, {"exportDismiss", tr("Dismiss"), tr("Hides this")}, "close");
  dismiss_->setToolButtonStyle(Qt::ToolButtonIconOnly);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->addWidget(text_, 1);
  row->addWidget(progress_, 1);
  for (QToolButton* button : {cancel_, folder_, dismiss_}) row->addWidget(button);
  connect(cancel_, &QToolButton::clicked, this, [this] { export_.cancel(); });
  connect(folder_, &QToolButton::clicked, this, &ExportBar::showFolder);
  connect(dismiss_, &QToolButton::clicked, this, &QWidget::hide);
  hide();
}

void ExportBar::tick() {
  if (export_.isBusy()) {
    text_->setText(export_.title());
    progress_->setValue(static_cast<int>(export_.share() * kExportSteps));
    progress_->show();
    cancel_->show();
    folder_->hide();
    dismiss_->hide();
    return show();
  }
  const auto outcome = export_.takeOutcome();
  if (!outcome) return;
  target_ = outcome->target;
  text_->setText(outcome->text);
  text_->setToolTip(QDir::toNativeSeparators(target_.isEmpty() ? outcome->text : target_));
  progress_->hide();
  cancel_->hide();
  folder_->setVisible(!target_.isEmpty());
  dismiss_->show();
  show();
}

void ExportBar::showFolder() {
  const QFileInfo target(target_);
  const QString folder = target.isDir() ? target.absoluteFilePath() : target.absolutePath();
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
    text_->setText(tr("No file manager was found on this computer. The export is in %1")
                       .arg(QDir::toNativeSeparators(target_)));
}

}  // namespace widgets
