// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/moving/MovingScenes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

constexpr const char* kMovingFloor =
    "<model name='floor'><static>true</static><link name='floor'><collision name='floor'><geometry><plane>"
    "<normal>0 0 1</normal><size>9 9</size></plane></geometry></collision></link></model>";

std::string shippedModel(const std::string& name) {
  std::ifstream file(std::string(ROBOTCONTROL_SOURCE_DIR) + "/resources/scenes/models/" + name +
                     "/model.sdf");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string wheelLink(const std::string& name, const std::string& parent, const std::string& place,
                      double radius, const std::string& limit) {
  std::ostringstream text;
  text << "<link name='" << name << "'><pose relative_to='" << parent << "'>" << place
       << " 0 0 0</pose><inertial><mass>0.2</mass><inertia><ixx>2e-4</ixx><iyy>3e-4</iyy><izz>2e-4</izz>"
          "</inertia></inertial><collision name='tire'><pose>0 0 0 1.570796 0 0</pose><geometry><cylinder>"
          "<radius>"
       << radius
       << "</radius><length>0.03</length></cylinder></geometry></collision></link><joint name='axle_" << name
       << "' type='continuous'><parent>" << parent << "</parent><child>" << name
       << "</child><axis><xyz>0 1 0</xyz>" << limit << "</axis></joint>";
  return text.str();
}

}  // namespace

std::string including(const std::string& model, const std::string& pose, const std::string& more) {
  return "<include><uri>model://" + model + "</uri><pose>" + pose + "</pose>" + more + "</include>";
}

std::string trolley() {
  const std::string motor = "<limit><velocity>30</velocity><effort>1</effort></limit>";
  return "<model name='trolley'><link name='base'><inertial><pose>-0.06 0 0.1 0 0 0</pose><mass>4</mass>"
         "<inertia><ixx>0.02</ixx><iyy>0.02</iyy><izz>0.03</izz></inertia></inertial>"
         "<collision name='hull'><pose>-0.05 0 0.13 0 0 0</pose><geometry><box><size>0.36 0.36 0.1</size>"
         "</box></geometry></collision></link>" +
         wheelLink("left", "base", "0 0.15 0.07", 0.07, motor) +
         wheelLink("right", "base", "0 -0.15 0.07", 0.07, motor) +
         "<link name='fork'><pose relative_to='base'>-0.15 0 0.06 0 0 0</pose><inertial><mass>0.1</mass>"
         "<inertia><ixx>2e-4</ixx><iyy>2e-4</iyy><izz>2e-4</izz></inertia></inertial></link>"
         "<joint name='swivel' type='continuous'><parent>base</parent><child>fork</child>"
         "<axis><xyz>0 0 1</xyz></axis></joint>" +
         wheelLink("caster", "fork", "-0.03 0 -0.03", 0.03, "") +
         "<robotcontrol:vehicle kind='differential'><robotcontrol:wheel>axle_left</robotcontrol:wheel>"
         "<robotcontrol:wheel>axle_right</robotcontrol:wheel>"
         "<robotcontrol:free_wheel>axle_caster</robotcontrol:free_wheel></robotcontrol:vehicle></model>";
}

std::string parcelAt(const std::string& name, double x, double y) {
  std::ostringstream text;
  text << "<model name='" << name << "'><pose>" << x << ' ' << y
       << " 0.1 0 0 0</pose><link name='box'><inertial><mass>0.4</mass><inertia><ixx>0.0027</ixx>"
          "<iyy>0.0027</iyy><izz>0.0027</izz></inertia></inertial><collision name='box'><geometry><box><size>"
          "0.2 0.2 0.2</size></box></geometry><surface><friction><ode><mu>0.4</mu></ode></friction></surface>"
          "</collision></link></model>";
  return text.str();
}

std::string replacedOnce(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::unique_ptr<Simulation> yardWith(const std::string& contents, std::uint64_t seed,
                                     SimulationOptions options) {
  const SceneFolder folder;
  folder.writeModel("torque_car", replacedOnce(replacedOnce(shippedModel("car"), "kind=\"ackermann\"",
                                                            "kind=\"ackermann\" control=\"torque\""),
                                               "<model name=\"car\">", "<model name=\"torque_car\">"));
  const auto scene = Scene::load(folder.write("world.sdf", worldAround(kMovingFloor + contents)));
  EXPECT_TRUE(scene) << describe(scene.error());
  if (!scene) return nullptr;
  options.seed = seed;
  auto simulation = Simulation::create(*scene, options);
  EXPECT_TRUE(simulation) << (simulation ? "" : simulation.error().describe());
  return simulation ? std::move(*simulation) : nullptr;
}

std::string errorsOfModel(const std::string& model, const std::string& from, const std::string& to) {
  const SceneFolder folder;
  folder.writeModel("wrong", replacedOnce(shippedModel(model), from, to));
  return folder.errorsOf(worldAround(kMovingFloor + including("wrong")));
}

void commandPort(Simulation& simulation, const std::string& port, const Motion& values) {
  const auto written = simulation.write(port, values);
  EXPECT_TRUE(written) << (written ? "" : written.error().describe());
}

void runFor(Simulation& simulation, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / 0.004)); ++i) simulation.step();
}

double portReading(const Simulation& simulation, const std::string& path) {
  const auto values = simulation.read(path);
  EXPECT_TRUE(values) << path;
  return values ? values->front() : 0;
}

robotlink::Pose2 groundPlace(const Simulation& simulation, const std::string& model) {
  const auto pose = simulation.modelPose(model);
  EXPECT_TRUE(pose) << model;
  return pose ? robotlink::groundPose(*pose) : robotlink::Pose2{};
}

}  // namespace simcore
