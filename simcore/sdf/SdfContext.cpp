// SPDX-License-Identifier: GPL-3.0-or-later
// SdfContext of SdfConversion.h: errors with line numbers, and checks of numbers.
#include <algorithm>
#include <cctype>
#include <sstream>

#include "simcore/sdf/SdfConversion.h"

namespace simcore {
namespace {

/// The line of an element, or of the nearest enclosing one with a line; 0 if there is none.
int lineOf(sdf::ElementPtr element) {
  while (element && !element->LineNumber()) element = element->GetParent();
  return element ? *element->LineNumber() : 0;
}

bool isNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

/// The line of the first element that a message of libsdformat mentions; 1 if it mentions none.
int lineNamed(const std::string& message, const std::string& source) {
  for (auto begin = message.begin(); begin != message.end();) {
    begin = std::find_if(begin, message.end(), isNameCharacter);
    const auto end = std::find_if_not(begin, message.end(), isNameCharacter);
    const std::size_t at = source.find("name=\"" + std::string(begin, end) + "\"");
    if (begin != end && at != std::string::npos) {
      return 1 + static_cast<int>(
                     std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    }
    begin = end;
  }
  return 1;
}

/// Without trailing zeros: "0.001", not "0.001000".
std::string shortNumber(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

}  // namespace

void SdfContext::fail(const sdf::ElementPtr& element, std::string id, std::string text) const {
  errors.push_back({std::move(id), std::move(text), {}, {file, std::max(1, lineOf(element)), 0}});
}

bool SdfContext::take(const sdf::Errors& found, const sdf::ElementPtr& element) const {
  for (const sdf::Error& error : found) {
    // Some messages repeat the whole file.
    const std::string message = error.Message().substr(0, error.Message().find('\n'));
    int line = error.LineNumber().value_or(lineOf(element));
    if (line <= 0) line = lineNamed(message, source);
    errors.push_back({"scene.sdf", message, {}, {file, line, 0}});
    // The enclosing elements follow, each with an error of its own.
    if (message.starts_with("Error reading element")) break;
  }
  return found.empty();
}

double SdfContext::within(double value, double minimum, double maximum, const std::string& what,
                          const sdf::ElementPtr& element) const {
  if (value >= minimum && value <= maximum) return value;
  fail(element, "scene.range",
       what + " must be between " + shortNumber(minimum) + " and " + shortNumber(maximum));
  return minimum;
}

}  // namespace simcore
