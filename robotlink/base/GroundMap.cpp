// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/GroundMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/base/Utf8.h"

namespace robotlink {
namespace {

constexpr std::size_t kMaxFileBytes = 64U << 20U;
// No building has more; a map within these limits takes less than 100 MB.
constexpr std::size_t kMaxPoints = 4'000'000, kMaxLines = 1'000'000, kMaxPlaces = 100'000;
constexpr std::size_t kMaxErrors = 20, kMaxNotes = 50, kMaxKeyLength = 40;
constexpr double kFarthestMm = 1e7;
// The total length of all lines. Everything that is computed from a map, for the simulation and for robots,
// takes time and memory in proportion to it; the walls of the largest buildings are some hundred kilometers
// long.
constexpr double kLongestMm = 2e9;
constexpr double kFinestMm = 1, kCoarsestMm = 1000;  // resolutions that a map may have

struct Token {
  std::string_view text;
  int column = 1;
};

bool isSpace(char c) {
  return c == ' ' || c == '\t';
}

std::string_view withoutLeadingSpace(std::string_view text) {
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  return text;
}

/// Returns names as UTF-8; those of old files are in Latin-1.
std::string utf8(std::string_view text) {
  if (std::string asIs(text); validUtf8(asIs) == asIs) return asIs;
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) result += static_cast<char>(0xC0U | (byte >> 6U));
    result += static_cast<char>(byte >= 0x80 ? 0x80U | (byte & 0x3FU) : byte);
  }
  return result;
}

GroundMap::Place::Kind kindOf(std::string_view type) {
  using Kind = GroundMap::Place::Kind;
  if (type == "Goal" || type == "GoalWithHeading") return Kind::kGoal;
  if (type == "RobotHome") return Kind::kHome;
  if (type.starts_with("Dock")) return Kind::kDock;  // DockLynx and the like
  if (type == "ForbiddenLine") return Kind::kForbiddenLine;
  if (type == "ForbiddenArea") return Kind::kForbiddenArea;
  return Kind::kOther;
}

/// Whether a header entry says nothing that the data does not say more reliably. Entries of further sensors
/// begin with the sensor's name.
bool isRedundant(std::string_view key) {
  constexpr std::string_view kEnds[] = {"MinPos", "MaxPos", "AreSorted"};
  return std::ranges::any_of(kEnds, [&](std::string_view end) { return key.ends_with(end); });
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  tl::expected<GroundMap, Errors> parse() {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    while (!text_.empty() && !stopped_) {
      std::string_view line = takeLine(text_);
      ++line_;
      while (!line.empty() && (line.back() == '\r' || isSpace(line.back()))) line.remove_suffix(1);
      column_ = 1;
      for (; !line.empty() && isSpace(line.front()); ++column_) line.remove_prefix(1);
      if (!line.empty() && line.front() != '#' && line.front() != ';') parseLine(line);
    }
    if (section_ == Section::kIntro && errors_.empty())
      fail(1, "map.no-map", "the file is empty: a map begins with '2D-Map'");
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    compare(promisedLines_, map_.lines.size(), "lines");
    compare(promisedPoints_, map_.points.size(), "points");
    for (const auto& [key, use] : unused_) {
      note(use.line,
           key + " is not used" + (use.count > 1 ? ", " + std::to_string(use.count) + " entries" : ""));
    }
    return std::move(map_);
  }

 private:
  enum class Section { kIntro, kHeader, kLines, kPoints };
  struct Use {
    int line = 0;
    int count = 0;
  };

  void fail(int column, std::string id, std::string text) {
    if (errors_.size() + 1 == kMaxErrors) {
      text += "; further problems are not listed";
      stopped_ = true;
    }
    errors_.push_back({std::move(id), std::move(text), {}, {file_, line_, column}});
  }

  void note(int line, const std::string& text) {
    if (map_.notes.size() < kMaxNotes) map_.notes.push_back(file_ + ":" + std::to_string(line) + ": " + text);
  }

  /// The count that the header promises, summed over all sensors.
  struct Promise {
    int line = 0;  ///< 0: the header has no count
    double count = 0;
  };

  void compare(const Promise& promised, std::size_t found, const std::string& what) {
    const auto have = static_cast<double>(found);
    if (promised.line == 0 || promised.count == have) return;
    const auto count = static_cast<long long>(promised.count);
    map_.incomplete = map_.incomplete || have < promised.count;
    std::string text = "the header promises " + std::to_string(count) + " " + what + ", but there are " +
                       std::to_string(found) + ": ";
    text += have < promised.count ? "the map may have been cut off, so that walls are missing"
                                  : "all of them are used";
    map_.notes.insert(map_.notes.begin(), file_ + ":" + std::to_string(promised.line) + ": " + text);
  }

  void parseCount(std::string_view text, Promise& promise) {
    const auto value = parsedNumberWithSign<double>(withoutLeadingSpace(text));
    if (!value || !(*value >= 0 && *value <= 1e15))
      return note(line_, "this is not a number of lines or points; they are counted instead");
    promise.line = promise.line == 0 ? line_ : promise.line;
    promise.count += *value;
  }

  void parseLine(std::string_view line) {
    if (section_ == Section::kIntro) return parseIntro(line);
    const char first = line.front();
    const bool isData = section_ != Section::kHeader &&
                        (first == '-' || first == '+' || first == '.' || (first >= '0' && first <= '9'));
    if (isData) return parseNumbers(line);
    if (line == "LINES" || line.ends_with("_LINES")) {
      section_ = Section::kLines;
    } else if (line == "DATA" || line.ends_with("_DATA")) {
      section_ = Section::kPoints;
    } else {
      parseEntry(line);
    }
  }

  void parseIntro(std::string_view line) {
    constexpr std::string_view kIntros[] = {"2D-Map", "2D-Map-Ex", "2D-Map-Ex2", "2D-Map-Ex3", "2D-Map-Ex4"};
    section_ = Section::kHeader;
    if (std::ranges::find(kIntros, line) != std::end(kIntros)) return;
    stopped_ = true;
    fail(1, "map.no-map",
         "this is not a map of the kinds 2D-Map to 2D-Map-Ex4: its first line must say which of them it is");
  }

  /// Reads the numbers of a data line; returns false, after adding an error, unless there are exactly
  /// `count`.
  template <std::size_t count>
  bool readNumbers(std::string_view line, std::array<double, count>& numbers) {
    const char* at = line.data();
    const char* const end = at + line.size();
    std::size_t read = 0;
    while (at != end) {
      const char* from = at;
      while (at != end && !isSpace(*at)) ++at;
      const auto value = parsedNumberWithSign<double>({from, at});
      const int column = column_ + static_cast<int>(from - line.data());
      if (!value || read == count) break;
      if (!(std::abs(*value) <= kFarthestMm))
        return fail(column, "map.far", "a coordinate must be a number of millimeters and at most 10 km"),
               false;
      numbers[read++] = *value;
      while (at != end && isSpace(*at)) ++at;
      if (at == end && read == count) return true;
    }
    fail(column_, "map.numbers",
         count == 4 ? "a line of LINES must be four numbers: x1 y1 x2 y2, in mm"
                    : "a line of DATA must be two numbers: x y, in mm");
    return false;
  }

  void parseNumbers(std::string_view line) {
    if (section_ == Section::kLines) {
      std::array<double, 4> mm{};
      if (!readNumbers(line, mm)) return;
      if (map_.lines.size() == kMaxLines) return tooMany("lines", kMaxLines);
      lengthMm_ += std::hypot(mm[2] - mm[0], mm[3] - mm[1]);
      if (lengthMm_ > kLongestMm) return tooLong();
      map_.lines.push_back({{mm[0] / 1000, mm[1] / 1000}, {mm[2] / 1000, mm[3] / 1000}});
    } else {
      std::array<double, 2> mm{};
      if (!readNumbers(line, mm)) return;
      if (map_.points.size() == kMaxPoints) return tooMany("points", kMaxPoints);
      map_.points.emplace_back(mm[0] / 1000, mm[1] / 1000);
    }
  }

  void tooMany(const std::string& what, std::size_t limit) {
    stopped_ = true;
    fail(0, "map.too-large",
         "there are more than " + std::to_string(limit) + " " + what + ", which is more than can be used");
  }

  void tooLong() {
    stopped_ = true;
    fail(0, "map.too-large",
         "the lines up to here are together more than 2000 km long, which no building's walls are; the file "
         "is damaged, or its "
         "coordinates are not in mm");
  }

  /// Splits a line into words and quoted texts; returns false, after adding an error, if a quote is not
  /// closed.
  bool readTokens(std::string_view line, std::vector<Token>& tokens) {
    for (std::size_t at = 0; at < line.size();) {
      const bool quoted = line[at] == '"';
      const std::size_t from = quoted ? at + 1 : at;
      const std::size_t end =
          quoted ? line.find('"', from) : std::min(line.find_first_of(" \t", from), line.size());
      const int column = column_ + static_cast<int>(at);
      if (end == std::string_view::npos)
        return fail(column, "map.quote", "a quote is opened here and not closed"), false;
      tokens.push_back({line.substr(from, end - from), column});
      at = end + (quoted ? 1 : 0);
      while (at < line.size() && isSpace(line[at])) ++at;
    }
    return true;
  }

  void parseEntry(std::string_view line) {
    const std::size_t colon = line.find(':');
    const std::string_view key = line.substr(0, colon);
    if (colon == std::string_view::npos || key.find_first_of(" \t\"") != std::string_view::npos) {
      return fail(column_, "map.line",
                  "this is neither an entry of a map ('Key: values') nor data after LINES or DATA");
    }
    if (key == "Cairn") {
      std::vector<Token> tokens;
      std::string_view rest = line.substr(colon + 1);
      column_ += static_cast<int>(colon) + 1;
      for (; !rest.empty() && isSpace(rest.front()); ++column_) rest.remove_prefix(1);
      if (readTokens(rest, tokens)) parsePlace(tokens);
    } else if (key == "Resolution") {
      parseResolution(line.substr(colon + 1));
    } else if (key.ends_with("NumLines")) {
      parseCount(line.substr(colon + 1), promisedLines_);
    } else if (key.ends_with("NumPoints")) {
      parseCount(line.substr(colon + 1), promisedPoints_);
    } else if (key == "OriginLatLongAlt") {
      parseOrigin(line.substr(colon + 1));
    } else if (!isRedundant(key)) {
      const std::string name = utf8(key.substr(0, kMaxKeyLength));
      if (unused_.size() >= kMaxNotes && !unused_.contains(name)) return;
      Use& use = unused_[name];
      if (use.count++ == 0) use.line = line_;
    }
  }

  /// Reads latitude and longitude in degrees, and the altitude in m.
  void parseOrigin(std::string_view text) {
    std::vector<Token> tokens;
    std::optional<double> numbers[3];
    if (!readTokens(withoutLeadingSpace(text), tokens)) return;
    for (std::size_t i = 0; i < 3 && i < tokens.size(); ++i)
      numbers[i] = parsedNumberWithSign<double>(tokens[i].text);
    const bool known =
        numbers[0] && numbers[1] && std::abs(*numbers[0]) <= 90 && std::abs(*numbers[1]) <= 180;
    if (!known)
      return note(line_,
                  "the origin is not a latitude and longitude in degrees: the map is not georeferenced");
    const double altitude = numbers[2].value_or(0);
    map_.origin = GlobalPosition{*numbers[0], *numbers[1], std::abs(altitude) < 1e5 ? altitude : 0};
  }

  void parseResolution(std::string_view text) {
    const auto value = parsedNumberWithSign<double>(withoutLeadingSpace(text));
    if (value && *value >= kFinestMm && *value <= kCoarsestMm) {
      map_.resolution = *value / 1000;
    } else {
      note(line_, "the resolution is not a number from 1 to 1000 mm: 20 mm is used instead");
    }
  }

  /// Reads a Cairn: type x y heading "" ICON "name", and for lines and areas x1 y1 x2 y2; mm and degrees.
  void parsePlace(const std::vector<Token>& tokens) {
    constexpr std::size_t kFirstNumber = 1, kName = 6, kFirstExtent = 7, kAll = 11;
    if (tokens.size() <= 3)
      return fail(column_, "map.cairn",
                  "a Cairn must have a type and a pose: x y heading, in mm and degrees");
    if (map_.places.size() == kMaxPlaces) return tooMany("Cairns", kMaxPlaces);
    GroundMap::Place place;
    place.type = utf8(tokens[0].text);
    place.kind = kindOf(place.type);
    std::array<double, 7> numbers{};
    const bool hasExtent = tokens.size() >= kAll;
    for (std::size_t i = 0; i < (hasExtent ? 7U : 3U); ++i) {
      const Token& token = tokens[i < 3 ? kFirstNumber + i : kFirstExtent + i - 3];
      const auto value = parsedNumberWithSign<double>(token.text);
      if (!value || !(std::abs(*value) <= kFarthestMm)) {
        return fail(
            token.column, "map.cairn",
            "a Cairn's pose and corners must be numbers of millimeters and degrees, and at most 10 km");
      }
      numbers[i] = *value;
    }
    using Kind = GroundMap::Place::Kind;
    const bool needsExtent = place.kind == Kind::kForbiddenLine || place.kind == Kind::kForbiddenArea;
    if (needsExtent && !hasExtent)
      return fail(column_, "map.cairn", "a " + place.type + " must end in its corners: x1 y1 x2 y2, in mm");
    if (tokens.size() > kName) place.name = utf8(tokens[kName].text);
    place.pose = {numbers[0] / 1000, numbers[1] / 1000, normalizedAngle(radians(numbers[2]))};
    place.hasHeading = !needsExtent && place.type != "Goal";
    place.extent = {{numbers[3] / 1000, numbers[4] / 1000}, {numbers[5] / 1000, numbers[6] / 1000}};
    map_.places.push_back(std::move(place));
  }

  std::string_view text_;  // the part that is not parsed yet
  const std::string& file_;
  int line_ = 0, column_ = 1;
  Section section_ = Section::kIntro;
  bool stopped_ = false;
  GroundMap map_;
  Errors errors_;
  std::map<std::string, Use> unused_;
  Promise promisedLines_, promisedPoints_;
  double lengthMm_ = 0;
};

void extend(std::optional<GroundMap::Bounds>& bounds, const Vector2& point) {
  if (!bounds) bounds = {point, point};
  bounds->low = bounds->low.cwiseMin(point);
  bounds->high = bounds->high.cwiseMax(point);
}

}  // namespace

GroundMap::Bounds GroundMap::bounds() const {
  std::optional<Bounds> result;
  for (const Line& line : lines) {
    extend(result, line.from);
    extend(result, line.to);
  }
  for (const Vector2& point : points) extend(result, point);
  if (!result) {
    for (const Place& place : places) extend(result, place.pose.translation());
  }
  return result.value_or(Bounds{});
}

const GroundMap::Place* GroundMap::find(Place::Kind kind) const {
  const auto found = std::ranges::find(places, kind, &Place::kind);
  return found == places.end() ? nullptr : &*found;
}

const GroundMap::Place* GroundMap::find(std::string_view placeName) const {
  const auto found = std::ranges::find(places, placeName, &Place::name);
  return found == places.end() ? nullptr : &*found;
}

tl::expected<GroundMap, Errors> GroundMap::load(const std::filesystem::path& file) {
  const auto text = readFile(file, kMaxFileBytes);
  if (!text) return tl::unexpected(Errors{text.error()});
  return parse(*text, file.string());
}

tl::expected<GroundMap, Errors> GroundMap::parse(std::string_view text, const std::string& file) {
  auto map = Parser(text, file).parse();
  if (map) map->name = std::filesystem::path(file).stem().string();
  return map;
}

}  // namespace robotlink
