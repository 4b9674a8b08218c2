// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/placement/RobotPlacement.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "simcore/placement/FreeSpace.h"
#include "simcore/world/ModelGeometry.h"

namespace simcore {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;
using Place = GroundMap::Place;

constexpr double kCellSize = 0.05;
/// Clearance around a robot, m.
constexpr double kRoom = 0.1;
/// Half the side of the floor around the origin if nothing bounds it, m.
constexpr double kOpenFloor = 5;
/// Robots drive over obstacles lower than this, m.
constexpr double kFlat = 0.02;
constexpr double kForbiddenWidth = 0.05;
constexpr std::uint64_t kPlaceStream = 0x706C616365;

/// A solid of the world that stands on the floor: seen from above, a rectangle or a circle.
struct FloorSolid {
  Pose2 pose;
  Vector2 size = Vector2::Zero();
  // Above 0 for a circle.
  double radius = 0;
  double low = 0, high = 0;
};

FloorSolid floorSolidOf(const Shape& shape, const Pose3& pose) {
  FloorSolid result;
  const Eigen::Matrix3d& axes = pose.linear();
  const double up = reach(shape, axes, Vector3::UnitZ()), middle = pose.translation().z();
  result.low = middle - up;
  result.high = middle + up;
  // A rectangle along the axis that extends farthest over the floor is tight.
  int longest = 0;
  const auto reachOver = [&](int axis) {
    const Vector3 flat(axes(0, axis), axes(1, axis), 0);
    return flat.norm() < 1e-6 ? 0 : reach(shape, axes, flat.normalized()) * flat.norm();
  };
  for (int axis = 1; axis < 3; ++axis) {
    if (reachOver(axis) > reachOver(longest)) longest = axis;
  }
  const double heading = std::atan2(axes(1, longest), axes(0, longest));
  result.pose = {pose.translation().x(), pose.translation().y(), heading};
  const Vector3 along(std::cos(heading), std::sin(heading), 0), across(-along.y(), along.x(), 0);
  result.size = 2 * Vector2(reach(shape, axes, along), reach(shape, axes, across));
  const bool upright = std::abs(axes(2, 2)) > 1 - 1e-9;
  const bool isRound =
      shape.kind == Shape::Kind::kSphere ||
      (upright && (shape.kind == Shape::Kind::kCylinder || shape.kind == Shape::Kind::kCapsule));
  if (isRound) result.radius = shape.radius;
  return result;
}

/// The floor and the solids on it.
struct Surroundings {
  // The height of the floor.
  std::optional<double> floor;
  std::vector<FloorSolid> solids;

  explicit Surroundings(const WorldDescription& world) {
    for (const ModelInstance& model : world.models) {
      const std::vector<Pose3> links = linksAtStart(*model.type);
      for (std::size_t i = 0; i < links.size(); ++i) {
        for (const CollisionDescription& collision : model.type->links[i].collisions)
          add(collision.shape, model.poseInWorld * links[i] * collision.poseInLink);
      }
    }
  }

 private:
  void add(const Shape& shape, const Pose3& pose) {
    if (shape.kind != Shape::Kind::kPlane) {
      solids.push_back(floorSolidOf(shape, pose));
    } else if (pose.linear()(2, 2) > 1 - 1e-9) {
      floor = std::max(floor.value_or(pose.translation().z()), pose.translation().z());
    }
  }
};

/// The grid of a floor with the obstacles of robots of an extent, above `floor`.
ClearanceGrid gridOf(const Surroundings& around, const ModelExtent& robot, const GroundMap* map) {
  const double low = *around.floor + kFlat, high = *around.floor + robot.high - robot.low;
  const auto isInTheWay = [&](const FloorSolid& solid) { return solid.high > low && solid.low < high; };
  Eigen::AlignedBox2d bounds;
  for (const FloorSolid& solid : around.solids) {
    if (!isInTheWay(solid)) continue;
    const double half = solid.radius > 0 ? solid.radius : solid.size.norm() / 2;
    const Vector2 middle = solid.pose.translation();
    // Long walls count by their corners rather than by the circle around them.
    if (solid.radius > 0) {
      bounds.extend(middle - Vector2(half, half)).extend(middle + Vector2(half, half));
      continue;
    }
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5})
        bounds.extend(solid.pose * Vector2(x * solid.size.x(), y * solid.size.y()));
    }
  }
  // Solids on a floor do not necessarily enclose anything.
  if (map == nullptr || bounds.isEmpty())
    bounds.extend(Vector2(-kOpenFloor, -kOpenFloor)).extend(Vector2(kOpenFloor, kOpenFloor));
  ClearanceGrid grid(bounds.min(), bounds.max(), kCellSize);
  for (const FloorSolid& solid : around.solids) {
    if (!isInTheWay(solid)) continue;
    if (solid.radius > 0)
      grid.markCircle(solid.pose.translation(), solid.radius);
    else
      grid.markRectangle(solid.pose, solid.size);
  }
  return grid;
}

void markForbidden(const Place& place, ClearanceGrid& grid) {
  const Vector2 from = place.extent.from, to = place.extent.to;
  const Vector2 middle = (from + to) / 2, size = (to - from).cwiseAbs();
  if (place.kind == Place::Kind::kForbiddenLine) {
    const Vector2 along = to - from;
    grid.markRectangle({middle.x(), middle.y(), std::atan2(along.y(), along.x())},
                       {along.norm(), kForbiddenWidth});
  } else if (place.kind == Place::Kind::kForbiddenArea) {
    grid.markRectangle(Pose2{0, 0, place.pose.heading} * Pose2{middle.x(), middle.y(), 0}, size);
  }
}

/// Chooses positions for one robot after the other.
class Placer {
 public:
  /// `start` is a position from which all others can be reached, if there is one.
  Placer(const ClearanceGrid& grid, const ModelExtent& extent, std::optional<Vector2> start,
         std::uint64_t seed)
      : grid_(grid),
        radius_(extent.radius + kRoom),
        space_(grid, radius_, start),
        random_(seed, kPlaceStream) {}

  /// The first free home, otherwise any free position; homes that were tried are removed.
  std::optional<Pose2> next(std::deque<Pose2>& homes) {
    while (!homes.empty()) {
      const Pose2 home = homes.front();
      homes.pop_front();
      if (const auto place = placeAt(home.translation())) return take({place->x(), place->y(), home.heading});
    }
    const auto place = space_.pick(taken_, 2 * radius_, random_);
    if (!place) return std::nullopt;
    return take({place->x(), place->y(), space_.headingAt(*place, random_)});
  }

 private:
  /// The point itself if a robot fits there, otherwise the nearest free position; empty if another robot is
  /// there.
  std::optional<Vector2> placeAt(const Vector2& point) const {
    const auto cell = grid_.cellAt(point);
    // Clearances count from the center of a cell, which is up to 0.71 cells away from the point.
    const bool fits = grid_.contains(cell) && grid_.clearance(cell) >= radius_ - kRoom + grid_.cellSize();
    const auto place = fits ? point : space_.nearest(point);
    if (!place) return std::nullopt;
    const bool isTaken = std::ranges::any_of(
        taken_, [&](const Vector2& other) { return (other - *place).norm() < 2 * radius_; });
    return isTaken ? std::nullopt : place;
  }

  Pose2 take(const Pose2& pose) {
    taken_.push_back(pose.translation());
    return pose;
  }

  const ClearanceGrid& grid_;
  double radius_;
  FreeSpace space_;
  robotlink::Random random_;
  std::vector<Vector2> taken_;
};

/// The homes of a team's robots on a field.
std::deque<Pose2> homesOf(const WorldDescription& world, const std::string& team) {
  std::deque<Pose2> homes;
  for (const ModelInstance& model : world.models) {
    for (const HomeDescription& home : model.type->homes) {
      if (home.team.empty() || home.team == team)
        homes.push_back(robotlink::groundPose(model.poseInWorld) * home.place);
    }
  }
  return homes;
}

std::deque<Pose2> homesOf(const GroundMap& map) {
  std::deque<Pose2> homes;
  for (const Place& place : map.places) {
    if (place.kind == Place::Kind::kHome) homes.push_back(place.pose);
  }
  return homes;
}

/// Robots with common properties: the prefix of their names, their color, and their homes.
struct Group {
  std::string prefix;
  // In the palette; empty if there is none.
  std::string color;
  std::deque<Pose2> homes;
  int robots = 0;
  int lastNumber = 0;
};

/// A group for each team, or one for all robots.
std::vector<Group> groupsOf(const WorldDescription& world, const GroundMap* map, const ModelDescription& type,
                            const RobotsToAdd& robots) {
  std::vector<Group> groups;
  if (wearsTeamColor(type)) {
    for (const std::string& team : robots.teams) {
      Group& group = groups.emplace_back(Group{team, team, homesOf(world, team)});
      group.robots = static_cast<int>(std::ranges::count(world.models, team, &ModelInstance::teamColorName));
    }
  }
  if (groups.empty()) {
    const std::string& prefix = robots.namePrefix.empty() ? robots.model : robots.namePrefix;
    groups.push_back({prefix, {}, homesOf(world, {})});
  }
  if (map != nullptr) groups.front().homes = homesOf(*map);
  return groups;
}

std::string freeName(const WorldDescription& world, const std::string& prefix, int& number) {
  std::string name;
  do {
    name = prefix + std::to_string(++number);
  } while (std::ranges::find(world.models, name, &ModelInstance::name) != world.models.end());
  return name;
}

ModelInstance robotAt(const Pose2& place, double height, const std::shared_ptr<const ModelDescription>& type,
                      const std::string& file) {
  ModelInstance model;
  model.type = type;
  model.poseInWorld =
      Eigen::Translation3d(place.x, place.y, height) * Eigen::AngleAxisd(place.heading, Vector3::UnitZ());
  model.where = {file, 0, 0};
  return model;
}

/// Sets the team's color, if there is a team.
robotlink::Result<void> dress(ModelInstance& robot, const std::string& color, const Palette& palette) {
  if (color.empty()) return {};
  const auto found = palette.find(color);
  if (found == palette.end()) {
    return robotlink::failure("scene.color",
                              "no palette of the scene has the color '" + color + "' of a team", robot.where,
                              {color});
  }
  robot.teamColorName = color;
  robot.teamColor = found->second;
  return {};
}

}  // namespace

bool wearsTeamColor(const ModelDescription& type) {
  return std::ranges::any_of(type.links, [](const LinkDescription& link) {
    return std::ranges::any_of(link.visuals, &VisualDescription::teamColor);
  });
}

robotlink::Result<void> addRobots(WorldDescription& world, const GroundMap* map,
                                  const std::shared_ptr<const ModelDescription>& type,
                                  const RobotsToAdd& robots, const Palette& palette,
                                  const std::string& file) {
  const Surroundings around(world);
  if (!around.floor) {
    return robotlink::failure("scene.no-floor",
                              "robots cannot be added here: the scene has no level plane as its floor on "
                              "which they could stand",
                              {file, 0, 0});
  }
  const ModelExtent extent = extentOf(*type);
  ClearanceGrid grid = gridOf(around, extent, map);
  if (map != nullptr) {
    for (const Place& place : map->places) markForbidden(place, grid);
  }
  grid.findClearances();
  std::vector<Group> groups = groupsOf(world, map, *type, robots);
  const std::deque<Pose2>& homes = groups.front().homes;
  Placer placer(grid, extent, homes.empty() ? std::nullopt : std::optional(homes.front().translation()),
                robots.seed);
  for (int i = 0; i < robots.count; ++i) {
    Group& group = *std::ranges::min_element(groups, {}, &Group::robots);
    const auto place = placer.next(group.homes);
    if (!place) {
      return robotlink::failure("scene.no-room",
                                "there is room for " + std::to_string(i) + " of the " +
                                    std::to_string(robots.count) + " robots: add fewer",
                                {file, 0, 0}, {std::to_string(i), std::to_string(robots.count)});
    }
    ModelInstance model = robotAt(*place, *around.floor - extent.low, type, file);
    model.name = freeName(world, group.prefix, group.lastNumber);
    if (auto dressed = dress(model, group.color, palette); !dressed) return dressed;
    world.models.push_back(std::move(model));
    ++group.robots;
  }
  return {};
}

}  // namespace simcore
