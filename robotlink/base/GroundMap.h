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

/// The map of a building's floor: lines and points that block the way and the beams of range sensors, and
/// named places. Meters and radians in the map's own frame, which becomes the frame "field" of a world that
/// is built from it. A plain value; immutable by convention once it is read.
struct GroundMap {
  /// A wall or another straight obstacle.
  struct Line {
    Vector2 from = Vector2::Zero(), to = Vector2::Zero();
    bool operator==(const Line&) const = default;
  };
  /// A named place of the map, a "Cairn" of the file format.
  struct Place {
    /// The type of the place in the file format; kOther is any type that the program does not use.
    enum class Kind { kGoal, kHome, kDock, kForbiddenLine, kForbiddenArea, kOther };
    Kind kind = Kind::kOther;
    /// The type as spelled in the file: "GoalWithHeading".
    std::string type;
    /// May be empty.
    std::string name;
    /// The position of the place; the heading counts only if hasHeading.
    Pose2 pose;
    /// False for a plain "Goal", for lines and for areas.
    bool hasHeading = false;
    /// The two ends of a line, or two opposite corners of an area in a frame that is rotated by pose.heading
    /// about the map's origin.
    Line extent;
    bool operator==(const Place&) const = default;
  };
  /// An axis-aligned rectangle.
  struct Bounds {
    Vector2 low = Vector2::Zero(), high = Vector2::Zero();
  };

  /// The stem of the file's name: "office".
  std::string name;
  /// Walls and other straight obstacles: the sections LINES of the file.
  std::vector<Line> lines;
  /// Single points of obstacles, such as hits of a laser: the sections DATA of the file.
  std::vector<Vector2> points;
  /// Distance between neighboring points of a wall, m.
  double resolution = 0.02;
  std::vector<Place> places;
  /// The place of the map's origin on Earth, for maps that are georeferenced: x points east, y north.
  std::optional<GlobalPosition> origin;
  /// Notes for the user, each with its line: entries of the file that this reader skipped, and data that the
  /// header promises and the file lacks.
  std::vector<std::string> notes;
  /// True if there are fewer lines or points than the header promises, so the file may have been cut off.
  bool incomplete = false;

  /// The bounds of all lines and points, or of the places if there are neither. Zero if the map is empty.
  Bounds bounds() const;
  /// The first place of this kind; null if there is none.
  const Place* find(Place::Kind kind) const;
  /// The first place of this name; null if there is none.
  const Place* find(std::string_view placeName) const;

  /// Reads a file of the "2D-Map" family, the format of ARIA and MobileSim (2D-Map to 2D-Map-Ex4). The counts
  /// in its header are not trusted. Every problem is reported with file and line. Maps with more than a
  /// million lines, four million points or 2000 km of walls are refused: no building has that many.
  static tl::expected<GroundMap, Errors> load(const std::filesystem::path& file);
  /// The same for a text. `file` is the name that errors carry; its stem becomes the map's name.
  static tl::expected<GroundMap, Errors> parse(std::string_view text, const std::string& file);

  /// The text of a file of this map, of the kind 2D-Map: lines and points rounded to mm, headings of places
  /// to a tenth of a degree. Quotes and line breaks in names become spaces. Notes are not part of it.
  std::string text() const;
  /// Writes the file as a whole or not at all. Errors: file.io.
  Result<void> save(const std::filesystem::path& file) const;
};

}  // namespace robotlink
