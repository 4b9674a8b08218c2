// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/BaseSilence.h"

#include <QCoreApplication>

#include "robotlink/packages/Packages.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {

std::optional<double> baseSilence(const robotlink::StreamStore& store, const std::string& robot,
                                  robotlink::Instant shown) {
  const auto* heard = store.latest(robot + '/' + robotlink::kDriveState.name, shown);
  const double silence = heard == nullptr ? 0 : robotlink::seconds(shown - heard->time);
  return silence > kSilentAfter ? std::optional(silence) : std::nullopt;
}

QString silenceText(const std::string& robot, std::optional<double> silence) {
  if (!silence) return {};
  return QCoreApplication::translate("Silence", "%1 last heard %2 s ago")
      .arg(QString::fromStdString(robot))
      .arg(*silence, 0, 'f', 0);
}

}  // namespace widgets
