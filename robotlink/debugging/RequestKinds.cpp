// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/RequestKinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/DebugKey.h"
#include "robotlink/debugging/DebugRoutes.h"

namespace robotlink {

using robotcontrol::Request;

namespace {

// ---- What can be wrong with a request itself

std::string wrongKey(const Request& request) {
  using robotcontrol::KeyMode;
  const robotcontrol::SetKey& key = request.set_key();
  const KeyMode& mode = key.mode();
  if (!KeyMode::Kind_IsValid(mode.kind())) return "there is no such mode of a debug key";
  const bool needsNumber = mode.kind() == KeyMode::EVERY_N || mode.kind() == KeyMode::EVERY_MS;
  if (needsNumber && mode.n() == 0) return "this mode of a debug key needs a number above 0";
  if (!packageOfKey(key.name()).empty() || DebugKey::find(key.name()) >= 0) return "";
  std::vector<std::string> all;
  for (const DebugKey::Entry& entry : DebugKey::all()) all.push_back(entry.name);
  const std::string near = nearest(key.name(), all);
  return "there is no debug key '" + key.name() + "'" +
         (near.empty() ? "" : "; did you mean '" + near + "'?");
}

bool isFinite(const robotcontrol::Pose2& pose) {
  return std::isfinite(pose.x()) && std::isfinite(pose.y()) && std::isfinite(pose.heading());
}

bool isFinite(const robotcontrol::ColorCorrection& c) {
  const auto lines = {c.y().gain(),    c.y().offset(), c.cb().gain(),
                      c.cb().offset(), c.cr().gain(),  c.cr().offset()};
  const auto curves = {c.luma_r2(), c.luma_r4(), c.blue_r2(), c.blue_r4(), c.red_r2(), c.red_r4()};
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::ranges::all_of(lines, finite) && std::ranges::all_of(curves, finite);
}

/// A table without cells takes back the one that was set.
std::string wrongColorTable(const Request& request) {
  return wrongWith(request.set_color_table().table());
}

std::string wrongGoal(const Request& request) {
  return isFinite(request.set_goal().pose_in_field()) ? ""
                                                      : "the goal's pose has values that are not numbers";
}

std::string wrongPlace(const Request& request) {
  return isFinite(request.place_model().pose_in_field()) ? ""
                                                         : "the place's pose has values that are not numbers";
}

std::string wrongSpeed(const Request& request) {
  return std::isnan(request.control_simulation().speed()) ? "the speed is not a number" : "";
}

// ---- What a request sets

std::string keyOf(const Request& request) {
  return request.set_key().name();
}
std::string taskOf(const Request& request) {
  return request.select_solution().task();
}
std::string parametersOf(const Request& request) {
  return request.set_parameters().task() + '\n' + request.set_parameters().solution();
}
std::string theOnlyOne(const Request&) {
  return {};
}

// ---- What the user chose by it

std::string solutionChosen(const Request& request) {
  return "solution " + request.select_solution().solution() + " of task " + request.select_solution().task();
}
std::string parametersChosen(const Request& request) {
  const auto& chosen = request.set_parameters();
  return "the parameters of " + chosen.task() +
         (chosen.solution().empty() ? "" : ", solution " + chosen.solution());
}
std::string tableChosen(const Request&) {
  return "the color table that was sent";
}

constexpr RequestKind kNothing{Request::WHAT_NOT_SET, RequestDoer::kNobody, "nothing"};

constexpr std::array<RequestKind, 16> kKinds{{
    {Request::kSetKey, RequestDoer::kDebugProcess, "set key", true, keyOf, wrongKey},
    {Request::kSelectSolution, RequestDoer::kTask, "select solution", true, taskOf, nullptr, solutionChosen},
    {Request::kGetParameters, RequestDoer::kTask, "get parameters"},
    {Request::kSetParameters, RequestDoer::kTask, "set parameters", true, parametersOf, nullptr,
     parametersChosen},
    {Request::kSendTables, RequestDoer::kDebugProcess, "send tables"},
    {Request::kStop, RequestDoer::kPlatform, "stop", false, theOnlyOne},
    {Request::kMotion, RequestDoer::kDebugProcess, "motion"},
    {Request::kControlSimulation, RequestDoer::kSimulation, "control simulation", false, nullptr, wrongSpeed},
    {Request::kPlaceModel, RequestDoer::kSimulation, "place model", false, nullptr, wrongPlace},
    {Request::kRecordPackages, RequestDoer::kDebugProcess, "record packages", true},
    {Request::kSetColorTable, RequestDoer::kDebugProcess, "set color table", true, theOnlyOne,
     wrongColorTable, tableChosen},
    {Request::kControlRecording, RequestDoer::kRecording, "control recording"},
    {Request::kControlReplay, RequestDoer::kReplay, "control replay"},
    {Request::kSetLighting, RequestDoer::kSimulation, "set lighting", false, theOnlyOne},
    {Request::kSetGoal, RequestDoer::kDebugProcess, "set goal", false, nullptr, wrongGoal},
    {Request::kControlDrive, RequestDoer::kPlatform, "control drive"},
}};

}  // namespace

std::span<const RequestKind> requestKinds() {
  return kKinds;
}

const RequestKind& kindOf(const Request& request) {
  const auto found = std::ranges::find(kKinds, request.what_case(), &RequestKind::what);
  return found == kKinds.end() ? kNothing : *found;
}

std::string inWords(const Request& request) {
  const std::string words = kindOf(request).words;
  return request.robot().empty() ? words : words + " of " + request.robot();
}

std::string wrongWith(const Request& request) {
  const RequestKind& kind = kindOf(request);
  return kind.wrong != nullptr ? kind.wrong(request) : std::string();
}

std::string wrongWith(const robotcontrol::ColorTable& table) {
  constexpr std::size_t kCells = std::size_t{64} * 64 * 64;
  if (table.cells().empty()) return "";
  if (table.cells().size() != kCells)
    return "a color table has " + std::to_string(kCells) + " cells, this one has " +
           std::to_string(table.cells().size());
  const auto known = [&](char cell) { return static_cast<unsigned char>(cell) <= table.class_names_size(); };
  if (!std::ranges::all_of(table.cells(), known))
    return "cells of the color table have classes without a name";
  return isFinite(table.correction()) ? "" : "the color table's correction has values that are not numbers";
}

bool setTheSame(const Request& a, const Request& b) {
  const RequestKind& kind = kindOf(a);
  return a.what_case() == b.what_case() && kind.subject != nullptr && kind.subject(a) == kind.subject(b);
}

}  // namespace robotlink
