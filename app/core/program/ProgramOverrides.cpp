// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramOverrides.h"

#include <algorithm>

#include "robotlink/debugging/RequestKinds.h"

namespace app {

using robotcontrol::Request;

ProgramOverrides::Subject ProgramOverrides::subjectOf(const Request& request) {
  const robotlink::RequestKind& kind = robotlink::kindOf(request);
  return {static_cast<std::size_t>(&kind - robotlink::requestKinds().data()), kind.subject(request)};
}

bool ProgramOverrides::note(const Request& request) {
  const robotlink::RequestKind& kind = robotlink::kindOf(request);
  if (!kind.isOverride) return false;
  if (kind.removes != nullptr && kind.removes(request)) {
    requests_.erase(subjectOf(request));
  } else {
    requests_[subjectOf(request)] = std::make_shared<const Request>(request);
  }
  return true;
}

void ProgramOverrides::chooseSolution(const std::string& task, const std::string& solution) {
  Request request;
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  note(request);
}

void ProgramOverrides::chooseColorTable(const std::shared_ptr<const robotcontrol::ColorTable>& table) {
  Request request;
  request.mutable_set_color_table();
  if (table) *request.mutable_set_color_table()->mutable_table() = *table;
  note(request);
}

bool ProgramOverrides::contains(const Request& request) const {
  return robotlink::kindOf(request).isOverride && requests_.contains(subjectOf(request));
}

std::vector<Request> ProgramOverrides::requests(const std::string& robot) const {
  std::vector<Request> all, last;
  for (const auto& [subject, request] : requests_) {
    // Parameters of the active solution come after the choice of that solution.
    const bool ofActive = request->has_set_parameters() && request->set_parameters().solution().empty();
    (ofActive ? last : all).push_back(*request);
  }
  last.emplace_back().mutable_send_tables();
  all.insert(all.end(), last.begin(), last.end());
  for (Request& request : all) {
    request.clear_id();
    request.set_robot(robot);
  }
  return all;
}

// ---- Of each kind

std::map<std::string, robotcontrol::KeyMode> ProgramOverrides::keys() const {
  std::map<std::string, robotcontrol::KeyMode> modes;
  for (const auto& [subject, request] : requests_) {
    if (request->has_set_key()) modes[request->set_key().name()] = request->set_key().mode();
  }
  return modes;
}

std::map<std::string, std::string> ProgramOverrides::solutions() const {
  std::map<std::string, std::string> solutions;
  for (const auto& [subject, request] : requests_) {
    if (request->has_select_solution())
      solutions[request->select_solution().task()] = request->select_solution().solution();
  }
  return solutions;
}

std::vector<robotcontrol::ParameterValues> ProgramOverrides::parameters() const {
  std::vector<robotcontrol::ParameterValues> all;
  for (const auto& [subject, request] : requests_) {
    if (!request->has_set_parameters()) continue;
    auto& values = all.emplace_back();
    values.set_task(request->set_parameters().task());
    values.set_solution(request->set_parameters().solution());
    *values.mutable_value() = request->set_parameters().value();
  }
  std::stable_partition(all.begin(), all.end(),
                        [](const auto& values) { return !values.solution().empty(); });
  return all;
}

std::shared_ptr<const robotcontrol::ColorTable> ProgramOverrides::colorTable() const {
  for (const auto& [subject, request] : requests_) {
    // Shares the request, which contains the table.
    if (request->has_set_color_table()) return {request, &request->set_color_table().table()};
  }
  return nullptr;
}

std::shared_ptr<const robotcontrol::MotionTexts> ProgramOverrides::motions() const {
  auto texts = std::make_shared<robotcontrol::MotionTexts>();
  for (const auto& [subject, request] : requests_) {
    if (request->has_set_motion()) *texts->add_motions() = request->set_motion().motion();
  }
  return texts->motions().empty() ? nullptr : texts;
}

std::vector<std::string> ProgramOverrides::recordedPackages() const {
  for (const auto& [subject, request] : requests_) {
    if (!request->has_record_packages()) continue;
    const auto& packages = request->record_packages().packages();
    return {packages.begin(), packages.end()};
  }
  return {};
}

}  // namespace app
