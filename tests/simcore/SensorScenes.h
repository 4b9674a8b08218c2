// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "simcore/Simulation.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {

/// A simulation of one model, "cart": a box of 0.4 x 0.3 x 0.1 m and 4 kg on the ground, with `inLink` in its
/// link and `inModel` beside it, and `inWorld` around it.
inline std::unique_ptr<Simulation> cartWith(const std::string& inLink, const std::string& inModel = "",
                                            const std::string& inWorld = "", SimulationOptions options = {}) {
  static int folders = 0;
  const SceneFolder folder;
  const std::string text = worldAround(R"(
    <model name="ground"><static>true</static><link name="l">
      <collision name="c"><geometry><plane><normal>0 0 1</normal><size>20 20</size></plane></geometry></collision>
      <visual name="v"><geometry><plane><normal>0 0 1</normal><size>20 20</size></plane></geometry></visual>
    </link></model>
    <model name="cart">
      <pose>0 0 0.05 0 0 0</pose>
      <link name="base">
        <inertial><mass>4</mass><inertia><ixx>0.03</ixx><iyy>0.06</iyy><izz>0.08</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>
        <collision name="box"><geometry><box><size>0.4 0.3 0.1</size></box></geometry>
          <surface><friction><ode><mu>0.1</mu></ode></friction></surface></collision>
        <visual name="box"><geometry><box><size>0.4 0.3 0.1</size></box></geometry></visual>
        )" + inLink + "</link>" + inModel +
                                       "</model>" + inWorld);
  auto scene = Scene::load(folder.write("world" + std::to_string(folders++) + ".sdf", text));
  if (!scene) {
    ADD_FAILURE() << describe(scene.error());
    return nullptr;
  }
  auto simulation = Simulation::create(*scene, options);
  if (!simulation) {
    ADD_FAILURE() << simulation.error().text;
    return nullptr;
  }
  return std::move(*simulation);
}

/// A static box in the world.
inline std::string solidAt(const std::string& name, const std::string& pose, const std::string& size,
                           const std::string& inVisual = "") {
  const std::string shape = "<geometry><box><size>" + size + "</size></box></geometry>";
  return "<model name='" + name + "'><static>true</static><pose>" + pose +
         "</pose><link name='l'><collision name='c'>" + shape + "</collision><visual name='v'>" + shape +
         inVisual + "</visual></link></model>";
}

}  // namespace simcore
