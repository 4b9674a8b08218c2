// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>

#include "widgets/sceneedit/SceneLanguage.h"

namespace widgets::test {

/// A small language of scene files: sdf > world > model > link > mass, include > uri. A text with "wrong" in
/// a line has an error there, one with "foreign" a warning. Models are files beside the scene: NAME.sdf.
class ToyLanguage : public SceneLanguage {
 public:
  std::vector<SceneElement> children(const Path& path) const override {
    const auto found = elements().find(path.empty() ? "" : path.back());
    return found == elements().end() ? std::vector<SceneElement>() : found->second;
  }
  std::optional<SceneElement> element(const Path& path) const override {
    if (path.empty()) return std::nullopt;
    for (const SceneElement& one : children(Path(path.begin(), path.end() - 1))) {
      if (one.name == path.back()) return one;
    }
    return std::nullopt;
  }
  std::vector<SceneProblem> check(const std::string& text, const std::filesystem::path& file) const override {
    std::vector<SceneProblem> problems;
    int line = 1;
    std::string row;
    for (const char c : text + "\n") {
      if (c != '\n') {
        row += c;
        continue;
      }
      if (row.find("wrong") != std::string::npos)
        problems.push_back({false, "this is wrong", file.string(), line});
      if (row.find("foreign") != std::string::npos)
        problems.push_back({true, "this is ignored", file.string(), line});
      row.clear();
      ++line;
    }
    return problems;
  }
  std::vector<SceneModelChoice> models(const std::filesystem::path&) const override {
    return {{"crate", "model://crate", false}, {"rover", "model://rover", true}};
  }
  std::optional<std::filesystem::path> modelFile(const std::string& uri,
                                                 const std::filesystem::path& file) const override {
    const auto model = file.parent_path() / (uri.substr(uri.rfind('/') + 1) + ".sdf");
    return std::filesystem::exists(model) ? std::optional(model) : std::nullopt;
  }
  /// Puts the value into the first element of the last step's name in the object that the first step names.
  robotlink::Result<std::string> withElement(const std::string& text, const std::filesystem::path& file,
                                             const std::vector<std::string>& element,
                                             const std::string& value) const override {
    const std::string& first = element.front();
    const std::size_t bracket = first.find('[');
    const std::string name =
        bracket == std::string::npos ? "" : first.substr(bracket + 1, first.size() - bracket - 2);
    const std::size_t object = name.empty() ? 0 : text.find(name);
    const std::string open = "<" + element.back() + ">", close = "</" + element.back() + ">";
    const std::size_t begin = object == std::string::npos ? object : text.find(open, object);
    if (begin == std::string::npos)
      return robotlink::failure("toy", "no such element", {file.string(), 0, 0});
    const std::size_t content = begin + open.size();
    return text.substr(0, content) + value + text.substr(text.find(close, content));
  }
  robotlink::Result<std::string> newObject(const std::string& kind, const std::string& name, double x,
                                           double y, const std::filesystem::path&) const override {
    if (kind == "nothing") return robotlink::failure("toy", "there is no such kind");
    return "    <model name=\"" + name + "\"><pose>" + std::to_string(int(x)) + " " + std::to_string(int(y)) +
           " 0 0 0 0</pose></model>\n";
  }
  robotlink::Result<std::string> newRoom(const RoomChoice& room,
                                         const std::filesystem::path&) const override {
    if (room.name.find(' ') != std::string::npos)
      return robotlink::failure("scene.name", "a name has no blanks");
    return "<sdf>\n  <world name=\"" + room.name + "\">\n    <!-- " + room.robot +
           " -->\n  </world>\n</sdf>\n";
  }

 private:
  static const std::map<std::string, std::vector<SceneElement>>& elements() {
    static const SceneAttribute kName{"name", "string", "__default__", "What it is called.", true};
    static const SceneAttribute kFixed{"fixed", "bool", "false", "Whether it stays.", false};
    static const std::map<std::string, std::vector<SceneElement>> kElements{
        {"", {{"sdf", "", "", "The root.", true, false, {}}}},
        {"sdf",
         {{"world", "", "", "A world.", false, true, {kName}},
          {"model", "", "", "A model.", false, true, {kName}}}},
        {"world",
         {{"model", "", "", "A model of the world.", false, true, {kName, kFixed}},
          {"include", "", "", "A model of another file.", false, true, {}}}},
        {"model",
         {{"link", "", "", "A rigid body.", false, true, {kName}},
          {"static", "bool", "false", "Never moves.", false, false, {}}}},
        {"link", {{"mass", "double", "1", "Mass, kg.", false, false, {}}}},
        {"include", {{"uri", "string", "__default__", "Which one.", true, false, {}}}}};
    return kElements;
  }
};

}  // namespace widgets::test
