// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/GlobalPosition.h"

namespace robotlink {

/// A map of a building's floor: what blocks the way and the beams, as lines and points, and places with
/// names. Metres and radians, in the map's own frame, which is the frame "field" of a world that is made from
/// it. A plain value, once it is read.
struct GroundMap {
  struct Line {
    Vector2 from = Vector2::Zero(), to = Vector2::Zero();
    bool operator==(const Line&) const = default;
  };
  struct Place {
    enum class Kind { kGoal, kHome, kDock, kForbiddenLine, kForbiddenArea, kOther };
    Kind kind = Kind::kOther;
    std::string type;  ///< as the file has it: "GoalWithHeading"
    std::string name;  ///< may be empty
    Pose2 pose;
    bool hasHeading = false;
    /// The ends of a line; for an area, two opposite corners in a frame that is turned by pose.heading about
    /// the map's origin.
    Line extent;
    bool operator==(const Place&) const = default;
  };
  struct Bounds {
    Vector2 low = Vector2::Zero(), high = Vector2::Zero();
  };

  std::string name;  ///< "office"
  std::vector<Line> lines;
  std::vector<Vector2> points;
  double resolution = 0.02;  ///< how far apart neighbouring points of a wall are, m
  std::vector<Place> places;
  std::optional<GlobalPosition> origin;  ///< of maps that are georeferenced: x points east, y north
  /// What the file has and this reader left out, and what it lacks although its header promises it, each with
  /// its line.
  std::vector<std::string> notes;
  bool incomplete = false;  ///< it has fewer lines or points than its header promises

  /// The bounds of all lines and points; of the places if there are neither. Zero if the map is empty.
  Bounds bounds() const;
  const Place* find(Place::Kind kind) const;            ///< the first of its kind; null: none
  const Place* find(std::string_view placeName) const;  ///< null: none

  /// A file of the "2D-Map" family, as ARIA and MobileSim have them. The counts in its header are not
  /// trusted; what is wrong is reported with file and line. Refused are maps with more lines, or longer ones,
  /// than any building has.
  static tl::expected<GroundMap, Errors> load(const std::filesystem::path& file);
  /// `file` is the name that errors carry; the map is called by its stem.
  static tl::expected<GroundMap, Errors> parse(std::string_view text, const std::string& file);
};

}  // namespace robotlink
