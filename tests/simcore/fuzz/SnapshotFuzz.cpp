// SPDX-License-Identifier: GPL-3.0-or-later
// States of a simulation, and files with them: what is accepted can be stepped, and what is refused has
// changed nothing.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "robotlink/base/bytes/LittleEndian.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/Snapshot.h"
#include "tests/fuzz/FuzzTarget.h"

namespace snapshot_fuzz {

using namespace simcore;

namespace {

constexpr const char* kWorld =
    R"(<sdf version="1.9" xmlns:robotcontrol="urn:robotcontrol:sdf"><world name="w">
<model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal>
  <size>20 20</size></plane></geometry></collision></link></model>
<model name="cart"><pose>0 0 0.05 0 0 0</pose><link name="base"><inertial><mass>4</mass><inertia><ixx>0.03</ixx>
  <iyy>0.06</iyy><izz>0.08</izz></inertia></inertial><collision name="box"><geometry><box><size>0.4 0.3 0.1</size></box>
  </geometry></collision><sensor name="imu" type="imu"><imu><angular_velocity><x><noise type="gaussian"><mean>0</mean>
  <stddev>0.02</stddev><dynamic_bias_stddev>0.02</dynamic_bias_stddev><dynamic_bias_correlation_time>2
  </dynamic_bias_correlation_time></noise></x></angular_velocity></imu></sensor>
  <sensor name="eye" type="lidar"><pose>0 0 0.3 0 0 0</pose><lidar><scan><horizontal><samples>5</samples>
  <min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>0.05</min><max>5</max></range>
  </lidar></sensor></link>
  <link name="arm"><pose>0 0 0.4 0 0 0</pose><inertial><mass>0.3</mass><inertia><ixx>0.002</ixx><iyy>0.002</iyy>
  <izz>0.002</izz></inertia></inertial></link>
  <joint name="turn" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 1 0</xyz><limit><lower>-1</lower>
  <upper>1</upper><effort>4</effort><velocity>3</velocity></limit></axis><robotcontrol:servo><robotcontrol:delay>0.05
  </robotcontrol:delay></robotcontrol:servo></joint></model>
<model name="box"><pose>0 1 0.3 0 0 0</pose><link name="l"><inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy>
  <izz>0.01</izz></inertia></inertial><collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry>
  </collision></link></model></world></sdf>)";

std::unique_ptr<Simulation> made() {
  const auto file =
      std::filesystem::temp_directory_path() / ("snapshot-fuzz-" + std::to_string(::getpid()) + ".sdf");
  std::ofstream(file) << kWorld;
  const auto scene = Scene::load(file);
  std::filesystem::remove(file);
  if (!scene) std::fprintf(stderr, "%s\n", robotlink::describe(scene.error()).c_str());
  require(scene.has_value(), "the world can be read");
  auto simulation = Simulation::create(*scene, {.seed = 3});
  require(simulation.has_value(), "the world can be simulated");
  (void)(*simulation)
      ->setSensorErrors("cart/eye", {{{.stddev = 0.01, .driftStddev = 0.02, .driftTime = 1}}, 0.06, 20, 0.2});
  return std::move(*simulation);
}

void play(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    if (!simulation.servos().empty()) simulation.requestAngle(0, 0.5);
    simulation.step();
    for (const Port& port : simulation.ports()) (void)simulation.read(port.info.path);
  }
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  static const std::unique_ptr<Simulation> simulation = made();
  static const Snapshot start = simulation->snapshot();
  (void)Snapshot::decode({data, size}, "fuzz.snapshot");
  Snapshot snapshot = start;
  snapshot.isForeign = true;
  snapshot.state.assign(data, data + size);
  // The step is the third number of the state.
  if (size >= 17) snapshot.step = robotlink::loadNumber<std::uint64_t>(data + 9);
  const std::uint64_t before = simulation->digest();
  if (!simulation->restore(snapshot)) {
    require(simulation->digest() == before, "what is refused changes nothing");
    return 0;
  }
  play(*simulation, 3);
  require(simulation->restore(start).has_value(), "one can go back from everything that was accepted");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  const auto simulation = made();
  std::vector<std::string> seeds;
  const auto add = [&](const std::vector<std::uint8_t>& bytes) {
    seeds.emplace_back(bytes.begin(), bytes.end());
  };
  add(simulation->snapshot().state);
  play(*simulation, 40);
  (void)simulation->pin("box", true);
  (void)simulation->drag("cart/link:arm", {0, 0, 0}, {0.1, 0.1, 0.6});
  (void)simulation->push("cart", {1, 0, 0}, {0, 0, 0}, 1);
  play(*simulation, 2);
  add(simulation->snapshot().state);
  add(simulation->snapshot().encode());
  return seeds;
}

const FuzzRegistration kTarget({"snapshot", &fuzzSeeds, &runInput});

}  // namespace snapshot_fuzz
