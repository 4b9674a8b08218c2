// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramOverrides.h"

#include "robotlink/debugging/RequestKinds.h"

namespace app {

using robotcontrol::KeyMode;
using robotcontrol::Request;

bool ProgramOverrides::note(const Request& request) {
  if (!robotlink::kindOf(request).isOverride) return false;
  switch (request.what_case()) {
    case Request::kSetKey:
      noteKey(request.set_key());
      return true;
    case Request::kSelectSolution:
      chooseSolution(request.select_solution().task(), request.select_solution().solution());
      return true;
    case Request::kSetParameters:
      noteParameters(request.set_parameters());
      return true;
    case Request::kSetColorTable:
      // A table without cells removes the one that was sent.
      colorTable_ = request.set_color_table().table().cells().empty()
                        ? nullptr
                        : std::make_shared<const robotcontrol::ColorTable>(request.set_color_table().table());
      return true;
    case Request::kRecordPackages:
      recordedPackages_ = {request.record_packages().packages().begin(),
                           request.record_packages().packages().end()};
      return true;
    default:
      return false;
  }
}

void ProgramOverrides::noteKey(const robotcontrol::SetKey& key) {
  // Off is the default; and "n times" was over when the program ended.
  if (key.mode().kind() == KeyMode::OFF || key.mode().kind() == KeyMode::N_TIMES) {
    keys_.erase(key.name());
  } else {
    keys_[key.name()] = key.mode();
  }
}

void ProgramOverrides::noteParameters(const robotcontrol::SetParameters& details) {
  auto& values = parameters_[{details.task(), details.solution()}];
  values.set_task(details.task());
  values.set_solution(details.solution());
  *values.mutable_value() = details.value();
}

std::vector<Request> ProgramOverrides::requests(const std::string& robot) const {
  std::vector<Request> all;
  Request request;
  request.set_robot(robot);
  for (const auto& [name, mode] : keys_) {
    request.mutable_set_key()->set_name(name);
    *request.mutable_set_key()->mutable_mode() = mode;
    all.push_back(request);
  }
  const auto addParameters = [&](bool ofActive) {
    for (const auto& [solution, values] : parameters_) {
      if (solution.second.empty() != ofActive) continue;
      request.mutable_set_parameters()->set_task(solution.first);
      request.mutable_set_parameters()->set_solution(solution.second);
      *request.mutable_set_parameters()->mutable_value() = values.value();
      all.push_back(request);
    }
  };
  // Parameters of a named solution come before the choice of solutions, which may read them when they are
  // constructed. Parameters of the active solution come after it.
  addParameters(false);
  for (const auto& [task, solution] : solutions_) {
    request.mutable_select_solution()->set_task(task);
    request.mutable_select_solution()->set_solution(solution);
    all.push_back(request);
  }
  addParameters(true);
  if (colorTable_) {
    *request.mutable_set_color_table()->mutable_table() = *colorTable_;
    all.push_back(request);
  }
  request.mutable_send_tables();
  all.push_back(request);
  return all;
}

}  // namespace app
