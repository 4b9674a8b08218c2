// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/SceneFixture.h"

#include <gtest/gtest.h>

namespace simcore {
namespace fs = std::filesystem;

const char* const kSmallModel = R"(<?xml version="1.0"?>
<sdf version="1.9" xmlns:robotcontrol="urn:robotcontrol:sdf">
  <model name="small">
    <robotcontrol:palette><robotcontrol:color name="red">200 0 0</robotcontrol:color></robotcontrol:palette>
    <link name="foot">
      <inertial>
        <mass>1.5</mass>
        <inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia>
      </inertial>
      <collision name="sole"><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision>
      <visual name="sole"><geometry><box><size>0.1 0.1 0.1</size></box></geometry><robotcontrol:color>red</robotcontrol:color></visual>
    </link>
    <link name="arm">
      <pose relative_to="foot">0 0 0.1 0 0 0</pose>
      <inertial><mass>0.2</mass></inertial>
      <collision name="hand"><geometry><sphere><radius>0.02</radius></sphere></geometry></collision>
      <sensor name="touch" type="contact"><contact><collision>hand</collision></contact></sensor>
    </link>
    <joint name="hip" type="revolute">
      <parent>foot</parent>
      <child>arm</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper><effort>2</effort><velocity>3</velocity></limit></axis>
      <robotcontrol:servo><robotcontrol:initial_position>0.5</robotcontrol:initial_position></robotcontrol:servo>
    </joint>
  </model>
</sdf>
)";

void SceneFolder::writeModel(const std::string& name, const std::string& text) const {
  write("models/" + name + "/model.sdf", text);
}

void SceneFolder::copyShippedModels() const {
  fs::copy(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/models", path() / "models",
           fs::copy_options::recursive);
}

std::string SceneFolder::errorsOf(const std::string& world) const {
  const auto scene = Scene::load(write("world.sdf", world));
  if (scene) return "";
  std::string text = describe(scene.error());
  const std::string folder = path().string() + "/";
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.erase(at, folder.size());
  return text;
}

std::shared_ptr<const Scene> shippedScene() {
  static const auto kScene = Scene::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf");
  EXPECT_TRUE(kScene) << describe(kScene.error());
  return kScene ? *kScene : nullptr;
}

std::string worldAround(const std::string& contents) {
  return "<sdf version=\"1.9\" xmlns:robotcontrol=\"urn:robotcontrol:sdf\">\n<world name=\"test\">\n" +
         contents + "\n</world>\n</sdf>\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace simcore
