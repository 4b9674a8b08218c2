// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SceneFiles.h"

#include <tinyxml2.h>

#include <algorithm>
#include <sstream>

#include "robotlink/base/AtomicFile.h"
#include "simcore/sdf/SdfCheck.h"
#include "simcore/sdf/SdfPaths.h"
#include "simcore/sdf/UrdfConversion.h"

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
      return "a closing tag does not match the last opened one, or a tag is never closed";
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

/// Returns the contents of a file, or the text that replaces them.
robotlink::Result<std::string> contentsOf(const fs::path& file, const SceneFiles::Texts& texts) {
  if (!texts.empty()) {
    std::error_code unknown;
    const auto text = texts.find(fs::weakly_canonical(fs::absolute(file, unknown), unknown));
    if (text != texts.end()) return text->second;
  }
  return robotlink::readFile(file, kMaxFileBytes);
}

/// Whether there is a model with a link.
bool hasLink(const tinyxml2::XMLDocument& document) {
  const XMLElement* root = document.RootElement();
  const XMLElement* model = root != nullptr ? root->FirstChildElement("model") : nullptr;
  return model != nullptr && model->FirstChildElement("link") != nullptr;
}

/// Reads and parses a whole file, a URDF after its conversion; returns false if it cannot be read or is not
/// XML.
bool readXml(const fs::path& file, const SceneFiles::Texts& texts, tinyxml2::XMLDocument& document,
             Errors& errors, LeftOuts& leftOut) {
  auto contents = contentsOf(file, texts);
  if (!contents) {
    errors.push_back(contents.error());
    return false;
  }
  if (document.Parse(contents->data(), contents->size()) != tinyxml2::XML_SUCCESS) {
    fail(errors, file, std::max(1, document.ErrorLineNum()), "scene.xml",
         "this is not well-formed XML: " + problemOf(document.ErrorID()));
    return false;
  }
  XMLElement* root = document.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "robot") return true;
  UrdfParts parts;
  const Errors problems = checkUrdf(*root, file.string(), parts, leftOut);
  errors.insert(errors.end(), problems.begin(), problems.end());
  if (!problems.empty()) return false;
  tinyxml2::XMLPrinter prepared(nullptr, true);
  document.Print(&prepared);
  const auto converted = sdfOfUrdf(prepared.CStr(), file.string());
  if (!converted) {
    errors.push_back(converted.error());
    return false;
  }
  if (document.Parse(converted->data(), converted->size()) != tinyxml2::XML_SUCCESS) {
    fail(errors, file, 1, "scene.urdf", "this URDF becomes SDFormat that is nested too deeply");
    return false;
  }
  if (!hasLink(document)) {
    fail(errors, file, 1, "scene.urdf",
         "no link is left of this URDF, because links without <inertial> are left out");
    return false;
  }
  finishUrdf(*document.RootElement(), file.string(), parts, leftOut);
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
    const bool areThree = !stream.fail() && (stream >> std::ws).eof();
    const bool areBytes = std::ranges::all_of(channels, [](int c) { return c >= 0 && c <= 255; });
    if (name == nullptr || !areThree || !areBytes) {
      fail(errors, file, sourceLine(*color), "scene.palette",
           "a color needs a name and three numbers from 0 to 255");
      continue;
    }
    const auto byte = [&](int i) { return static_cast<std::uint8_t>(channels[i]); };
    // The world's colors are read first and go before those that its models bring.
    palette.try_emplace(name, Rgb{byte(0), byte(1), byte(2)});
  }
}

/// The contents of a world's <include>, except for its file.
SceneInclude readDetails(const XMLElement& element, const fs::path& world, Errors& errors) {
  SceneInclude include;
  include.line = sourceLine(element);
  include.name = childText(element, "name");
  include.team = childText(element, "robotcontrol:team");
  include.layout = layoutIn(childText(element, "robotcontrol:layout"), world);
  include.role = childText(element, "robotcontrol:role");
  include.motion = childText(element, "robotcontrol:motion");
  const XMLElement* motion = element.FirstChildElement("robotcontrol:motion");
  if (motion != nullptr && motion->Attribute("objects") != nullptr)
    include.motionAtObjects = motion->Attribute("objects");
  if (element.FirstChildElement("static") != nullptr) include.isStatic = isTrue(childText(element, "static"));
  const XMLElement* pose = element.FirstChildElement("pose");
  if (pose == nullptr || trimmedText(pose).empty()) return include;
  include.pose = poseIn(*pose);
  if (!include.pose) {
    fail(errors, world, sourceLine(*pose), "scene.pose",
         hasQuaternion(*pose) ? "a pose as a quaternion is seven numbers: x y z qx qy qz qw"
                              : "a pose is six numbers: x y z roll pitch yaw");
  }
  return include;
}

/// Puts a copy of a file's light into the world instead of the <include> that names it: libraries have lamps
/// that are included like models.
void insertLight(const XMLElement& light, const XMLElement& include, XMLElement& world) {
  XMLElement* copy = light.DeepClone(world.GetDocument())->ToElement();
  const std::string name = childText(include, "name");
  if (!name.empty()) copy->SetAttribute("name", name.c_str());
  if (const XMLElement* pose = include.FirstChildElement("pose")) {
    if (XMLElement* own = copy->FirstChildElement("pose")) copy->DeleteChild(own);
    copy->InsertEndChild(pose->DeepClone(world.GetDocument()));
  }
  world.InsertEndChild(copy);
}

/// Only one world or model of a file is read.
void leaveOutOthers(const XMLElement& root, const XMLElement& read, const fs::path& file, LeftOuts& leftOut) {
  for (auto* other = root.FirstChildElement(); other != nullptr; other = other->NextSiblingElement()) {
    const std::string name = other->Name();
    if (other == &read || name.find(':') != std::string::npos) continue;
    leaveOut(leftOut, {{file.string(), sourceLine(*other), 0},
                       nameOf(*other),
                       "<" + name + ">",
                       "only one world or model per file is read, here <" + std::string(read.Name()) +
                           " name=\"" + nameOf(read) + "\">"});
  }
}

bool isWorld(const XMLElement& element) {
  return std::string_view(element.Name()) == "world";
}

}  // namespace

SceneFiles::SceneFiles(const fs::path& file, const std::vector<fs::path>& folders, Palette palette)
    : file_(file), palette_(std::move(palette)), search_(file, folders) {}
SceneFiles::~SceneFiles() = default;
SceneFiles::SceneFiles(SceneFiles&&) noexcept = default;
SceneFiles& SceneFiles::operator=(SceneFiles&&) noexcept = default;

SceneFiles::SceneFiles(const fs::path& file, const std::vector<fs::path>& folders, Texts texts,
                       const SdfSpec& spec, Errors& errors)
    : file_(file), texts_(std::move(texts)), search_(file, folders) {
  tinyxml2::XMLDocument* document = read(file, spec, errors);
  XMLElement* root = document != nullptr ? document->RootElement() : nullptr;
  if (root == nullptr) return;
  if (root->FirstChildElement("world") == nullptr && root->FirstChildElement("model") == nullptr) {
    fail(errors, file, sourceLine(*root), "scene.no-world",
         R"(the file must describe a world: <sdf version="1.9"><world name="...">, or a model)");
    return;
  }
  if (XMLElement* world = root->FirstChildElement("world")) {
    leaveOutOthers(*root, *world, file, leftOut_);
    readPalette(*world, file, palette_, errors);
    readIncludes(*world, file, spec, errors);
  } else {
    readModel(file, {file.string(), 1, 0}, spec, errors);
  }
}

tinyxml2::XMLDocument* SceneFiles::read(const fs::path& file, const SdfSpec& spec, Errors& errors) {
  auto& document = documents_[file];
  if (document) return document.get();
  document = std::make_unique<tinyxml2::XMLDocument>();
  if (!readXml(file, texts_, *document, errors, leftOut_)) {
    document->Clear();
    return nullptr;
  }
  checkSdfTree(*document, file.string(), spec, errors, leftOut_);
  return document.get();
}

const XMLElement* SceneFiles::world() const {
  const auto found = documents_.find(file_);
  const XMLElement* root = found != documents_.end() ? found->second->RootElement() : nullptr;
  return root != nullptr ? root->FirstChildElement("world") : nullptr;
}

const XMLElement* SceneFiles::model(const fs::path& file) const {
  const auto found = documents_.find(file);
  const XMLElement* root = found != documents_.end() ? found->second->RootElement() : nullptr;
  return root != nullptr ? root->FirstChildElement("model") : nullptr;
}

const fs::path* SceneFiles::fileOf(const XMLElement& include) const {
  const auto found = included_.find(&include);
  return found != included_.end() ? &found->second : nullptr;
}

void SceneFiles::readIncludes(XMLElement& parent, const fs::path& file, const SdfSpec& spec, Errors& errors) {
  for (XMLElement* child = parent.FirstChildElement(); child != nullptr;) {
    XMLElement* const next = child->NextSiblingElement();
    const std::string_view name = child->Name();
    if (name == "include") {
      if (!readInclude(*child, file, spec, errors)) parent.DeleteChild(child);
    } else if (name == "model") {
      readPalette(*child, file, palette_, errors);
      readIncludes(*child, file, spec, errors);
    }
    child = next;
  }
}

bool SceneFiles::readInclude(XMLElement& element, const fs::path& file, const SdfSpec& spec, Errors& errors) {
  const std::string uri = childText(element, "uri");
  const robotlink::FilePosition where{file.string(), sourceLine(element), 0};
  if (isNetworkUri(uri)) {
    leaveOut(leftOut_, {where, objectPath(element), "<include> of " + uri,
                        "nothing is fetched from the network; get the model, and name its folder"});
    return false;
  }
  const auto model = search_.findModel(uri, file);
  if (!model) {
    const std::string path = objectPath(element);
    fail(errors, file, where.line, "scene.unknown-model",
         (path.empty() ? "" : path + ": ") + "there is no model '" + uri +
             "'; name the folder that contains it " +
             "with --models or GZ_SIM_RESOURCE_PATH (searched: " + search_.describe() + ")");
    return true;
  }
  if (isTrue(element.Attribute("merge") != nullptr ? element.Attribute("merge") : "")) {
    leaveOut(leftOut_,
             {where, objectPath(element), "merge=\"true\"", "the model stays a model in the model"});
  }
  if (const XMLElement* light = lightOf(*model, spec, errors)) {
    insertLight(*light, element, *element.Parent()->ToElement());
    return false;
  }
  included_[&element] = *model;
  if (isWorld(*element.Parent()->ToElement())) {
    SceneInclude include = readDetails(element, file, errors);
    include.file = *model;
    includes_.push_back(std::move(include));
  }
  readModel(*model, where, spec, errors);
  return true;
}

const XMLElement* SceneFiles::lightOf(const fs::path& file, const SdfSpec& spec, Errors& errors) {
  const tinyxml2::XMLDocument* document = read(file, spec, errors);
  const XMLElement* root = document != nullptr ? document->RootElement() : nullptr;
  if (root == nullptr || root->FirstChildElement("model") != nullptr) return nullptr;
  return root->FirstChildElement("light");
}

void SceneFiles::readModel(const fs::path& file, const robotlink::FilePosition& where, const SdfSpec& spec,
                           Errors& errors) {
  if (!modelsRead_.insert(file).second) return;
  tinyxml2::XMLDocument* document = read(file, spec, errors);
  if (document == nullptr) return;
  XMLElement* root = document->RootElement();
  XMLElement* model = root != nullptr ? root->FirstChildElement("model") : nullptr;
  if (model == nullptr) {
    errors.push_back({"scene.unknown-model", "'" + file.string() + "' describes no model", {}, where});
    return;
  }
  leaveOutOthers(*root, *model, file, leftOut_);
  readPalette(*model, file, palette_, errors);
  readIncludes(*model, file, spec, errors);
}

std::optional<fs::path> SceneFiles::addModel(const std::string& name, const SdfSpec& spec, Errors& errors) {
  // Only a name is allowed, not a path to elsewhere.
  const bool isName = !name.empty() && name.find('/') == std::string::npos && name != "." && name != "..";
  const auto model = isName ? search_.findModel("model://" + name, file_) : std::nullopt;
  if (!model) {
    fail(errors, file_, 0, "scene.unknown-model", "there is no model '" + name + "' to add robots of");
    return std::nullopt;
  }
  readModel(*model, {file_.string(), 0, 0}, spec, errors);
  return model;
}

std::optional<fs::path> SceneFiles::addModelOf(const std::string& source, const SdfSpec& spec,
                                               Errors& errors) {
  const bool isName = source.find_first_of("/.") == std::string::npos;
  auto model = search_.findModel(isName ? "model://" + source : source, file_);
  if (!model && isName) model = search_.findRobot(source);
  // A path is relative to the working directory, like that of other files in commands.
  std::error_code unknown;
  if (!model && fs::is_regular_file(source, unknown))
    model = fs::absolute(source, unknown).lexically_normal();
  if (!model) {
    errors.push_back({"scene.unknown-model",
                      "there is no model '" + source +
                          "'; name the folder that contains it with --models or "
                          "GZ_SIM_RESOURCE_PATH (searched: " +
                          search_.describe() + ")",
                      {source},
                      {}});
    return std::nullopt;
  }
  readModel(*model, {model->string(), 0, 0}, spec, errors);
  return model;
}

}  // namespace simcore
