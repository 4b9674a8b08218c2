// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/OpeningBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "app/core/Workbench.h"
#include "app/robotcontrol/CommandActions.h"

namespace app {
namespace {

constexpr int kTicksUntilShown = 8;  // a quarter of a second

}  // namespace

OpeningBar::OpeningBar(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
  setObjectName(QStringLiteral("openingBar"));
  progress_->setObjectName(QStringLiteral("openingProgress"));
  progress_->setAccessibleName(tr("Opening the log"));
  progress_->setRange(0, 1000);
  cancel_->setObjectName(QStringLiteral("openingCancel"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Gives up opening the log; what was open before goes on"));
  connect(cancel_, &QToolButton::clicked, this, [&actions] { actions.run(QStringLiteral("log.cancel")); });
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(new QLabel(tr("Opening the log…"), this));
  layout->addWidget(progress_, 1);
  layout->addWidget(cancel_);
  hide();
}

void OpeningBar::refresh() {
  const auto share = workbench_.progress();
  ticks_ = share ? ticks_ + 1 : 0;
  setVisible(ticks_ > kTicksUntilShown);
  if (share) progress_->setValue(static_cast<int>(*share * 1000));
}

}  // namespace app
