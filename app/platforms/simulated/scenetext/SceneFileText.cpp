// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/scenetext/SceneFileText.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;

constexpr int kMaxElementDepth = 100;

/// An element with its places in the text; [begin, end) includes its tags.
struct Element {
  std::string name;
  /// The value of the attribute "name".
  std::string label;
  std::string startTag;
  std::size_t begin = 0, contentBegin = 0, contentEnd = 0, end = 0;
  std::vector<Element> children = {};
};

/// Finds the elements of a text in XML. It checks only what it needs to find them.
class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  /// The elements of the text; unset if tags do not match.
  std::optional<Element> scan() {
    Element all;
    all.contentEnd = all.end = text_.size();
    while (true) {
      const Next next = skipToTag();
      if (next == Next::kEnd) return all;
      if (next == Next::kBroken || text_[at_ + 1] == '/' || !readElement(all, 0)) return std::nullopt;
    }
  }
  std::size_t position() const { return at_; }

 private:
  enum class Next { kTag, kEnd, kBroken };

  /// Skips text, comments, instructions and the like.
  Next skipToTag() {
    while (true) {
      at_ = text_.find('<', at_);
      if (at_ == std::string::npos || at_ + 1 >= text_.size()) {
        at_ = text_.size();
        return Next::kEnd;
      }
      const char* end = text_.compare(at_, 4, "<!--") == 0        ? "-->"
                        : text_.compare(at_, 9, "<![CDATA[") == 0 ? "]]>"
                        : text_[at_ + 1] == '?'                   ? "?>"
                        : text_[at_ + 1] == '!'                   ? ">"
                                                                  : nullptr;
      if (end == nullptr) return Next::kTag;
      const std::size_t found = text_.find(end, at_ + 2);
      if (found == std::string::npos) return Next::kBroken;
      at_ = found + std::string_view(end).size();
    }
  }

  /// The position behind the tag that begins here; npos: it has no end.
  std::size_t endOfTag() const {
    char quote = 0;
    for (std::size_t i = at_; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return i + 1;
      }
    }
    return std::string::npos;
  }

  static std::string labelOf(const std::string& tag) {
    for (std::size_t at = tag.find("name"); at != std::string::npos; at = tag.find("name", at + 1)) {
      if (at == 0 || std::string_view(" \t\r\n").find(tag[at - 1]) == std::string_view::npos) continue;
      const std::size_t equals = tag.find_first_not_of(" \t\r\n", at + 4);
      if (equals == std::string::npos || tag[equals] != '=') continue;
      const std::size_t quote = tag.find_first_of("\"'", equals);
      if (quote == std::string::npos) return {};
      const std::size_t end = tag.find(tag[quote], quote + 1);
      return end == std::string::npos ? std::string() : tag.substr(quote + 1, end - quote - 1);
    }
    return {};
  }

  bool readElement(Element& parent, int depth) {
    const std::size_t end = endOfTag();
    if (end == std::string::npos || depth > kMaxElementDepth) return false;
    Element element;
    element.begin = at_;
    element.startTag = text_.substr(at_, end - at_);
    element.name = element.startTag.substr(1, element.startTag.find_first_of(" \t\r\n/>", 1) - 1);
    element.label = labelOf(element.startTag);
    element.contentBegin = element.contentEnd = element.end = at_ = end;
    const bool isEmpty = element.startTag[element.startTag.size() - 2] == '/';
    if (!isEmpty && !readContents(element, depth)) return false;
    parent.children.push_back(std::move(element));
    return true;
  }

  bool readContents(Element& element, int depth) {
    while (skipToTag() == Next::kTag) {
      if (text_[at_ + 1] != '/') {
        if (!readElement(element, depth + 1)) return false;
        continue;
      }
      const std::size_t end = endOfTag();
      if (end == std::string::npos || text_.compare(at_ + 2, element.name.size(), element.name) != 0)
        return false;
      element.contentEnd = at_;
      element.end = at_ = end;
      return true;
    }
    return false;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

/// "link[body]" as "link" and "body".
std::pair<std::string, std::string> stepParts(const std::string& step) {
  const std::size_t bracket = step.find('[');
  if (bracket == std::string::npos || step.back() != ']') return {step, {}};
  return {step.substr(0, bracket), step.substr(bracket + 1, step.size() - bracket - 2)};
}

/// The words between separators.
std::vector<std::string> wordsOf(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

/// Whether a name is one of the alternatives in "lidar|ray".
bool isOneOf(const std::string& name, const std::string& alternatives) {
  return ("|" + alternatives + "|").find("|" + name + "|") != std::string::npos;
}

const Element* childOf(const Element& parent, const std::string& step) {
  const auto [name, label] = stepParts(step);
  for (const Element& child : parent.children)
    if (isOneOf(child.name, name) && (label.empty() || child.label == label)) return &child;
  return nullptr;
}

std::string contentOf(const std::string& text, const Element& element) {
  std::string content = text.substr(element.contentBegin, element.contentEnd - element.contentBegin);
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return content.substr(first, content.find_last_not_of(" \t\r\n") - first + 1);
}

/// Whether an element is the <include> or <model> of this name in a world.
bool isInstance(const std::string& text, const Element& element, const std::string& name) {
  if (element.name == "model") return element.label == name;
  if (element.name != "include") return false;
  if (const Element* own = childOf(element, "name")) return contentOf(text, *own) == name;
  const Element* uri = childOf(element, "uri");
  if (uri == nullptr) return false;
  const std::string target = contentOf(text, *uri);
  return target.substr(target.find_last_of('/') + 1) == name;
}

/// The first element anywhere below for which the condition holds; in the order of the text.
template <typename Condition>
const Element* firstBelow(const Element& parent, const Condition& condition) {
  for (const Element& child : parent.children) {
    if (condition(child)) return &child;
    if (const Element* found = firstBelow(child, condition)) return found;
  }
  return nullptr;
}

int lineAt(const std::string& text, std::size_t position) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(position, text.size()));
  return static_cast<int>(std::count(text.begin(), end, '\n')) + 1;
}

/// The white space before an element, if it is alone on the beginning of its line.
std::string indentOf(const std::string& text, const Element& element) {
  const std::size_t newline = text.rfind('\n', element.begin);
  const std::size_t first = newline == std::string::npos ? 0 : newline + 1;
  const std::string before = text.substr(first, element.begin - first);
  return before.substr(0, before.find_first_not_of(" \t"));
}

/// The text of a value with no character that would end an element.
std::string escaped(const std::string& value) {
  std::string result;
  for (const char c : value) {
    if (c == '<' || c == '>' || c == '&') {
      result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

/// Nested elements of these names around a value: "<friction><ode><mu>1</mu></ode></friction>".
std::string nested(const std::vector<std::string>& steps, std::size_t from, const std::string& value) {
  std::string opening, closing;
  for (std::size_t i = from; i < steps.size(); ++i) {
    std::string name = stepParts(steps[i]).first;
    name = name.substr(0, name.find('|'));
    opening += "<" + name + ">";
    closing = "</" + name + ">" + closing;
  }
  return opening + escaped(value) + closing;
}

/// Adds missing elements at the end of one that is there.
std::string added(std::string text, const Element& parent, const std::string& xml) {
  const std::string indent = indentOf(text, parent);
  if (parent.contentEnd == parent.end) {
    // An empty tag: <surface/>
    const std::string tag = parent.startTag.substr(0, parent.startTag.find_last_of('/'));
    text.replace(parent.begin, parent.end - parent.begin, tag + ">" + xml + "</" + parent.name + ">");
    return text;
  }
  const std::size_t behind = parent.children.empty() ? parent.contentBegin : parent.children.back().end;
  const bool isOneLine = text.substr(parent.begin, parent.end - parent.begin).find('\n') == std::string::npos;
  text.insert(behind, isOneLine ? xml : "\n" + indent + "  " + xml);
  return text;
}

/// Whether a pose says that something is turned.
bool isTurned(const std::string& pose) {
  std::istringstream stream(pose);
  int at = 0;
  for (double number = 0; stream >> number; ++at) {
    if (at >= 3 && number != 0) return true;
  }
  return false;
}

/// Moments of inertia are in the axes of the pose next to them; others know them in the axes of the link.
Result<void> checkAxes(const std::string& text, const std::string& file, const Element& parent,
                       const std::string& name) {
  const Element* pose = name == "inertia" ? childOf(parent, "pose") : nullptr;
  if (pose == nullptr || !isTurned(contentOf(text, *pose))) return {};
  return failure("scene.file",
                 "these moments refer to the rotated <pose> next to them; edit them by hand in the file",
                 {file, lineAt(text, pose->begin), 0});
}

/// The text with another value in an element.
Result<std::string> withContent(const std::string& text, const std::string& file, const Element& element,
                                const std::string& value) {
  const bool isOther = element.startTag.find("degrees") != std::string::npos ||
                       element.startTag.find("relative_to") != std::string::npos ||
                       element.startTag.find("rotation_format") != std::string::npos;
  if (element.name == "pose" && isOther) {
    return failure("scene.file", "this pose is in degrees or in another frame; edit it by hand in the file",
                   {file, lineAt(text, element.begin), 0});
  }
  if (!element.children.empty())
    return failure("scene.file", "<" + element.name + "> has elements instead of a value",
                   {file, lineAt(text, element.begin), 0});
  std::string result = text;
  if (element.contentEnd == element.end) {
    result.replace(element.begin, element.end - element.begin,
                   "<" + element.name + ">" + escaped(value) + "</" + element.name + ">");
  } else {
    result.replace(element.contentBegin, element.contentEnd - element.contentBegin, escaped(value));
  }
  return result;
}

/// The text with a value for each name in the last step.
Result<std::string> withEachElement(const std::string& text, const std::string& file,
                                    std::vector<std::string> element,
                                    const std::vector<std::string>& values) {
  const auto names = wordsOf(element.back(), ',');
  if (names.size() != values.size())
    return failure("scene.file", "the number of values must match the number of elements: " + element.back(),
                   {file, 0, 0});
  Result<std::string> changed = text;
  for (std::size_t i = 0; changed && i < names.size(); ++i) {
    element.back() = names[i];
    changed = withElement(*changed, file, element, values[i]);
  }
  return changed;
}

}  // namespace

Result<std::string> withElement(const std::string& text, const std::string& file,
                                const std::vector<std::string>& element, const std::string& value) {
  const auto names = element.empty() ? std::vector<std::string>() : wordsOf(element.back(), ',');
  if (names.size() > 1) return withEachElement(text, file, element, wordsOf(value, ' '));
  Scanner scanner(text);
  const auto all = scanner.scan();
  if (!all) {
    return failure("scene.file", "its tags do not match; open the scene to see what is wrong",
                   {file, lineAt(text, scanner.position()), 0});
  }
  if (element.size() < 2) return failure("scene.file", "no element is named", {file, 0, 0});
  const std::pair<std::string, std::string> parts = stepParts(element.front());
  const std::string &first = parts.first, &name = parts.second;
  const bool isInstanceStep = first == "instance";
  const Element* at = firstBelow(*all, [&](const Element& each) {
    if (isInstanceStep) return isInstance(text, each, name);
    return each.name == first && (name.empty() || each.label == name);
  });
  if (at == nullptr) {
    return failure("scene.file",
                   isInstanceStep ? "there is no model " + name : "there is no " + element.front() + " in it",
                   {file, 0, 0}, {name});
  }
  for (std::size_t i = 1; i < element.size(); ++i) {
    if (const auto checked = checkAxes(text, file, *at, element[i]); !checked)
      return tl::unexpected(checked.error());
    const Element* next = childOf(*at, element[i]);
    if (next != nullptr) {
      at = next;
      continue;
    }
    // Named elements must exist already.
    if (!stepParts(element[i]).second.empty())
      return failure("scene.file", "there is no " + element[i] + " here", {file, lineAt(text, at->begin), 0},
                     {element[i]});
    return added(text, *at, nested(element, i, value));
  }
  return withContent(text, file, *at, value);
}

bool isFileOfScene(const std::filesystem::path& file, const std::filesystem::path& scene,
                   const std::filesystem::path& models) {
  namespace fs = std::filesystem;
  const auto isBelow = [&](const fs::path& folder) {
    std::error_code error;
    const fs::path relative = fs::relative(fs::absolute(file), folder, error);
    return !error && !relative.empty() && *relative.begin() != "..";
  };
  return isBelow(fs::absolute(scene).parent_path()) || isBelow(fs::absolute(models));
}

Result<void> writeSceneChanges(const std::filesystem::path& scene, const std::filesystem::path& models,
                               const std::vector<SceneFileChange>& changes) {
  std::map<std::string, std::string> before, texts;  // by file
  for (const SceneFileChange& change : changes) {
    if (!isFileOfScene(change.file, scene, models))
      return failure("scene.file", "it is not a file of the open scene, so it is not changed",
                     {change.file, 0, 0});
    if (!texts.contains(change.file)) {
      auto read = robotlink::readFile(change.file);
      if (!read) return tl::unexpected(read.error());
      before[change.file] = texts[change.file] = std::move(*read);
    }
    auto changed = withElement(texts[change.file], change.file, change.element, change.value);
    if (!changed) return tl::unexpected(changed.error());
    texts[change.file] = std::move(*changed);
  }
  for (const auto& [file, text] : texts) {
    if (text == before[file]) continue;
    if (auto written = robotlink::writeFileAtomically(file, text); !written) return written;
  }
  return {};
}

}  // namespace app
