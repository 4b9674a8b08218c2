// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ProgramWishes.h"

namespace app {

using robotcontrol::KeyMode;
using robotcontrol::Request;

void ProgramWishes::note(const Request& request) {
  if (request.has_set_key()) {
    const auto& key = request.set_key();
    // What was to happen n times has happened.
    if (key.mode().kind() == KeyMode::OFF || key.mode().kind() == KeyMode::N_TIMES) {
      keys_.erase(key.name());
    } else {
      keys_[key.name()] = key.mode();
    }
  }
  if (request.has_select_solution()) solutions_[request.select_solution().task()] = request.select_solution().solution();
}

std::vector<Request> ProgramWishes::requests(const std::string& robot) const {
  std::vector<Request> all;
  Request request;
  request.set_robot(robot);
  for (const auto& [name, mode] : keys_) {
    request.mutable_set_key()->set_name(name);
    *request.mutable_set_key()->mutable_mode() = mode;
    all.push_back(request);
  }
  for (const auto& [task, solution] : solutions_) {
    request.mutable_select_solution()->set_task(task);
    request.mutable_select_solution()->set_solution(solution);
    all.push_back(request);
  }
  request.mutable_send_tables();
  all.push_back(request);
  return all;
}

}  // namespace app
