// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/HistoryLine.h"

#include <QMenu>
#include <QStatusBar>
#include <QToolButton>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/Icon.h"
#include "widgets/Theme.h"

namespace app {

HistoryLine::HistoryLine(Workbench& workbench, CommandActions& actions, QStatusBar& bar)
    : QObject(&bar),
      workbench_(workbench),
      actions_(actions),
      button_(new QToolButton(&bar)),
      menu_(new QMenu(tr("&History"), &bar)) {
  button_->setObjectName(QStringLiteral("statusHistory"));
  button_->setAutoRaise(true);
  button_->setFocusPolicy(Qt::TabFocus);
  button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar.addPermanentWidget(button_);
  connect(button_, &QToolButton::clicked, this, &HistoryLine::toggle);

  menu_->setObjectName(QStringLiteral("historyMenu"));
  menu_->setToolTipsVisible(true);
  pause_ = menu_->addAction(widgets::icon("pause"), tr("&Pause what is shown"), this, &HistoryLine::toggle,
                            QKeySequence(QStringLiteral("Ctrl+Space")));
  pause_->setObjectName(QStringLiteral("timeline.toggle"));
  pause_->setCheckable(true);
  pause_->setToolTip(
      tr("All views show one instant, while the robots continue. What you switch, tune or steer "
         "acts on the robots as they are now."));
  const auto add = [&](const QString& text, const char* icon, const char* command, double count,
                       const char* key) {
    menu_->addAction(
        actions_.make(text, icon, QLatin1String(command), {count}, {QKeySequence(QLatin1String(key))}));
  };
  add(tr("Step &back"), "step-back", "timeline.step", -1, "Alt+,");
  add(tr("Step &forward"), "step", "timeline.step", 1, "Alt+.");
  const auto second = [&](const QString& text, const char* icon, double by, const char* key) {
    menu_->addAction(
        widgets::icon(icon), text, this, [this, by] { seekBy(by); }, QKeySequence(QLatin1String(key)));
  };
  second(tr("&1 s back"), "step-back", -1, "Ctrl+Alt+,");
  second(tr("1 &s forward"), "step", 1, "Ctrl+Alt+.");
  menu_->addAction(actions_.make(tr("Return to &now"), "play", QStringLiteral("timeline.live")));
  refresh();
}

bool HistoryLine::available() const {
  auto& session = workbench_.session();
  return !session.robots().empty() && session.store().find(robotlink::streams::kReplay) == nullptr;
}

void HistoryLine::toggle() {
  actions_.run(workbench_.session().timeline().live() ? QStringLiteral("timeline.pause")
                                                      : QStringLiteral("timeline.live"));
  refresh();
}

void HistoryLine::seekBy(double seconds) {
  auto& session = workbench_.session();
  const auto time =
      session.timeline().sinceOrigin(session.history().chosen()) + robotlink::fromSeconds(seconds);
  actions_.run(QStringLiteral("timeline.seek"), {std::max(0.0, robotlink::seconds(time))});
}

void HistoryLine::refresh() {
  auto& session = workbench_.session();
  const bool live = session.timeline().live();
  menu_->setEnabled(available());
  for (QAction* action : menu_->actions()) action->setEnabled(available());
  button_->setVisible(available());
  pause_->setChecked(!live);
  const double behind = robotlink::seconds(session.history().behind());
  const QString text = live                            ? tr("live")
                       : session.history().isReading() ? tr("%1 s behind, reading…").arg(behind, 0, 'f', 1)
                                                       : tr("%1 s behind live").arg(behind, 0, 'f', 1);
  QPalette colors = button_->parentWidget()->palette();
  colors.setColor(QPalette::ButtonText,
                  widgets::colorOf(live ? widgets::Meaning::kMuted : widgets::Meaning::kWarning, colors));
  if (button_->palette() != colors) button_->setPalette(colors);
  if (button_->text() == text) return;
  button_->setText(text);
  button_->setIcon(widgets::icon(live ? "pause" : "play"));
  button_->setAccessibleName(live ? tr("What is shown: live") : tr("What is shown: %1").arg(text));
  button_->setToolTip(live ? tr("Pauses all views, while the robots continue (Ctrl+Space)")
                           : tr("Returns to what happens now (Ctrl+Space).\nThe robots continue: what you "
                                "switch, tune or steer acts on them as they are now."));
}

}  // namespace app
