// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/DeployedTables.h"

#include <algorithm>
#include <map>

#include "app/core/program/ColorTables.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

namespace app {

namespace fs = std::filesystem;

DeployedTables::DeployedTables(robotlink::Session& session, ResourceFolder folder)
    : session_(session), folder_(std::move(folder)) {}

void DeployedTables::begin() {
  // If there are several formats, the newest file counts.
  std::map<fs::file_time_type, std::string> paths;
  std::error_code error;
  for (fs::directory_iterator file(folder_.path() / kColorTables, error);
       !error && file != fs::directory_iterator(); file.increment(error)) {
    std::error_code gone;
    const auto written = file->last_write_time(gone);
    if (!gone) paths[written] = std::string(kColorTables) + "/" + file->path().filename().string();
  }
  for (const auto& [time, path] : paths) written_.push(path);
}

robotlink::Errors DeployedTables::tick() {
  robotlink::Errors errors;
  for (const std::string& path : written_.drain())
    for (robotlink::Error& error : use(path)) errors.push_back(std::move(error));
  return errors;
}

robotlink::Errors DeployedTables::use(const std::string& path) {
  const fs::path split(path);
  const std::string robot = split.stem().string();
  const auto& robots = session_.robots();
  if (*split.begin() != kColorTables || std::ranges::find(robots, robot) == robots.end()) return {};
  const auto file = folder_.find(path);
  if (!file) return {file.error()};
  const auto table = readColorTable(*file);
  if (!table) return {table.error()};
  robotcontrol::Request request;
  request.set_robot(robot);
  *request.mutable_set_color_table()->mutable_table() = **table;
  session_.request(std::move(request));
  return {};
}

}  // namespace app
