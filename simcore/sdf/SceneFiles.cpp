// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SceneFiles.h"

#include <tinyxml2.h>

#include <algorithm>
#include <sstream>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "simcore/sdf/SdfCheck.h"

namespace simcore {
namespace fs = std::filesystem;
using robotlink::Errors;
using tinyxml2::XMLElement;

namespace {

constexpr std::size_t kMaxFileBytes = 16U << 20U;

void fail(Errors& errors, const fs::path& file, int line, std::string id, std::string text) {
  errors.push_back({std::move(id), std::move(text), {}, {file.string(), line, 0}});
}

/// The problem in words for users.
std::string problemOf(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file is empty";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "a tag is closed that is not the one that was opened last, or one is never closed";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "a tag is not complete; it looks like <name ...> or <name .../>";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not written as name=\"value\"";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed by -->";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a <![CDATA[ is not closed by ]]>";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "there is text where only tags may be";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "the <?xml ...?> at the beginning is not complete";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "tags are nested too deeply";
    default:
      return "something here is not XML";
  }
}

/// Reads and parses a whole file; returns false if it cannot be read or is not XML.
bool readXml(const fs::path& file, std::string& text, tinyxml2::XMLDocument& document, Errors& errors) {
  auto contents = robotlink::readFile(file, kMaxFileBytes);
  if (!contents) {
    errors.push_back(contents.error());
    return false;
  }
  text = std::move(*contents);
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    fail(errors, file, std::max(1, document.ErrorLineNum()), "scene.xml",
         "this is not well-formed XML: " + problemOf(document.ErrorID()));
    return false;
  }
  return true;
}

/// Reads the <robotcontrol:palette> of a world or a model: <robotcontrol:color name="green">0 130
/// 50</robotcontrol:color> ...
void readPalette(const XMLElement& parent, const fs::path& file, Palette& palette, Errors& errors) {
  const XMLElement* element = parent.FirstChildElement("robotcontrol:palette");
  if (element == nullptr) return;
  for (auto* color = element->FirstChildElement(); color != nullptr; color = color->NextSiblingElement()) {
    const char* name = color->Attribute("name");
    std::istringstream stream(color->GetText() != nullptr ? color->GetText() : "");
    int channels[3] = {-1, -1, -1};
    stream >> channels[0] >> channels[1] >> channels[2];
    if (name == nullptr || !std::ranges::all_of(channels, [](int c) { return c >= 0 && c <= 255; })) {
      fail(errors, file, color->GetLineNum(), "scene.palette",
           "a color needs a name and three numbers from 0 to 255");
      continue;
    }
    const auto byte = [&](int i) { return static_cast<std::uint8_t>(channels[i]); };
    palette[name] = {byte(0), byte(1), byte(2)};
  }
}

std::string childText(const XMLElement& element, const char* name) {
  const XMLElement* child = element.FirstChildElement(name);
  return child != nullptr && child->GetText() != nullptr ? child->GetText() : "";
}

/// The model file of a URI: model://NAME below the world's folder, below its models folder, or among the
/// shipped models.
std::optional<fs::path> resolve(const std::string& uri, const fs::path& world) {
  const fs::path folder = world.parent_path();
  std::vector<fs::path> candidates;
  constexpr std::string_view kScheme = "model://";
  if (uri.starts_with(kScheme)) {
    const fs::path name = uri.substr(kScheme.size());
    candidates = {folder / name, folder / "models" / name, robotlink::resource("scenes/models") / name};
  } else if (uri.find("://") == std::string::npos && !uri.empty()) {
    candidates = {folder / uri};
  }
  std::error_code error;
  for (const fs::path& candidate : candidates) {
    const fs::path file = fs::is_directory(candidate, error) ? candidate / "model.sdf" : candidate;
    if (fs::is_regular_file(file, error)) return fs::weakly_canonical(file, error);
  }
  return std::nullopt;
}

bool readPose(const std::string& text, SceneInclude& include) {
  std::istringstream stream(text);
  for (double& number : include.pose) stream >> number;
  std::string rest;
  return !stream.fail() && !(stream >> rest);
}

std::optional<SceneInclude> readInclude(const XMLElement& element, const fs::path& world, Errors& errors) {
  SceneInclude include;
  include.line = element.GetLineNum();
  const std::string uri = childText(element, "uri");
  const auto file = resolve(uri, world);
  if (!file) {
    fail(errors, world, include.line, "scene.unknown-model", "there is no model '" + uri + "'");
    return std::nullopt;
  }
  include.file = *file;
  include.name = childText(element, "name");
  include.team = childText(element, "robotcontrol:team");
  const std::string isStatic = childText(element, "static");
  include.isStatic = isStatic == "true" || isStatic == "1";
  const XMLElement* pose = element.FirstChildElement("pose");
  if (pose != nullptr && !readPose(childText(element, "pose"), include)) {
    fail(errors, world, pose->GetLineNum(), "scene.pose", "a pose is six numbers: x y z roll pitch yaw");
  }
  if (pose != nullptr && pose->FirstAttribute() != nullptr) {
    fail(errors, world, pose->GetLineNum(), "scene.pose", "the pose of an <include> takes no attributes");
  }
  return include;
}

/// Overwrites the text between `begin` and `end` with spaces, except for line ends.
void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end && i < text.size(); ++i) {
    if (text[i] != '\n') text[i] = ' ';
  }
}

/// Blanks every <include> element of well-formed XML, with regard to comments and CDATA.
void blankIncludes(std::string& text) {
  constexpr std::string_view kOpen = "<include", kClose = "</include>";
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string::npos) {
    const std::string_view rest = std::string_view(text).substr(at);
    if (rest.starts_with("<!--")) {
      at = text.find("-->", at);
    } else if (rest.starts_with("<![CDATA[")) {
      at = text.find("]]>", at);
    } else if (rest.starts_with(kOpen) &&
               (rest[kOpen.size()] == '>' || std::isspace(rest[kOpen.size()]) != 0)) {
      const std::size_t end = text.find(kClose, at);
      blank(text, at, end + kClose.size());
      at = end;
    } else {
      ++at;
    }
    if (at == std::string::npos) return;
  }
}

/// Reads and checks a model's file once, and collects its colors. `where` is the place that refers to it.
void readModel(SceneFiles& files, const fs::path& model, const robotlink::FilePosition& where,
               const SdfSpec& spec, Errors& errors) {
  if (files.models.contains(model)) return;
  std::string& text = files.models[model];
  tinyxml2::XMLDocument document;
  if (!readXml(model, text, document, errors)) return;
  checkSdfTree(document, model.string(), spec, errors);
  const XMLElement* root = document.RootElement();
  const XMLElement* element = root != nullptr ? root->FirstChildElement("model") : nullptr;
  if (element == nullptr) {
    errors.push_back({"scene.unknown-model", "'" + model.string() + "' describes no model", {}, where});
  } else {
    readPalette(*element, model, files.palette, errors);
  }
}

}  // namespace

SceneFiles SceneFiles::read(const fs::path& file, const SdfSpec& spec, Errors& errors) {
  SceneFiles files;
  tinyxml2::XMLDocument document;
  if (!readXml(file, files.worldText, document, errors)) return files;
  checkSdfTree(document, file.string(), spec, errors);
  if (!errors.empty()) return files;
  const XMLElement* root = document.RootElement();
  const XMLElement* world = root != nullptr ? root->FirstChildElement("world") : nullptr;
  if (world == nullptr) {
    fail(errors, file, 1, "scene.no-world",
         R"(the file must describe a world: <sdf version="1.9"><world name="...">)");
    return files;
  }
  for (auto* element = world->FirstChildElement("include"); element != nullptr;
       element = element->NextSiblingElement("include")) {
    if (auto include = readInclude(*element, file, errors)) files.includes.push_back(std::move(*include));
  }
  readPalette(*world, file, files.palette, errors);
  for (auto* model = world->FirstChildElement("model"); model != nullptr;
       model = model->NextSiblingElement("model")) {
    readPalette(*model, file, files.palette, errors);
  }
  for (const SceneInclude& include : files.includes) {
    readModel(files, include.file, {file.string(), include.line, 0}, spec, errors);
  }
  blankIncludes(files.worldText);
  return files;
}

std::optional<fs::path> SceneFiles::addModel(const std::string& name, const fs::path& scene,
                                             const SdfSpec& spec, Errors& errors) {
  // Only a name is allowed, not a path to elsewhere.
  const bool isName = !name.empty() && name.find('/') == std::string::npos && name != "." && name != "..";
  const auto model = isName ? resolve("model://" + name, scene) : std::nullopt;
  if (!model) {
    fail(errors, scene, 0, "scene.unknown-model", "there is no model '" + name + "' to add robots of");
    return std::nullopt;
  }
  readModel(*this, *model, {scene.string(), 0, 0}, spec, errors);
  return model;
}

}  // namespace simcore
