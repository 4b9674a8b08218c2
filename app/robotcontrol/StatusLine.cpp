// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/StatusLine.h"

#include <QLabel>
#include <QStatusBar>

#include "app/core/Workbench.h"
#include "robotcontrol/Requests.pb.h"

namespace app {
namespace {

QLabel* addLabel(QStatusBar& bar, const char* name, const QString& tip, int characters) {
  auto* label = new QLabel(&bar);
  label->setObjectName(QLatin1String(name));
  label->setToolTip(tip);
  label->setMinimumWidth(label->fontMetrics().averageCharWidth() * characters);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bar.addPermanentWidget(label);
  return label;
}

}  // namespace

StatusLine::StatusLine(Workbench& workbench, QStatusBar& bar)
    : QObject(&bar),
      workbench_(workbench),
      state_(addLabel(bar, "statusState", tr("What the simulation does"), 10)),
      time_(addLabel(bar, "statusTime", tr("Simulated time"), 12)),
      speed_(addLabel(bar, "statusSpeed", tr("How many times real time the simulation runs"), 10)),
      contacts_(addLabel(bar, "statusContacts", tr("How often a robot and the ball began to touch"), 16)),
      dropped_(addLabel(bar, "statusDropped",
                        tr("Messages that were lost because more came than could be taken in"), 12)) {}

void StatusLine::refresh() {
  auto& session = workbench_.session();
  dropped_->setText(tr("%1 dropped").arg(session.dropped()));
  const auto* status = session.store().latestAs<robotcontrol::SimulationStatus>("simulation", session.timeline().newest());
  if (status == nullptr) {
    state_->setText(workbench_.loading() ? tr("loading…") : tr("no simulation"));
    return;
  }
  state_->setText(workbench_.loading()               ? tr("loading…")
                  : status->stopped_robots_size() > 0 ? tr("STOP engaged")
                  : status->running()                 ? tr("running")
                                                      : tr("paused"));
  time_->setText(tr("%1 s").arg(status->time(), 0, 'f', 3));
  speed_->setText(tr("sim %1×").arg(status->speed(), 0, 'f', 1));
  const auto contacts = status->ball_contacts();
  contacts_->setText(contacts == 1 ? tr("1 ball contact") : tr("%1 ball contacts").arg(contacts));
}

}  // namespace app
