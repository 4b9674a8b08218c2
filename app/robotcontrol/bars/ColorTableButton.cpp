// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/ColorTableButton.h"

#include <QDateTime>
#include <QMenu>
#include <QStyle>
#include <optional>

#include "app/core/program/ColorTables.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/debugging/ColorTableInUse.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

constexpr int kMaxCharacters = 16;

/// The table that the selected robot's program reports, or that a log holds for a program that does not run
/// here.
std::optional<robotcontrol::ColorTable> tableInUse(robotlink::Session& session) {
  const std::string robot = session.selectedRobot() + '/';
  const auto newest = session.timeline().newest();
  const auto latest = [&](const std::string& stream) {
    return session.store().latestAs<robotcontrol::ColorTable>(robot + stream, newest);
  };
  if (const auto* said = latest(robotlink::streams::kColorTableInUse)) return *said;
  const auto* logged = latest(robotlink::kColorTable.name);
  if (logged == nullptr) return std::nullopt;
  robotcontrol::ColorTable table = robotlink::colorTableInUse(logged);
  if (table.source() != robotlink::kBuiltInColorTable) table.set_source(kOfTheLog);
  return table;
}

}  // namespace

ColorTableButton::ColorTableButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("colorTableButton"));
  setAccessibleName(tr("Color table in use"));
  setPopupMode(QToolButton::InstantPopup);
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  setFocusPolicy(Qt::NoFocus);
  setMenu(new QMenu(this));
}

/// Includes room for the menu's arrow, which Qt paints over the end of a text.
QSize ColorTableButton::sizeHint() const {
  return QToolButton::sizeHint() +
         QSize(style()->pixelMetric(QStyle::PM_MenuButtonIndicator, nullptr, this), 0);
}

QString ColorTableButton::shortName(const QString& source) {
  return source.section(QLatin1Char('/'), -1);
}

bool ColorTableButton::refresh(robotlink::Session& session) {
  const auto table = tableInUse(session);
  if (table) show(*table);
  return table.has_value();
}

void ColorTableButton::show(const robotcontrol::ColorTable& table) {
  const QString source = QString::fromStdString(table.source());
  const QString loaded = table.has_loaded() ? QDateTime::fromSecsSinceEpoch(table.loaded().seconds())
                                                  .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"))
                                            : QString();
  QString shown = source + QLatin1Char('\n') + loaded;
  if (shown == shown_) return;
  shown_ = std::move(shown);
  const QString name = fontMetrics().elidedText(shortName(source), Qt::ElideMiddle,
                                                fontMetrics().averageCharWidth() * kMaxCharacters);
  setText(tr("Colors: %1").arg(name));
  QString tip = table.source() == robotlink::kBuiltInColorTable
                    ? tr("The robot's program uses its built-in color table, made from the field's colors")
                    : tr("The color table that the robot's program uses: %1").arg(source);
  if (!loaded.isEmpty()) tip += QLatin1Char('\n') + tr("loaded %1").arg(loaded);
  setToolTip(tip + QLatin1Char('\n') + tr("Click to use another one"));
}

}  // namespace app
