// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the text of a new world from the shipped template.
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "app/platforms/simulated/scenetext/SceneText.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"

namespace app {
namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Result;

namespace {

constexpr double kWallThickness = 0.1, kDoorway = 1;
constexpr double kMinRoom = 2, kMaxRoom = 50, kMinWall = 0.1, kMaxWall = 5;

using TemplateWords = std::map<std::string, std::string>;

/// A length in m, without digits that say nothing.
std::string lengthText(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3f", value);
  std::string text = buffer;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// A shipped text with each @word@ replaced by its value.
Result<std::string> filledTemplate(const char* name, const TemplateWords& values) {
  auto text = robotlink::readFile(robotlink::resource("scene-templates") / name);
  if (!text) return text;
  for (const auto& [word, value] : values) {
    const std::string marked = "@" + word + "@";
    for (std::size_t at = text->find(marked); at != std::string::npos; at = text->find(marked, at))
      text->replace(at, marked.size(), value);
  }
  return text;
}

struct Wall {
  const char* name;
  double x, y, sizeX, sizeY;
};

std::vector<Wall> wallsOf(const NewRoom& room) {
  const double middleX = (room.width + kWallThickness) / 2, middleY = (room.depth + kWallThickness) / 2;
  const double outer = room.width + 2 * kWallThickness;
  std::vector<Wall> walls{{"wall_north", 0, middleY, outer, kWallThickness},
                          {"wall_south", 0, -middleY, outer, kWallThickness},
                          {"wall_east", middleX, 0, kWallThickness, room.depth},
                          {"wall_west", -middleX, 0, kWallThickness, room.depth}};
  if (room.doorway) {
    const double length = (room.depth - kDoorway) / 2, middle = (room.depth + kDoorway) / 4;
    walls.push_back({"left_of_doorway", 0, middle, kWallThickness, length});
    walls.push_back({"right_of_doorway", 0, -middle, kWallThickness, length});
  }
  return walls;
}

Result<std::string> wallTexts(const NewRoom& room) {
  std::string all;
  for (const Wall& wall : wallsOf(room)) {
    auto text = filledTemplate("wall.sdf", {{"name", wall.name},
                                            {"x", lengthText(wall.x)},
                                            {"y", lengthText(wall.y)},
                                            {"z", lengthText(room.wallHeight / 2)},
                                            {"sizeX", lengthText(wall.sizeX)},
                                            {"sizeY", lengthText(wall.sizeY)},
                                            {"height", lengthText(room.wallHeight)}});
    if (!text) return text;
    all += *text;
  }
  return all;
}

Result<std::string> roomText(const NewRoom& room, const std::string& robot) {
  const auto walls = wallTexts(room);
  if (!walls) return walls;
  return filledTemplate("room.sdf", {{"name", room.name},
                                     {"width", lengthText(room.width)},
                                     {"depth", lengthText(room.depth)},
                                     {"outerWidth", lengthText(room.width + 2 * kWallThickness)},
                                     {"outerDepth", lengthText(room.depth + 2 * kWallThickness)},
                                     {"walls", *walls},
                                     {"robot", robot}});
}

/// The height at which a robot stands: that at which the simulator would add it to the room.
Result<double> standingHeight(const NewRoom& room, const fs::path& model) {
  const auto text = roomText(room, {});
  if (!text) return tl::unexpected(text.error());
  std::error_code unknown;
  std::string folder = (fs::temp_directory_path(unknown) / "robotcontrol-room-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return failure("scene.new", "no temporary file can be written");
  Result<double> height = failure("scene.new", "the robot cannot be placed in the room");
  // A link next to the room, so that the model is found by its name.
  fs::create_directory_symlink(model.parent_path(), fs::path(folder) / room.robot, unknown);
  const fs::path file = fs::path(folder) / "room.sdf";
  if (const auto written = robotlink::writeFileAtomically(file, *text); !written) {
    height = tl::unexpected(written.error());
  } else {
    simcore::RobotsToAdd added;
    added.count = 1;
    added.model = room.robot;
    const auto scene = simcore::Scene::load(file, added);
    if (!scene) {
      height = tl::unexpected(scene.error().front());
    } else if (const auto simulation = simcore::Simulation::create(*scene, {}); simulation) {
      const auto pose = (*simulation)->modelPose((*scene)->robots().front().name);
      if (pose) height = pose->translation().z();
    }
  }
  fs::remove_all(folder, unknown);
  return height;
}

Result<std::string> robotText(const NewRoom& room, const fs::path& file, const ModelFolders& folders) {
  if (room.robot.empty()) return std::string();
  const auto models = sceneModels(file, folders);
  const auto model = std::ranges::find(models, room.robot, &SceneModelFile::name);
  if (model == models.end() || !model->isRobot)
    return failure("scene.no-robot", "there is no robot '" + room.robot + "'", {}, {room.robot});
  const auto height = standingHeight(room, model->file);
  if (!height) return tl::unexpected(height.error());
  return filledTemplate("include.sdf",
                        {{"uri", model->uri},
                         {"name", room.robot + "1"},
                         {"pose", lengthText(-room.width / 4) + " 0 " + lengthText(*height) + " 0 0 0"}});
}

/// The <include> of a model at a place of the ground.
Result<std::string> includeText(const std::string& uri, const std::string& name, double x, double y,
                                double z) {
  return filledTemplate("include.sdf",
                        {{"uri", uri},
                         {"name", name},
                         {"pose", lengthText(x) + " " + lengthText(y) + " " + lengthText(z) + " 0 0 0"}});
}

Result<void> checkRoom(const NewRoom& room) {
  const bool isName = !room.name.empty() && std::ranges::all_of(room.name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
  if (!isName) return failure("scene.name", "a scene's name consists of letters, digits, '_' and '-'");
  const auto isIn = [](double value, double least, double most) { return value >= least && value <= most; };
  if (!isIn(room.width, kMinRoom, kMaxRoom) || !isIn(room.depth, kMinRoom, kMaxRoom))
    return failure("scene.size", "a room is from 2 to 50 m wide and deep");
  if (!isIn(room.wallHeight, kMinWall, kMaxWall))
    return failure("scene.size", "walls are from 0.1 to 5 m high");
  return {};
}

}  // namespace

Result<std::string> newObjectText(const std::string& kind, const std::string& name, double x, double y,
                                  const fs::path& file, const ModelFolders& folders) {
  constexpr double kMaxPlace = 1000;
  if (!(std::abs(x) <= kMaxPlace) || !(std::abs(y) <= kMaxPlace))
    return failure("scene.place", "an object must be within 1000 m of the center of the scene");
  static const std::map<std::string, const char*> kSimple{
      {"box", "box.sdf"},   {"ball", "ball.sdf"},     {"cylinder", "cylinder.sdf"},
      {"lamp", "lamp.sdf"}, {"camera", "camera.sdf"}, {"wall", "single-wall.sdf"}};
  if (const auto simple = kSimple.find(kind); simple != kSimple.end())
    return filledTemplate(simple->second, {{"name", name}, {"x", lengthText(x)}, {"y", lengthText(y)}});
  const auto models = sceneModels(file, folders);
  const auto model = std::ranges::find(models, kind, &SceneModelFile::name);
  if (model == models.end())
    return failure("scene.unknown-model",
                   "there is no model '" + kind +
                       "'; besides models, there are box, ball, cylinder, wall, lamp and camera",
                   {}, {kind});
  if (!model->isRobot) return includeText(model->uri, name, x, y, 0);
  const auto height = standingHeight({.robot = kind}, model->file);
  if (!height) return tl::unexpected(height.error());
  return includeText(model->uri, name, x, y, *height);
}

Result<std::string> newRoomText(const NewRoom& room, const fs::path& file, const ModelFolders& folders) {
  if (const auto checked = checkRoom(room); !checked) return tl::unexpected(checked.error());
  const auto robot = robotText(room, file, folders);
  if (!robot) return robot;
  return roomText(room, *robot);
}

}  // namespace app
