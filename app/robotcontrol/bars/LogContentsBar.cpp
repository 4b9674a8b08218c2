// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/LogContentsBar.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "app/robotcontrol/actions/CommandActions.h"
#include "widgets/log/OpenLogs.h"

namespace app {
namespace {

constexpr int kMaxNamed = 3;

/// The first paths, and the number of further ones.
QString named(const QStringList& paths) {
  if (paths.size() <= kMaxNamed) return paths.join(QLatin1String(", "));
  return LogContentsBar::tr("%1 and %2 more")
      .arg(paths.mid(0, kMaxNamed).join(QLatin1String(", ")))
      .arg(paths.size() - kMaxNamed);
}

}  // namespace

LogContentsBar::LogContentsBar(widgets::OpenLogs& logs, CommandActions& actions, QWidget* parent)
    : QWidget(parent), logs_(logs), text_(new QLabel(this)) {
  setObjectName(QStringLiteral("logContentsBar"));
  text_->setObjectName(QStringLiteral("logContentsText"));
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(text_, 1);
  const auto add = [&](const char* view, const QString& text, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("logContents.") + QLatin1String(view));
    button->setText(text);
    button->setToolTip(tip);
    connect(button, &QToolButton::clicked, this,
            [&actions, view] { actions.run(QStringLiteral("view.show"), {std::string(view)}); });
    layout->addWidget(button);
  };
  add("log-streams", tr("Streams"), tr("Shows the view that lists all streams with their types"));
  add("plots", tr("Plots"), tr("Shows the view that plots numbers of the streams"));
  hide();
}

void LogContentsBar::refresh() {
  if (shownVersion_ == logs_.version()) return;
  shownVersion_ = logs_.version();
  QStringList lines;
  for (const auto& log : logs_.logs()) {
    const bool known = log->overview && log->overview->stage != widgets::LogOverview::Stage::kOpening;
    if (known && log->overview->robots.empty()) lines << textOf(*log->overview);
  }
  text_->setText(lines.join(QLatin1Char('\n')));
  setVisible(!lines.isEmpty());
}

QString LogContentsBar::textOf(const widgets::LogOverview& overview) const {
  const QString name = QFileInfo(QString::fromStdString(overview.file)).fileName();
  QStringList shown, undecoded;
  for (const auto& stream : overview.streams) {
    const QString path = QString::fromStdString(stream.path);
    if (stream.undecoded.empty()) {
      shown << path;
    } else {
      undecoded << tr("%1 (%2)").arg(path, QString::fromStdString(stream.undecoded));
    }
  }
  if (overview.streams.empty()) return tr("%1 holds no messages.").arg(name);
  QString text = tr("%1 contains no known robot, so no program runs on it.").arg(name);
  if (!shown.isEmpty()) text += QLatin1Char(' ') + tr("It holds %1.").arg(named(shown));
  if (!undecoded.isEmpty()) text += QLatin1Char(' ') + tr("Not decoded: %1.").arg(named(undecoded));
  return text;
}

}  // namespace app
