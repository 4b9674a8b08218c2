// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/StrokeList.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/TextParts.h"

namespace colortool {

using robotlink::Error;
using robotlink::Errors;

namespace {

constexpr std::array<std::string_view, 5> kColumns = {"image", "class", "x", "y", "radius"};
enum Column : std::size_t { kImage, kClass, kX, kY, kRadius };
constexpr std::size_t kMaxListErrors = 20;

struct Field {
  std::string_view text;
  int column = 1;  // counts from 1
};

std::string_view unquoted(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<Field> fieldsOf(std::string_view line) {
  std::vector<Field> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back({unquoted(line.substr(begin, end - begin)), static_cast<int>(begin) + 1});
    if (end == line.size()) return fields;
    begin = end + 1;
  }
}

/// Reads a list line by line.
class StrokeListParser {
 public:
  explicit StrokeListParser(const std::string& file) : file_(file) {}

  void line(std::string_view text) {
    ++line_;
    if (unquoted(text).empty()) return;
    const std::vector<Field> fields = fieldsOf(text);
    if (!headed_) return header(fields);
    if (fields.size() < columns_.size()) {
      return wrong(1, "this line has " + std::to_string(fields.size()) + " fields; the first line names " +
                          std::to_string(width_));
    }
    stroke(fields);
  }
  bool goesOn() const { return errors_.size() < kMaxListErrors && (headed_ || errors_.empty()); }

  tl::expected<std::vector<DiscStroke>, Errors> result() {
    if (!headed_ && errors_.empty())
      wrong(1, "the list is empty; its first line must be image,class,x,y,radius");
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    return std::move(strokes_);
  }

 private:
  void wrong(int column, std::string text) {
    errors_.push_back({"color.strokes", std::move(text), {}, {file_, std::max(line_, 1), column}});
  }
  void header(const std::vector<Field>& fields) {
    width_ = fields.size();
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      std::size_t at = 0;
      while (at < fields.size() && fields[at].text != kColumns[i]) ++at;
      if (at == fields.size()) {
        return wrong(1, "the first line must name the columns image,class,x,y,radius; '" +
                            std::string(kColumns[i]) + "' is missing");
      }
      columns_[i] = at;
    }
    headed_ = true;
  }
  void stroke(const std::vector<Field>& fields) {
    for (const std::size_t column : columns_) {
      if (column >= fields.size())
        return wrong(1, "this line ends before its " + std::to_string(column + 1) + "th field");
    }
    const auto x = number(fields, kX), y = number(fields, kY), radius = number(fields, kRadius);
    if (!x || !y || !radius) return;
    if (*radius < 0) return wrong(fields[columns_[kRadius]].column, "a radius cannot be negative");
    DiscStroke stroke{std::string(fields[columns_[kImage]].text), std::string(fields[columns_[kClass]].text),
                      *x, *y, *radius};
    if (stroke.image.empty()) return wrong(fields[columns_[kImage]].column, "the image's name is missing");
    if (stroke.colorClass.empty()) return wrong(fields[columns_[kClass]].column, "the class is missing");
    strokes_.push_back(std::move(stroke));
  }
  std::optional<double> number(const std::vector<Field>& fields, Column column) {
    const Field& field = fields[columns_[column]];
    double value = 0;
    const char* end = field.text.data() + field.text.size();
    const auto [stopped, error] = std::from_chars(field.text.data(), end, value);
    if (error == std::errc() && stopped == end && std::isfinite(value)) return value;
    wrong(field.column, "'" + std::string(field.text) + "' is not a number; " +
                            std::string(kColumns[column]) + " is expected here");
    return std::nullopt;
  }

  const std::string& file_;
  int line_ = 0;
  bool headed_ = false;
  std::size_t width_ = 0;
  std::array<std::size_t, kColumns.size()> columns_{};
  std::vector<DiscStroke> strokes_;
  Errors errors_;
};

}  // namespace

tl::expected<std::vector<DiscStroke>, Errors> parseStrokeList(std::string_view text,
                                                              const std::string& file) {
  StrokeListParser parser(file);
  while (!text.empty() && parser.goesOn()) parser.line(robotlink::takeLine(text));
  return parser.result();
}

tl::expected<std::vector<DiscStroke>, Errors> readStrokeList(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file);
  if (!text) return tl::unexpected(Errors{text.error()});
  return parseStrokeList(*text, file.string());
}

}  // namespace colortool
