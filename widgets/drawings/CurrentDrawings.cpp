// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/CurrentDrawings.h"

#include <algorithm>
#include <map>

#include "robotlink/debugging/Streams.h"
#include "robotlink/session/FrameDrawings.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

using robotlink::DrawingKind;

struct DrawnKind {
  const char* folder;
  DrawingKind kind;
};
constexpr DrawnKind kKinds[] = {
    {"image/", DrawingKind::kImage}, {"field/", DrawingKind::kField}, {"robot/", DrawingKind::kRobot}};

}  // namespace

bool isDrawnInShadow(const QString& id) {
  return id.section(QLatin1Char('/'), 1).startsWith(QLatin1String(robotlink::streams::kShadow));
}

double drawingOpacity(const QString& id, bool old) {
  return (old ? kOldDrawingOpacity : 1) * (isDrawnInShadow(id) ? kShadowDrawingOpacity : 1);
}

std::vector<CurrentDrawing> currentDrawings(robotlink::Session& session, const std::string& robot,
                                            const QStringList& ids, robotlink::Instant shown) {
  std::map<std::string, const robotlink::StreamMessage*> byId;
  for (const DrawnKind& kind : kKinds) {
    const QLatin1String folder(kind.folder);
    const auto isOfKind = [&](const QString& id) { return id.startsWith(folder); };
    if (std::none_of(ids.begin(), ids.end(), isOfKind)) continue;
    for (const std::string& drawer : robotlink::withShadows(session.store(), robot)) {
      const std::size_t prefix = robotlink::drawingPrefix(drawer, kind.kind).size();
      // "shadow/kalman/", or empty.
      const std::string shadow = drawer == robot ? "" : drawer.substr(robot.size() + 1) + '/';
      for (const auto* message : robotlink::currentDrawings(session.store(), drawer, kind.kind, shown))
        byId[kind.folder + shadow + message->path.substr(prefix)] = message;
    }
  }
  std::vector<CurrentDrawing> drawings;
  for (const QString& id : ids) {
    const auto found = byId.find(id.toStdString());
    if (found == byId.end()) continue;
    const robotlink::StreamMessage& message = *found->second;
    drawings.push_back({id, robot, message.value, message.time,
                        !robotlink::isOfLatestFrame(session.store(), robot, message, shown)});
  }
  return drawings;
}

}  // namespace widgets
