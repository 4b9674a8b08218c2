// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "foxglove/Ranging.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"

// Messages of tests of the Data view.
namespace widgets::test {

inline foxglove::JointStates joints(double pan) {
  foxglove::JointStates states;
  states.mutable_timestamp()->set_seconds(12);
  for (const char* name : {"head.tilt", "head.pan", "mouth"}) states.add_joints()->set_name(name);
  states.mutable_joints(1)->set_position(pan);
  return states;
}

inline foxglove::LaserScan laserScan(int readings) {
  foxglove::LaserScan scan;
  for (int i = 0; i < readings; ++i) scan.add_ranges(i);
  return scan;
}

inline robotcontrol::KeyTable keyTable(bool isOn) {
  robotcontrol::KeyTable table;
  auto& key = *table.add_keys();
  key.set_name("package/models/ball");
  key.set_stream("models/ball");
  key.set_in_use(true);
  key.mutable_mode()->set_kind(isOn ? robotcontrol::KeyMode::ALWAYS : robotcontrol::KeyMode::OFF);
  return table;
}

}  // namespace widgets::test
