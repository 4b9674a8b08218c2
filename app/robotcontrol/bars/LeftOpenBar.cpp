// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/LeftOpenBar.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/platform/PlatformFeed.h"
#include "app/core/remote/RemoteRobots.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "widgets/Controls.h"

namespace app {
namespace {

constexpr char kSources[] = "sources", kLayout[] = "layout", kServers[] = "servers", kProcess[] = "process";

QStringList sourcesOf(const LoadedPlatform* loaded) {
  QStringList sources;
  if (loaded == nullptr) return sources;
  for (const std::string& source : loaded->sources) sources << QString::fromStdString(source);
  return sources;
}

QStringList serversOf(const Workbench& workbench) {
  QStringList servers;
  for (const auto& connection : workbench.remote().connections())
    servers << QString::fromStdString(connection.url);
  return servers;
}

/// Whether another workbench, which has kept this, still runs.
bool isHeldByAnother(const QJsonObject& left) {
  const auto process = static_cast<qint64>(left.value(QLatin1String(kProcess)).toDouble());
  if (process <= 0 || process == QCoreApplication::applicationPid()) return false;
  // The system may have reused the process id for another program.
  const auto programOf = [](qint64 of) {
    return QFileInfo(QStringLiteral("/proc/%1/exe").arg(of)).symLinkTarget();
  };
  return !programOf(process).isEmpty() && programOf(process) == programOf(QCoreApplication::applicationPid());
}

QStringList textsIn(const QJsonObject& from, const char* name) {
  return from.value(QLatin1String(name)).toVariant().toStringList();
}

}  // namespace

LeftOpenBar::LeftOpenBar(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QWidget(parent), workbench_(workbench), actions_(actions) {
  setObjectName(QStringLiteral("leftOpenBar"));
  text_ = new QLabel(this);
  text_->setObjectName(QStringLiteral("leftOpenText"));
  text_->setAccessibleName(tr("What was open"));
  text_->setTextFormat(Qt::PlainText);
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* again = widgets::makeAction(
      this, "reset",
      {"leftOpenAgain", tr("Open it again"), tr("Opens what was open before, in place of what is open now")});
  auto* dismiss = widgets::makeAction(this, "close", {"leftOpenDismiss", tr("Dismiss"), tr("Hides this")});
  connect(again, &QAction::triggered, this, &LeftOpenBar::open);
  connect(dismiss, &QAction::triggered, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(text_, 1);
  layout->addWidget(widgets::makeLabeledButton(this, again));
  layout->addWidget(widgets::makeButton(this, dismiss));
  hide();
}

QJsonObject LeftOpenBar::stateOf(const Workbench& workbench) {
  const LoadedPlatform* loaded = workbench.loaded();
  const QStringList sources = sourcesOf(loaded), servers = serversOf(workbench);
  if (sources.isEmpty() && servers.isEmpty()) return {};
  QJsonObject state{{QLatin1String(kSources), QJsonArray::fromStringList(sources)},
                    {QLatin1String(kServers), QJsonArray::fromStringList(servers)},
                    {QLatin1String(kProcess), static_cast<double>(QCoreApplication::applicationPid())}};
  // The layouts of single robots are remembered with the scene.
  if (loaded != nullptr && !loaded->layout.empty() && loaded->otherLayouts.empty())
    state.insert(QLatin1String(kLayout), QString::fromStdString(loaded->layout.string()));
  return state;
}

void LeftOpenBar::offer(const QJsonObject& left) {
  if (isHeldByAnother(left)) return;
  sources_ = textsIn(left, kSources);
  servers_ = textsIn(left, kServers);
  layout_ = left.value(QLatin1String(kLayout)).toString();
  const QStringList all = sources_ + servers_;
  if (all.isEmpty()) return;
  const QFileInfo first(all.front());
  const QString name = first.exists() ? first.fileName() : all.front();
  text_->setText((all.size() == 1 ? tr("RobotControl did not end properly while %1 was open.").arg(name)
                                  : tr("RobotControl did not end properly while %1 and %2 more were open.")
                                        .arg(name)
                                        .arg(all.size() - 1)));
  text_->setToolTip(all.join(QLatin1Char('\n')));
  show();
}

void LeftOpenBar::noticeOpened() {
  if (isHidden()) return;
  const QStringList connected = serversOf(workbench_);
  const auto isConnected = [&](const QString& url) { return connected.contains(url); };
  const bool sourcesAreOpen = sources_.isEmpty() || sourcesOf(workbench_.loaded()) == sources_;
  if (sourcesAreOpen && std::all_of(servers_.begin(), servers_.end(), isConnected)) hide();
}

void LeftOpenBar::open() {
  hide();
  for (const QString& url : servers_) actions_.run(QStringLiteral("remote.connect"), {url.toStdString()});
  if (sources_.isEmpty()) return;
  PlatformChoices choices;
  for (const QString& source : sources_) choices.sources.push_back(source.toStdString());
  if (!layout_.isEmpty()) choices.values["layout"] = layout_.toStdString();
  auto opening = openingOf(choices);
  if (!opening) return Q_EMIT actions_.refused(QString::fromStdString(opening.error().describe()));
  workbench_.open(std::move(*opening));
}

}  // namespace app
