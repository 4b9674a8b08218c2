// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageHint.h"

#include <QCoreApplication>
#include <algorithm>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"
#include "widgets/View.h"

namespace widgets {
namespace {

/// The number of texts to examine, the newest ones, since this is done in each tick.
constexpr std::ptrdiff_t kMaxPlatformTexts = 1000;

QString imageSentence(const char* text) {
  return QCoreApplication::translate("ImageHint", text);
}

/// The problem that the robot's platform reported last; empty if it reported something else since.
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

/// Whether a robot is known to have no camera: its kind has none, no image of it has arrived, and the scene
/// gives it none.
bool lacksCamera(const ViewContext& context, const std::string& robot) {
  const auto kind = context.robots.find(robot);
  if (kind == context.robots.end() || kind->second == nullptr) return false;
  const auto& offers = kind->second->offers;
  if (std::ranges::find(offers, robotlink::kCameraImage.name) != offers.end()) return false;
  robotlink::Session& session = context.session;
  if (!streamsOfType(session.store(), robot, "foxglove.RawImage").empty()) return false;
  const auto* world = session.store().latestAs<robotcontrol::WorldObjects>(robotlink::streams::kObjects,
                                                                           session.timeline().newest());
  return world == nullptr || std::ranges::none_of(world->objects(), [&](const auto& object) {
           return object.port().robot() == robot && !object.port().image_stream().empty();
         });
}

}  // namespace

QString imageHint(const ViewContext& context, const std::string& path) {
  robotlink::Session& session = context.session;
  const bool exists = session.store().find(path) != nullptr;
  // A simulation of things without programs.
  const bool isScene =
      session.robots().empty() && session.store().find(robotlink::streams::kObjects) != nullptr;
  if (isScene && !exists && !robotlink::streams::robotOf(path).empty())
    return imageSentence(
               QT_TRANSLATE_NOOP("ImageHint",
                                 "There are no images of %1 in this scene. Choose others at the top."))
        .arg(QString::fromStdString(path));
  if (isScene && robotlink::streams::robotOf(path).empty())
    return imageSentence(
        QT_TRANSLATE_NOOP("ImageHint",
                          "There is no robot in this scene. Add one, or a camera, by + in the view Scene, or "
                          "choose other images at the top."));
  if (session.robots().empty() && !exists && hasForeignStreams(session.store()))
    return imageSentence(
        QT_TRANSLATE_NOOP("ImageHint",
                          "The log has no images up to this time. Its contents are shown in the "
                          "views Data, Plots, Field and Scene."));
  if (session.robots().empty() && !exists)
    return imageSentence(
        QT_TRANSLATE_NOOP("ImageHint", "No robot. Start a simulation or connect to a robot."));
  if (const std::string robot = robotlink::streams::robotOf(path); lacksCamera(context, robot))
    return imageSentence(
               QT_TRANSLATE_NOOP("ImageHint",
                                 "%1 has no camera. Choose another robot, or other images at the "
                                 "top. A simulated robot can be given a camera in the scene editor."))
        .arg(QString::fromStdString(robot));
  const QString none =
      imageSentence(QT_TRANSLATE_NOOP("ImageHint", "No image yet from %1")).arg(QString::fromStdString(path));
  const std::string problem = platformProblem(session, robotlink::streams::robotOf(path));
  return problem.empty() ? none : none + QStringLiteral(".\n") + QString::fromStdString(problem);
}

}  // namespace widgets
