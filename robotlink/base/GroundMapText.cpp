// SPDX-License-Identifier: GPL-3.0-or-later
// Writes maps as files of the format that GroundMap.cpp reads.
#include <cmath>
#include <cstdio>
#include <limits>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/GroundMap.h"

namespace robotlink {
namespace {

/// The largest and the smallest coordinates of some places, as the header of a map has them.
class Extent {
 public:
  void add(const Vector2& place) {
    low_ = low_.cwiseMin(place);
    high_ = high_.cwiseMax(place);
  }
  const Vector2& low() const { return low_; }
  const Vector2& high() const { return high_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Vector2 low_{kFar, kFar}, high_{-kFar, -kFar};
};

std::string inMm(const Vector2& place) {
  return std::to_string(std::llround(1000 * place.x())) + ' ' +
         std::to_string(std::llround(1000 * place.y()));
}

/// The type of a place that was not read from a file.
std::string typeOf(const GroundMap::Place& place) {
  using Kind = GroundMap::Place::Kind;
  if (!place.type.empty()) return place.type;
  switch (place.kind) {
    case Kind::kGoal:
      return place.hasHeading ? "GoalWithHeading" : "Goal";
    case Kind::kHome:
      return "RobotHome";
    case Kind::kDock:
      return "Dock";
    case Kind::kForbiddenLine:
      return "ForbiddenLine";
    case Kind::kForbiddenArea:
      return "ForbiddenArea";
    case Kind::kOther:
      break;
  }
  return "Place";
}

std::string cairnOf(const GroundMap::Place& place) {
  using Kind = GroundMap::Place::Kind;
  std::string name = place.name;
  for (char& c : name) {
    if (c == '"' || c == '\n' || c == '\r') c = ' ';
  }
  char heading[32];
  std::snprintf(heading, sizeof heading, "%.1f", degrees(place.pose.heading));
  std::string text = "Cairn: " + typeOf(place) + ' ' + inMm(place.pose.translation()) + ' ' + heading +
                     " \"\" ICON \"" + name + '"';
  const bool hasExtent = place.kind == Kind::kForbiddenLine || place.kind == Kind::kForbiddenArea ||
                         place.extent != GroundMap::Line();
  if (hasExtent) text += ' ' + inMm(place.extent.from) + ' ' + inMm(place.extent.to);
  return text + '\n';
}

std::string headerOf(const std::string& prefix, const std::string& what, std::size_t count,
                     const Extent& extent) {
  if (count == 0) return {};
  return prefix + "MinPos: " + inMm(extent.low()) + '\n' + prefix + "MaxPos: " + inMm(extent.high()) +
         "\nNum" + what + ": " + std::to_string(count) + '\n';
}

}  // namespace

std::string GroundMap::text() const {
  Extent ends, dots;
  for (const Line& line : lines) {
    ends.add(line.from);
    ends.add(line.to);
  }
  for (const Vector2& point : points) dots.add(point);
  std::string result = "2D-Map\n" + headerOf("Line", "Lines", lines.size(), ends) +
                       headerOf("", "Points", points.size(), dots) +
                       "Resolution: " + std::to_string(std::llround(1000 * resolution)) + '\n';
  if (origin) {
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "OriginLatLongAlt: %.8f %.8f %.3f\n", origin->latitude,
                  origin->longitude, origin->altitude);
    result += numbers;
  }
  for (const Place& place : places) result += cairnOf(place);
  if (!lines.empty()) result += "LINES\n";
  for (const Line& line : lines) result += inMm(line.from) + ' ' + inMm(line.to) + '\n';
  if (!points.empty()) result += "DATA\n";
  for (const Vector2& point : points) result += inMm(point) + '\n';
  return result;
}

Result<void> GroundMap::save(const std::filesystem::path& file) const {
  return writeFileAtomically(file, text());
}

}  // namespace robotlink
