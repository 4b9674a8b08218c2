// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/StopToolBar.h"

#include <QAction>
#include <QToolButton>

#include "widgets/steering/StopStyle.h"

namespace app {
namespace {

constexpr int kGap = 24;  // pixels, to the item on its left

}  // namespace

StopToolBar::StopToolBar(QAction& stop, QWidget* parent)
    : QToolBar(tr("STOP"), parent), button_(new QToolButton(this)) {
  setObjectName(QStringLiteral("stopToolBar"));
  setMovable(false);
  toggleViewAction()->setVisible(false);  // it cannot be hidden
  auto* gap = new QWidget(this);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  gap->setMinimumWidth(kGap);
  addWidget(gap);
  button_->setObjectName(QStringLiteral("stopButton"));
  button_->setDefaultAction(&stop);
  button_->setToolButtonStyle(Qt::ToolButtonTextOnly);  // the icon's color would be the palette's
  button_->setStyleSheet(widgets::stopStyle(QStringLiteral("QToolButton")));
  addWidget(button_);
  connect(&stop, &QAction::changed, this, &StopToolBar::updateGeometry);  // its text is longer when engaged
}

QSize StopToolBar::minimumSizeHint() const {
  const QMargins margins = contentsMargins();
  constexpr int kFrame = 12;  // what styles put around widgets of toolbars
  return {button_->sizeHint().width() + kGap + kFrame + margins.left() + margins.right(),
          QToolBar::minimumSizeHint().height()};
}

}  // namespace app
