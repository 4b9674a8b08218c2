// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/MapConversions.h"

#include "robotcontrol/Driving.pb.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {
namespace {

using Message = robotcontrol::GroundMap;
using Kind = GroundMap::Place::Kind;

struct KindPair {
  Kind value;
  Message::Place::Kind message;
};

constexpr KindPair kKinds[] = {{Kind::kGoal, Message::Place::GOAL},
                               {Kind::kHome, Message::Place::HOME},
                               {Kind::kDock, Message::Place::DOCK},
                               {Kind::kForbiddenLine, Message::Place::FORBIDDEN_LINE},
                               {Kind::kForbiddenArea, Message::Place::FORBIDDEN_AREA},
                               {Kind::kOther, Message::Place::OTHER}};

Message::Place::Kind kindOf(Kind kind) {
  for (const KindPair& pair : kKinds) {
    if (pair.value == kind) return pair.message;
  }
  return Message::Place::OTHER;
}

Kind kindOf(Message::Place::Kind kind) {
  for (const KindPair& pair : kKinds) {
    if (pair.message == kind) return pair.value;
  }
  return Kind::kOther;
}

void assignLine(Message::Line& to, const GroundMap::Line& from) {
  to.set_x1(from.from.x());
  to.set_y1(from.from.y());
  to.set_x2(from.to.x());
  to.set_y2(from.to.y());
}

GroundMap::Line lineOf(const Message::Line& from) {
  return {{from.x1(), from.y1()}, {from.x2(), from.y2()}};
}

bool isFinite(const GroundMap::Line& line) {
  return line.from.allFinite() && line.to.allFinite();
}

}  // namespace

void assign(Message& to, const GroundMap& from) {
  to.Clear();
  to.set_name(from.name);
  to.mutable_lines()->Reserve(static_cast<int>(from.lines.size()));
  for (const GroundMap::Line& line : from.lines) assignLine(*to.add_lines(), line);
  to.mutable_points()->Reserve(2 * static_cast<int>(from.points.size()));
  for (const Vector2& point : from.points) {
    to.add_points(static_cast<float>(point.x()));
    to.add_points(static_cast<float>(point.y()));
  }
  for (const GroundMap::Place& place : from.places) {
    Message::Place& added = *to.add_places();
    added.set_kind(kindOf(place.kind));
    added.set_type(place.type);
    added.set_name(place.name);
    assign(*added.mutable_pose(), place.pose);
    added.set_has_heading(place.hasHeading);
    assignLine(*added.mutable_extent(), place.extent);
  }
}

GroundMap groundMap(const Message& from) {
  GroundMap map;
  map.name = from.name();
  for (const Message::Line& line : from.lines()) {
    if (isFinite(lineOf(line))) map.lines.push_back(lineOf(line));
  }
  map.points.reserve(static_cast<std::size_t>(from.points_size()) / 2);
  for (int i = 0; i + 1 < from.points_size(); i += 2) {
    const Vector2 point(from.points(i), from.points(i + 1));
    if (point.allFinite()) map.points.push_back(point);
  }
  for (const Message::Place& place : from.places()) {
    GroundMap::Place added{kindOf(place.kind()), place.type(),        place.name(),
                           pose2(place.pose()),  place.has_heading(), lineOf(place.extent())};
    const bool isUsable =
        added.pose.translation().allFinite() && std::isfinite(added.pose.heading) && isFinite(added.extent);
    if (isUsable) map.places.push_back(std::move(added));
  }
  return map;
}

}  // namespace robotlink
