// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/NamedColorTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>
#include <set>
#include <system_error>

#include "colortool/image/ClassPresets.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/TextParts.h"

namespace colortool {

using robotlink::Errors;
using robotlink::Result;

namespace {

constexpr std::string_view kFirstLine = "robotcontrol-color-classes 1";
constexpr std::size_t kMaxTableBytes = 64U << 10U;
constexpr std::size_t kMaxErrors = 20;

std::optional<robotlink::Rgb> color(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
  if (error != std::errc() || end != text.data() + 7) return std::nullopt;
  return robotlink::Rgb{static_cast<std::uint8_t>(value >> 16U),
                        static_cast<std::uint8_t>(value >> 8U & 0xFFU),
                        static_cast<std::uint8_t>(value & 0xFFU)};
}

/// Reads a file of classes line by line.
class NamedTableParser {
 public:
  explicit NamedTableParser(const std::string& file) : file_(file) {}

  void line(std::string_view text) {
    ++line_;
    if (line_ == 1) {
      if (robotlink::trimmed(text) != kFirstLine)
        wrong(fmt::format("this is not a file of color classes: its first line must be '{}'", kFirstLine));
      return;
    }
    text = robotlink::trimmed(text);
    if (text.empty()) return;
    const std::size_t space = text.find_last_of(" \t");
    const auto shown = space == std::string_view::npos ? std::nullopt : color(text.substr(space + 1));
    if (!shown) return wrong("a class is expected here: its name and its color, as in 'orange #ff6900'");
    add(std::string(robotlink::trimmed(text.substr(0, space))), *shown);
  }
  bool goesOn() const { return errors_.size() < kMaxErrors && (line_ != 1 || errors_.empty()); }

  tl::expected<ColorClasses, Errors> result() {
    if (line_ == 0) wrong("the file is empty; its first line must be '" + std::string(kFirstLine) + "'");
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    return ColorClasses(std::move(classes_));
  }

 private:
  void add(std::string name, robotlink::Rgb shown) {
    if (std::string problem = classNameProblem(name); !problem.empty()) return wrong(std::move(problem));
    if (!names_.insert(name).second)
      return wrong("the class '" + name + "' appears here for the second time");
    if (classes_.size() == ColorTableFile::kMaxClasses)
      return wrong(fmt::format("there are more than {} classes", ColorTableFile::kMaxClasses));
    classes_.push_back({std::move(name), shown});
  }
  void wrong(std::string text) {
    errors_.push_back({"color-table.classes", std::move(text), {}, {file_, std::max(line_, 1), 0}});
  }

  const std::string& file_;
  int line_ = 0;
  std::set<std::string> names_;
  std::vector<NamedColor> classes_;
  Errors errors_;
};

const ClassPreset& usual() {
  return *findClassPreset("bhuman2009");
}

int highestClass(const ColorTableFile& table) {
  int highest = 0;
  for (const std::uint8_t cell : table.cells) {
    const unsigned mask = cell & 0x7FU;
    highest =
        std::max(highest, (cell & ColorTableFile::kSeveral) != 0 ? static_cast<int>(std::bit_width(mask))
                                                                 : static_cast<int>(cell));
  }
  return highest;
}

}  // namespace

std::string colorClassesText(const ColorClasses& classes) {
  std::string text = std::string(kFirstLine) + "\n";
  for (int i = 1; i < classes.size(); ++i) {
    const robotlink::Rgb shown = classes.shownColor(i);
    text += fmt::format("{} #{:02x}{:02x}{:02x}\n", classes.name(i), shown.r, shown.g, shown.b);
  }
  return text;
}

tl::expected<ColorClasses, Errors> parseColorClasses(std::string_view text, const std::string& file) {
  NamedTableParser parser(file);
  while (!text.empty() && parser.goesOn()) parser.line(robotlink::takeLine(text));
  return parser.result();
}

void NamedColorTable::nameAll() {
  std::vector<NamedColor> all(classes.colors().begin(), classes.colors().end());
  for (int number = classes.size(); number <= highestClass(file); ++number)
    all.push_back(spareClass(number, all));
  classes = ColorClasses(std::move(all));
}

std::filesystem::path NamedColorTable::classesFile(const std::filesystem::path& table) {
  return table.string() + ".classes";
}

tl::expected<NamedColorTable, Errors> NamedColorTable::load(const std::filesystem::path& table) {
  auto file = ColorTableFile::load(table);
  if (!file) return tl::unexpected(Errors{file.error()});
  const std::filesystem::path beside = classesFile(table);
  std::error_code error;
  if (!std::filesystem::exists(beside, error)) {
    NamedColorTable unnamed{std::move(*file), usual().classes()};
    unnamed.nameAll();
    return unnamed;
  }
  const auto text = robotlink::readFile(beside, kMaxTableBytes);
  if (!text) return tl::unexpected(Errors{text.error()});
  auto classes = parseColorClasses(*text, beside.string());
  if (!classes) return tl::unexpected(classes.error());
  if (const int highest = highestClass(*file); classes->size() <= highest) {
    return tl::unexpected(Errors{
        {"color-table.classes",
         fmt::format("{} classes are named here, but the table has cells of class {}: are these the classes "
                     "of another table?",
                     classes->size() - 1, highest),
         {},
         {beside.string(), 0, 0}}});
  }
  return NamedColorTable{std::move(*file), std::move(*classes)};
}

Result<void> NamedColorTable::save(const std::filesystem::path& table) const {
  if (classes.size() - 1 > ColorTableFile::kMaxClasses) {
    return robotlink::failure("color-table.classes",
                              fmt::format("a .c64 color table has room for {} classes, not for {}",
                                          ColorTableFile::kMaxClasses, classes.size() - 1),
                              {table.string(), 0, 0});
  }
  const std::filesystem::path beside = classesFile(table);
  std::error_code error;
  if (classes == usual().classes()) {
    if (const auto saved = file.save(table); !saved) return saved;
    std::filesystem::remove(beside, error);
    if (!error) return {};
    return robotlink::failure("file.io", "cannot remove the old file of class names here: " + error.message(),
                              {beside.string(), 0, 0});
  }
  const auto before = robotlink::readFile(beside, kMaxTableBytes);
  if (const auto named = robotlink::writeFileAtomically(beside, colorClassesText(classes)); !named)
    return named;
  const auto saved = file.save(table);
  if (saved) return saved;
  // The previous table, if there was one, keeps its names.
  if (before)
    static_cast<void>(robotlink::writeFileAtomically(beside, *before));
  else
    std::filesystem::remove(beside, error);
  return saved;
}

}  // namespace colortool
