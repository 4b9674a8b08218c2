// SPDX-License-Identifier: GPL-3.0-or-later
// SdfContext of SdfConversion.h: errors with line numbers, and checks of numbers.
#include <algorithm>
#include <sstream>
#include <string_view>

#include "simcore/sdf/SdfConversion.h"

namespace simcore {
namespace {

/// The maximum number of errors of libsdformat that are reported; the line of each takes a search of the
/// whole tree.
constexpr std::size_t kMaxReported = 100;

/// The line of an element, or of the nearest enclosing one with a line; 0 if there is none.
int lineOf(sdf::ElementPtr element) {
  while (element && !element->LineNumber()) element = element->GetParent();
  return element ? *element->LineNumber() : 0;
}

std::string fileOf(sdf::ElementPtr element, const std::string& otherwise) {
  while (element && element->FilePath().empty()) element = element->GetParent();
  return element ? element->FilePath() : otherwise;
}

/// The first element of this name that is a <kind>; null if there is none.
sdf::ElementPtr elementOfKind(const std::string& kind, const std::string& name, const sdf::ElementPtr& root,
                              int depth = 0) {
  constexpr int kDeepest = 50;
  if (!root || depth > kDeepest) return nullptr;
  if (root->GetName() == kind && root->HasAttribute("name") && root->Get<std::string>("name") == name)
    return root;
  for (sdf::ElementPtr child = root->GetFirstElement(); child; child = child->GetNextElement()) {
    if (const auto found = elementOfKind(kind, name, child, depth + 1)) return found;
  }
  return nullptr;
}

/// The first element that a message of libsdformat names with its kind: "model with name[arm]"; null if there
/// is none.
sdf::ElementPtr elementTold(const std::string& message, const sdf::ElementPtr& root) {
  constexpr std::string_view kWith = " with name[";
  for (std::size_t at = message.find(kWith); at != std::string::npos; at = message.find(kWith, at + 1)) {
    const std::size_t space = message.rfind(' ', at - 1), begin = space == std::string::npos ? 0 : space + 1,
                      name = at + kWith.size(), end = message.find(']', name);
    if (end == std::string::npos || at == 0) break;
    const auto found =
        elementOfKind(message.substr(begin, at - begin), message.substr(name, end - name), root);
    if (found) return found;
  }
  return nullptr;
}

/// Whether a message only follows from another one, and says nothing to users.
bool isVague(const sdf::Error& error) {
  const std::string message = error.Message();
  return message.find("Graph") != std::string::npos || message.starts_with("Failed to load a ");
}

/// The deepest element whose name a message of libsdformat has in [brackets] or 'quotes'; null if there is
/// none.
sdf::ElementPtr elementNamed(const std::string& message, const sdf::ElementPtr& root, int depth = 0) {
  constexpr int kDeepest = 50;
  if (!root || depth > kDeepest) return nullptr;
  for (sdf::ElementPtr child = root->GetFirstElement(); child; child = child->GetNextElement()) {
    if (const auto found = elementNamed(message, child, depth + 1)) return found;
  }
  if (!root->HasAttribute("name")) return nullptr;
  const auto name = root->Get<std::string>("name");
  const bool named = !name.empty() && (message.find("[" + name + "]") != std::string::npos ||
                                       message.find("'" + name + "'") != std::string::npos);
  return named ? root : nullptr;
}

/// Without trailing zeros: "0.001", not "0.001000".
std::string shortNumber(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

}  // namespace

robotlink::FilePosition SdfContext::placeOf(const sdf::ElementPtr& element) const {
  return {fileOf(element, file), std::max(1, lineOf(element)), 0};
}

/// Names of elements that contain one, and its own.
std::string SdfContext::pathOf(sdf::ElementPtr element) {
  std::string path;
  for (; element; element = element->GetParent()) {
    if (!element->HasAttribute("name")) continue;
    const auto name = element->Get<std::string>("name");
    if (!name.empty() && name != "__default__") path = path.empty() ? name : name + "/" + path;
  }
  return path;
}

void SdfContext::fail(const sdf::ElementPtr& element, std::string id, std::string text) const {
  const std::string path = pathOf(element);
  if (!path.empty()) text = path + ": " + text;
  errors.push_back(
      {std::move(id), std::move(text), {}, {fileOf(element, file), std::max(1, lineOf(element)), 0}});
}

void SdfContext::omit(const sdf::ElementPtr& element, std::string what, std::string why) const {
  leaveOut(leftOut, {{fileOf(element, file), std::max(1, lineOf(element)), 0},
                     pathOf(element),
                     std::move(what),
                     std::move(why)});
}

void SdfContext::omit(const sdf::ElementPtr& element, const std::string& what,
                      const robotlink::Errors& why) const {
  const std::string path = pathOf(element), prefix = path + ": ";
  for (const robotlink::Error& error : why) {
    const std::size_t begin = error.text.starts_with(prefix) ? prefix.size() : 0;
    leaveOut(leftOut, {error.where, path, what, error.text.substr(begin)});
  }
}

bool SdfContext::take(const sdf::Errors& found, const sdf::ElementPtr& element) const {
  const bool isClear =
      std::ranges::any_of(found, [](const sdf::Error& one) { return !isVague(one); }) ||
      std::ranges::any_of(errors, [this](const auto& one) { return one.where.file == file; });
  std::size_t reported = 0;
  for (const sdf::Error& error : found) {
    if (isClear && isVague(error)) continue;
    if (++reported > kMaxReported) {
      fail(root, "scene.sdf", "there are " + std::to_string(found.size() - kMaxReported) + " more errors");
      break;
    }
    // Some messages repeat the whole file.
    const std::string message = error.Message().substr(0, error.Message().find('\n'));
    sdf::ElementPtr at = element;
    if (!at || lineOf(at) <= 0) at = elementTold(message, root);
    if (!at) at = elementNamed(message, root);
    fail(at ? at : root, "scene.sdf", message);
    // The enclosing elements follow, each with an error of its own.
    if (message.starts_with("Error reading element")) break;
  }
  return found.empty();
}

double SdfContext::within(double value, double minimum, double maximum, const std::string& what,
                          const sdf::ElementPtr& element) const {
  if (value >= minimum && value <= maximum) return value;
  fail(element, "scene.range",
       what + " must be between " + shortNumber(minimum) + " and " + shortNumber(maximum) + ", not " +
           shortNumber(value));
  return minimum;
}

}  // namespace simcore
