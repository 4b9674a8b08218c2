// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/ExpressionReader.h"

#include <re2/re2.h>

#include <algorithm>
#include <cctype>

#include "robotlink/expressions/NameCharacters.h"

namespace robotlink {
namespace {

/// Memory that a pattern may take, in bytes.
constexpr int kMaxPatternBytes = 1 << 20;

class Reader {
 public:
  Reader(std::string_view text, const std::vector<std::string>& streams) : text_(text), streams_(streams) {}

  Result<ReadExpression> read() {
    while (at_ < text_.size()) {
      if (const auto done = next(); !done) return tl::unexpected(done.error());
    }
    read_.places.push_back(static_cast<int>(text_.size()));
    return std::move(read_);
  }

 private:
  char at(std::size_t place) const { return place < text_.size() ? text_[place] : '\0'; }
  tl::unexpected<Error> wrong(std::string what, std::size_t place) const {
    return failure("expression.syntax", std::move(what), {"", 0, static_cast<int>(place) + 1});
  }
  void put(std::string_view formula, std::size_t from) {
    read_.formula += formula;
    read_.places.insert(read_.places.end(), formula.size(), static_cast<int>(from));
  }

  Result<void> next() {
    const char c = text_[at_];
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      put(" ", at_++);
      return {};
    }
    if (c == '"') return wrong("compare a text with a value, as in hosting.state == \"RUNNING\"", at_);
    if (c == '=' && at(at_ + 1) != '=') return wrong("write == to compare", at_);
    const std::size_t known = isOperandNext_ ? knownStream() : 0;
    if (known > 0) return value(known);
    if (isDigit(c) || (c == '.' && isDigit(at(at_ + 1)))) return number();
    // A name of ROS begins with a slash.
    if (beginsName(c) || (c == '/' && isOperandNext_ && beginsName(at(at_ + 1)))) return word();
    return operatorOrBracket();
  }

  /// The length of the longest known stream that begins here and has a field; 0: none.
  std::size_t knownStream() const {
    std::size_t longest = 0;
    for (const std::string& stream : streams_) {
      const bool isHere = text_.substr(at_).starts_with(stream) && at(at_ + stream.size()) == '.' &&
                          beginsName(at(at_ + stream.size() + 1));
      if (isHere) longest = std::max(longest, stream.size());
    }
    return longest;
  }

  Result<void> number() {
    const std::size_t begin = at_;
    while (isDigit(at(at_)) || at(at_) == '.') ++at_;
    if (at(at_) == 'e' || at(at_) == 'E') {
      const std::size_t sign = at(at_ + 1) == '+' || at(at_ + 1) == '-' ? 1 : 0;
      if (isDigit(at(at_ + 1 + sign))) {
        at_ += 1 + sign;
        while (isDigit(at(at_))) ++at_;
      }
    }
    if (beginsName(at(at_))) return wrong("a name does not begin with a digit", begin);
    for (std::size_t place = begin; place < at_; ++place) put(text_.substr(place, 1), place);
    isOperandNext_ = false;
    return {};
  }

  /// Whether a comparison of equality stands before this place.
  bool isCompared() const {
    std::string_view before = text_.substr(0, at_);
    while (before.ends_with(' ')) before.remove_suffix(1);
    return before.ends_with("==") || before.ends_with("!=");
  }

  Result<void> word() {
    std::size_t end = at_ + (at(at_) == '/' ? 1 : 0);
    while (isNameCharacter(at(end)) || ((at(end) == '/' || at(end) == '-') && isNameCharacter(at(end + 1))))
      ++end;
    if (at(end) == '.' && beginsName(at(end + 1))) return value(end - at_);
    const std::string_view name = text_.substr(at_, end - at_);
    std::size_t after = end;
    while (at(after) == ' ') ++after;
    static constexpr std::string_view kConstants[] = {"pi", "true", "false"};
    const bool isConstant =
        std::find(std::begin(kConstants), std::end(kConstants), name) != std::end(kConstants);
    if (at(after) != '(' && !isConstant) {
      if (isCompared()) {
        return wrong("'" + std::string(name) + "' is not a value; put a text in quotation marks: \"" +
                         std::string(name) + '"',
                     at_);
      }
      return wrong("'" + std::string(name) +
                       "' is neither a function nor a value: values are written STREAM.FIELD, as in "
                       "models/ball.position.x; put spaces around / and - between values",
                   at_);
    }
    put(name, at_);
    at_ = end;
    isOperandNext_ = false;
    return {};
  }

  /// Reads a value, whose stream has this length.
  Result<void> value(std::size_t length) {
    const std::size_t begin = at_;
    const std::size_t field = at_ + length + 1;
    std::size_t end = field;
    while (isNameCharacter(at(end)) || (at(end) == '.' && beginsName(at(end + 1))) || at(end) == '[') {
      if (at(end) != '[') {
        ++end;
        continue;
      }
      bool isQuoted = false;
      while (end < text_.size() && (isQuoted || at(end) != ']')) isQuoted ^= at(end++) == '"';
      if (end < text_.size()) ++end;
    }
    auto path = FieldPath::parse(text_.substr(field, end - field));
    if (!path) {
      Error error = path.error();
      error.where.column += static_cast<int>(field);
      return tl::unexpected(std::move(error));
    }
    read_.streams.emplace_back(begin, length);
    const std::size_t input =
        inputFor({std::string(text_.substr(begin, length)), std::move(*path), static_cast<int>(field) + 1});
    at_ = end;
    isOperandNext_ = false;
    return comparedWithText(input, begin);
  }

  std::size_t inputFor(ExpressionInput input) {
    auto& inputs = read_.inputs;
    const auto same = std::find_if(inputs.begin(), inputs.end(), [&](const ExpressionInput& other) {
      return other.stream == input.stream && other.path == input.path;
    });
    const std::size_t index = static_cast<std::size_t>(same - inputs.begin());
    if (same == inputs.end()) inputs.push_back(std::move(input));
    return index;
  }

  /// Ends a value: with its comparison, if a text follows, else as a number.
  Result<void> comparedWithText(std::size_t input, std::size_t begin) {
    std::size_t place = at_;
    while (at(place) == ' ') ++place;
    const std::size_t operatorPlace = place;
    const std::string_view comparison = text_.substr(std::min(place, text_.size()), 2);
    place += 2;
    while (at(place) == ' ') ++place;
    const bool isMatch = comparison == "=~";
    if ((comparison != "==" && comparison != "!=" && !isMatch) || at(place) != '"') {
      if (isMatch) return wrong("=~ is followed by a regular expression in quotation marks", operatorPlace);
      put("v" + std::to_string(input), begin);
      return {};
    }
    TextCondition condition{input, {}, comparison == "!=", nullptr};
    const std::size_t quote = place++;
    for (; place < text_.size() && text_[place] != '"'; ++place) {
      if (text_[place] == '\\' && at(place + 1) == '"') ++place;
      condition.text += text_[place];
    }
    if (place == text_.size()) return wrong("this text has no closing quotation mark", quote);
    at_ = place + 1;
    if (isMatch) {
      re2::RE2::Options options;
      options.set_log_errors(false);
      options.set_max_mem(kMaxPatternBytes);
      auto pattern = std::make_shared<const re2::RE2>(condition.text, options);
      if (!pattern->ok()) return wrong("not a valid regular expression: " + pattern->error(), quote);
      condition.pattern = std::move(pattern);
    }
    put("c" + std::to_string(read_.conditions.size()), begin);
    read_.conditions.push_back(std::move(condition));
    return {};
  }

  Result<void> operatorOrBracket() {
    static constexpr std::string_view kOperators[] = {"&&", "||", "==", "!=", "<=", ">=", "<", ">", "+", "-",
                                                      "*",  "/",  "^",  "!",  "?",  ":",  "(", ")", ","};
    for (const std::string_view known : kOperators) {
      if (!text_.substr(at_).starts_with(known)) continue;
      for (std::size_t i = 0; i < known.size(); ++i) put(known.substr(i, 1), at_ + i);
      at_ += known.size();
      isOperandNext_ = known != ")";
      return {};
    }
    return wrong("this character is not allowed here", at_);
  }

  std::string_view text_;
  const std::vector<std::string>& streams_;
  std::size_t at_ = 0;
  /// Whether a value may begin here.
  bool isOperandNext_ = true;
  ReadExpression read_;
};

}  // namespace

Result<ReadExpression> readExpression(std::string_view text, const std::vector<std::string>& streams) {
  return Reader(text, streams).read();
}

}  // namespace robotlink
