// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageHint.h"

#include <QCoreApplication>
#include <algorithm>

#include "foxglove/Robot.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

/// So many texts are looked at, the newest ones, since this is done in each tick.
constexpr std::ptrdiff_t kMaxPlatformTexts = 1000;

QString imageSentence(const char* text) {
  return QCoreApplication::translate("ImageHint", text);
}

/// What does not work, as the robot's platform reported it last; empty if it reported something else since.
std::string platformProblem(robotlink::Session& session, const std::string& robot) {
  const auto* stream = session.store().find(robot + '/' + robotlink::streams::kLog);
  if (stream == nullptr) return {};
  const auto& all = stream->messages;
  const auto end =
      std::ranges::upper_bound(all, session.timeline().shown(), {}, &robotlink::StreamMessage::time);
  const auto begin = end - std::min<std::ptrdiff_t>(end - all.begin(), kMaxPlatformTexts);
  for (auto at = end; at != begin;) {
    --at;
    const auto* text = dynamic_cast<const foxglove::Log*>(at->value.get());
    if (text == nullptr || text->name() != robotlink::streams::kPlatformSource) continue;
    return text->level() >= foxglove::Log::WARNING ? text->message() : std::string();
  }
  return {};
}

}  // namespace

QString imageHint(robotlink::Session& session, const std::string& path) {
  const bool exists = session.store().find(path) != nullptr;
  if (session.robots().empty() && !exists && hasForeignStreams(session.store()))
    return imageSentence(
        QT_TRANSLATE_NOOP("ImageHint",
                          "Up to here there are no images in this log. What it has is shown in the "
                          "views Data, Plots, Field and Scene."));
  if (session.robots().empty() && !exists)
    return imageSentence(
        QT_TRANSLATE_NOOP("ImageHint", "No robot. Start a simulation or connect to a robot."));
  const QString none =
      imageSentence(QT_TRANSLATE_NOOP("ImageHint", "No image yet from %1")).arg(QString::fromStdString(path));
  const std::string problem = platformProblem(session, robotPart(path));
  return problem.empty() ? none : none + QStringLiteral(".\n") + QString::fromStdString(problem);
}

}  // namespace widgets
