// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/OpeningBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"

namespace app {
namespace {

constexpr int kTicksUntilShown = 12;  // 0.4 s

}  // namespace

OpeningBar::OpeningBar(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      text_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
  setObjectName(QStringLiteral("openingBar"));
  progress_->setObjectName(QStringLiteral("openingProgress"));
  progress_->setAccessibleName(tr("Opening"));
  progress_->setRange(0, 1000);
  text_->setObjectName(QStringLiteral("openingText"));
  text_->setTextFormat(Qt::PlainText);
  cancel_->setObjectName(QStringLiteral("openingCancel"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Cancels opening; what was open before stays open"));
  connect(cancel_, &QToolButton::clicked, this, [&actions] { actions.run(QStringLiteral("log.cancel")); });
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(text_);
  layout->addWidget(progress_, 1);
  layout->addWidget(cancel_);
  hide();
}

void OpeningBar::refresh() {
  const auto share = workbench_.progress();
  ticks_ = share ? ticks_ + 1 : 0;
  setVisible(ticks_ > kTicksUntilShown);
  if (!share) return;
  progress_->setValue(static_cast<int>(*share * 1000));
  text_->setText(tr("Opening %1…").arg(QString::fromStdString(workbench_.openingName())));
}

}  // namespace app
