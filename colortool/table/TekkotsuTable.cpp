// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/TekkotsuTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "colortool/image/ClassPresets.h"
#include "robotlink/base/TextParts.h"

namespace colortool {

using robotlink::Errors;
using robotlink::Result;

namespace {

constexpr std::string_view kMagic = "TMAP\n", kType = "YUV";
constexpr std::size_t kMaxLine = 64;
constexpr std::size_t kMaxTekkotsuErrors = 20;

/// Parses numbers and punctuation from the front of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  std::optional<int> number(int most) {
    skipBlanks();
    int value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc() || value < 0 || value > most) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  bool sign(char wanted) {
    skipBlanks();
    if (rest_.empty() || rest_.front() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::optional<std::string> quoted() {
    if (!sign('"')) return std::nullopt;
    const std::size_t end = rest_.find('"');
    if (end == std::string_view::npos) return std::nullopt;
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return text;
  }
  bool done() {
    skipBlanks();
    return rest_.empty();
  }

 private:
  void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size())); }

  std::string_view rest_;
};

tl::unexpected<robotlink::Error> wrongTekkotsu(const std::string& file, std::size_t offset,
                                               const std::string& what) {
  return robotlink::failure(
      "color-table.tekkotsu",
      fmt::format("this is not a threshold map of Tekkotsu: at byte {} {}", offset, what), {file, 0, 0});
}

/// The line at an offset, without its end; empty if it is too long.
std::optional<std::string_view> lineAt(std::string_view bytes, std::size_t offset) {
  const std::string_view line = bytes.substr(offset, kMaxLine);
  const std::size_t end = line.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  return line.substr(0, end);
}

/// Parses lines of the form `1 (255 128 0) "orange" 8 0.75`.
class ColorsParser {
 public:
  explicit ColorsParser(const std::string& file) : file_(file) {}

  void line(std::string_view text) {
    ++line_;
    Scanner scanner(text);
    if (scanner.done() || scanner.sign('#')) return;
    const auto index = scanner.number(ColorClasses::kMax);
    if (!index)
      return wrongTekkotsu(
          fmt::format("a line begins with the number of its class, 0 to {}", ColorClasses::kMax));
    const bool open = scanner.sign('(');
    const auto red = scanner.number(255), green = scanner.number(255), blue = scanner.number(255);
    if (!open || !red || !green || !blue || !scanner.sign(')'))
      return wrongTekkotsu("the class's color is expected after its number, as in (255 128 0)");
    auto name = scanner.quoted();
    if (!name) return wrongTekkotsu("the class's name is expected after its color, in quotes");
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    add(*index, {std::move(*name), {byte(*red), byte(*green), byte(*blue)}});
  }
  bool goesOn() const { return errors_.size() < kMaxTekkotsuErrors; }

  tl::expected<ColorClasses, Errors> result() {
    if (line_ == 0) wrongTekkotsu("the file is empty");
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    std::vector<NamedColor> listed;
    for (const auto& [index, color] : colors_) listed.push_back(color);
    std::vector<NamedColor> classes;
    for (auto& [index, color] : colors_) {
      for (int number = static_cast<int>(classes.size()) + 1; number < index; ++number)
        classes.push_back(spareClass(number, listed));
      if (index != ColorClasses::kNone) classes.push_back(std::move(color));
    }
    return ColorClasses(std::move(classes));
  }

 private:
  void add(int index, NamedColor color) {
    if (index != ColorClasses::kNone) {
      if (std::string problem = classNameProblem(color.name); !problem.empty())
        return wrongTekkotsu(std::move(problem));
    }
    const auto sameName = [&](const auto& one) { return one.second.name == color.name; };
    if (std::ranges::any_of(colors_, sameName))
      return wrongTekkotsu("'" + color.name + "' appears here for the second time");
    if (!colors_.emplace(index, std::move(color)).second)
      wrongTekkotsu(fmt::format("class {} appears here a second time", index));
  }
  void wrongTekkotsu(std::string text) {
    errors_.push_back({"color-table.tekkotsu-colors", std::move(text), {}, {file_, std::max(line_, 1), 0}});
  }

  const std::string& file_;
  int line_ = 0;
  std::map<int, NamedColor> colors_;
  Errors errors_;
};

}  // namespace

bool isTekkotsuMap(std::string_view bytes) {
  return bytes.substr(0, kMagic.size()) == kMagic;
}

Result<CellGrid> parseTekkotsuMap(std::string_view bytes, const std::string& file) {
  if (!isTekkotsuMap(bytes)) return wrongTekkotsu(file, 0, "the line TMAP is expected");
  std::size_t at = kMagic.size();
  const auto type = lineAt(bytes, at);
  if (!type || type->substr(0, kType.size()) != kType)
    return wrongTekkotsu(file, at, "the line that says YUV is expected; other color spaces are not read");
  at += type->size() + 1;
  const auto sizes = lineAt(bytes, at);
  CellGrid grid;
  Scanner scanner(sizes.value_or(""));
  for (int& side : grid.sides) {
    const auto number = scanner.number(CellGrid::kMaxCells);
    if (!number || !CellGrid::fits(*number))
      return wrongTekkotsu(file, at, "three numbers of cells are expected: powers of two up to 128");
    side = *number;
  }
  if (!scanner.done()) return wrongTekkotsu(file, at, "something follows the numbers of cells");
  at += sizes->size() + 1;
  const std::size_t cells = CellGrid::count(grid.sides);
  if (bytes.size() - at != cells) {
    return wrongTekkotsu(file, at,
                         fmt::format("{} cells are expected, {} x {} x {}, but {} bytes follow", cells,
                                     grid.sides[0], grid.sides[1], grid.sides[2], bytes.size() - at));
  }
  grid.classes.assign(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end());
  return grid;
}

tl::expected<ColorClasses, Errors> parseTekkotsuColors(std::string_view text, const std::string& file) {
  ColorsParser parser(file);
  while (!text.empty() && parser.goesOn()) parser.line(robotlink::takeLine(text));
  return parser.result();
}

}  // namespace colortool
