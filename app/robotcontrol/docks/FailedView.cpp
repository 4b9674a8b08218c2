// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/FailedView.h"

#include <QLabel>
#include <QVBoxLayout>

namespace app {

FailedView::FailedView(widgets::ViewContext& context, const QString& reason, QJsonObject state,
                       QWidget* parent)
    : View(context, parent), state_(std::move(state)) {
  auto* text = new QLabel(tr("This view has failed: %1.\nClose and reopen it to try again; if it "
                             "belongs to a plug-in, "
                             "report this to its author.")
                              .arg(reason),
                          this);
  text->setObjectName(QStringLiteral("failedView"));
  text->setTextFormat(Qt::PlainText);
  text->setWordWrap(true);
  text->setAlignment(Qt::AlignCenter);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text);
}

}  // namespace app
