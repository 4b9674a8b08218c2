// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotcontrol/Requests.pb.h"

namespace app::test {

/// A request to switch a robot's debug key on.
inline robotcontrol::Request keyRequest(const std::string& robot, const std::string& key) {
  robotcontrol::Request request;
  request.set_robot(robot);
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  return request;
}

inline robotcontrol::Request selectRequest(const std::string& robot, const std::string& task,
                                           const std::string& solution) {
  robotcontrol::Request request;
  request.set_robot(robot);
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  return request;
}

/// A request for red1 to use a color table in which everything is orange.
inline robotcontrol::Request tableRequest() {
  robotcontrol::Request request;
  request.set_robot("red1");
  auto& table = *request.mutable_set_color_table()->mutable_table();
  table.set_cells(std::string(std::size_t{64} * 64 * 64, '\1'));
  table.add_class_names("orange");
  table.set_source("/home/me/orange.c64");
  return request;
}

}  // namespace app::test
