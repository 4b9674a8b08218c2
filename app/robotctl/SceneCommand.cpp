// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl scene check`: what a scene contains, what is left out of it, and whether it rests.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/NumberRange.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/simulated/SceneResources.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "robotlink/base/Printable.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/control/Controllers.h"

namespace app {
namespace {

using nlohmann::json;
using simcore::LeftOut;

struct SceneArguments {
  std::string file;
  std::vector<std::filesystem::path> models;
  double seconds = 60;
  bool asJson = false;
};

/// The largest motions of a model's links, which joints may let swing or fall while the model itself rests.
struct LinkMotion {
  std::string link;
  double moved = 0, turned = 0;
};

/// A model before and after its rest.
struct ModelReport {
  std::string name, file;
  bool isStatic = false;
  simcore::Pose3 start, end;
  LinkMotion links;
  std::vector<std::string> touches;

  double moved() const { return (end.translation() - start.translation()).norm(); }
  /// Whether a link moved noticeably more than the model.
  bool linksMoved() const { return links.moved > moved() + 1e-3 || links.turned > turned() + 1e-2; }
  double turned() const { return Eigen::AngleAxisd(start.linear().transpose() * end.linear()).angle(); }
};

struct SceneReport {
  std::vector<ModelReport> models;
  simcore::LeftOuts leftOut;
  double seconds = 0;
};

/// Watches the links of all models, whose bodies are called MODEL/LINK.
class LinkWatch {
 public:
  explicit LinkWatch(const simcore::Simulation& simulation)
      : simulation_(simulation),
        start_(simulation.bodyPoses().begin(), simulation.bodyPoses().end()),
        moved_(start_.size()),
        turned_(start_.size()) {}

  void look() {
    const auto poses = simulation_.bodyPoses();
    for (std::size_t i = 0; i < start_.size(); ++i) {
      keepLarger(moved_[i], (poses[i].translation() - start_[i].translation()).norm());
      keepLarger(turned_[i], Eigen::AngleAxisd(start_[i].linear().transpose() * poses[i].linear()).angle());
    }
  }

  /// The link of a model that has moved most, to the millimeter; of several the one that has turned most.
  LinkMotion mostOf(const std::string& model) const {
    LinkMotion most;
    const auto& names = simulation_.renderScene()->bodies;
    for (std::size_t i = 0; i < start_.size(); ++i) {
      if (!names[i].starts_with(model + "/")) continue;
      const double farther = moved_[i] - most.moved;
      if (!(std::abs(farther) < 1e-3 ? turned_[i] < most.turned : farther < 0))
        most = {names[i].substr(model.size() + 1), moved_[i], turned_[i]};
    }
    return most;
  }

 private:
  /// NaN counts as larger: what has exploded must not look as if it had rested.
  static void keepLarger(double& kept, double now) {
    if (!(now <= kept)) kept = now;
  }
  const simcore::Simulation& simulation_;
  std::vector<simcore::Pose3> start_;
  std::vector<double> moved_, turned_;
};

SceneReport reportOf(const simcore::Scene& scene, simcore::Simulation& simulation, double seconds) {
  SceneReport report;
  report.leftOut = scene.leftOut();
  report.leftOut.insert(report.leftOut.end(), simulation.overlaps().begin(), simulation.overlaps().end());
  for (const simcore::SceneModel& model : scene.models()) {
    ModelReport& added = report.models.emplace_back();
    added.name = model.name;
    added.file = model.file;
    added.isStatic = model.isStatic;
    added.start = simulation.modelPose(model.name).value_or(simcore::Pose3::Identity());
  }
  const double step = std::chrono::duration<double>(simcore::Simulation::kStep).count();
  const auto steps = static_cast<std::uint64_t>(std::llround(seconds / step));
  // Ten times a second, and at the end.
  constexpr std::uint64_t kLookEverySteps = 25;
  LinkWatch links(simulation);
  while (simulation.steps() < steps && Interrupt::signal() == 0) {
    simulation.step();
    if (simulation.steps() % kLookEverySteps == 0 || simulation.steps() == steps) links.look();
  }
  report.seconds = static_cast<double>(simulation.steps()) * step;
  for (const simcore::ControllerStatus& each : simulation.controllers()) {
    if (!each.isOn())
      leaveOut(report.leftOut,
               {{scene.file().string(), 1, 0}, each.path, "controller " + each.kind, each.trouble});
  }
  for (ModelReport& model : report.models) {
    model.end = simulation.modelPose(model.name).value_or(model.start);
    model.links = links.mostOf(model.name);
    if (!model.isStatic) model.touches = simulation.modelsTouching(model.name);
  }
  return report;
}

json poseJson(const simcore::Pose3& pose) {
  const Eigen::Quaterniond q(pose.linear());
  const auto& p = pose.translation();
  return {{"position", {p.x(), p.y(), p.z()}}, {"orientation", {q.w(), q.x(), q.y(), q.z()}}};
}

json leftOutJson(const LeftOut& one) {
  return {{"file", one.where.file},
          {"line", one.where.line},
          {"object", one.object},
          {"what", one.what},
          {"why", one.why}};
}

json errorJson(const robotlink::Error& error) {
  return {{"id", error.id}, {"file", error.where.file}, {"line", error.where.line}, {"text", error.text}};
}

json reportJson(const SceneReport& report) {
  json models = json::array(), leftOut = json::array();
  for (const ModelReport& model : report.models) {
    json one = {{"name", model.name},
                {"file", model.file},
                {"static", model.isStatic},
                {"start", poseJson(model.start)}};
    if (!model.isStatic) {
      one["end"] = poseJson(model.end);
      one["moved"] = model.moved();
      one["turned"] = model.turned();
      one["most_moved_link"] = {
          {"name", model.links.link}, {"moved", model.links.moved}, {"turned", model.links.turned}};
      one["touches"] = model.touches;
    }
    models.push_back(std::move(one));
  }
  for (const LeftOut& one : report.leftOut) leftOut.push_back(leftOutJson(one));
  return {{"opens", true}, {"seconds", report.seconds}, {"models", models}, {"left_out", leftOut}};
}

/// Prints what is left out of the scene, each kind once with its first place.
void printLeftOut(const simcore::LeftOuts& all) {
  std::map<std::pair<std::string, std::string>, std::pair<const LeftOut*, int>> kinds;
  std::vector<std::pair<std::string, std::string>> order;
  for (const LeftOut& one : all) {
    const auto key = std::pair(one.what, one.why);
    auto& [first, count] = kinds[key];
    if (count++ == 0) {
      first = &one;
      order.push_back(key);
    }
  }
  for (const auto& key : order) {
    const auto& [first, count] = kinds[key];
    const std::string more = count > 1 ? fmt::format(" ({} times)", count) : "";
    const std::string object = first->object.empty() ? "" : first->object + ": ";
    std::cout << robotlink::printable(fmt::format("left out: {}:{}: {}{}{}: {}", first->where.file,
                                                  first->where.line, object, first->what, more, first->why))
              << "\n";
  }
}

void printReport(const SceneArguments& arguments, const SceneReport& report) {
  for (const ModelReport& model : report.models) {
    std::string line = "model " + model.name + ": ";
    if (model.isStatic) {
      line += "static";
    } else {
      line += fmt::format("moved {:.3f} m and turned {:.3f} rad; ", model.moved(), model.turned());
      if (model.linksMoved()) {
        line += fmt::format("its link {} moved up to {:.3f} m and turned up to {:.3f} rad; ",
                            model.links.link, model.links.moved, model.links.turned);
      }
      line += "touches";
      for (const std::string& other : model.touches) line += " " + other;
      if (model.touches.empty()) line += " nothing";
    }
    std::cout << robotlink::printable(line) << "\n";
  }
  printLeftOut(report.leftOut);
  std::cout << robotlink::printable(arguments.file)
            << fmt::format(": opened; {} models, simulated for {:.1f} s, {} parts left out\n",
                           report.models.size(), report.seconds, report.leftOut.size());
}

int printFailure(const SceneArguments& arguments, const robotlink::Errors& errors) {
  if (arguments.asJson) {
    json list = json::array();
    for (const auto& error : errors) list.push_back(errorJson(error));
    std::cout << json{{"opens", false}, {"errors", list}}.dump(2, ' ', false, json::error_handler_t::replace)
              << "\n";
  }
  return printErrors(errors);
}

int check(const SceneArguments& arguments) {
  const auto scene = simcore::Scene::load(sceneNamed(arguments.file), {}, {}, arguments.models);
  if (!scene) return printFailure(arguments, scene.error());
  if (const auto missing = missingResources(**scene); !missing.empty())
    return printFailure(arguments, missing);
  const auto simulation = simcore::Simulation::create(*scene, {});
  if (!simulation) return printFailure(arguments, {simulation.error()});
  const SceneReport report = reportOf(**scene, **simulation, arguments.seconds);
  if (Interrupt::signal() != 0) return kFailed;
  if (arguments.asJson) {
    std::cout << reportJson(report).dump(2, ' ', false, json::error_handler_t::replace) << "\n";
  } else {
    printReport(arguments, report);
  }
  return kDone;
}

}  // namespace

void addSceneCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<SceneArguments>();
  CLI::App* scene = app.add_subcommand("scene", "Checks scenes");
  scene->require_subcommand(1);
  CLI::App* sub = scene->add_subcommand("check",
                                        "Opens a scene or a single model, lets it settle, and reports where "
                                        "its models end up and what was left out");
  sub->add_option("file", arguments->file, "An SDFormat or URDF file, a map, or the name of a shipped scene")
      ->required();
  sub->add_flag("--json", arguments->asJson, "Prints one JSON object");
  sub->add_option("--seconds", arguments->seconds, "Simulated time to settle; 0: only open it")
      ->check(numberFrom(0, 86400))
      ->capture_default_str();
  sub->add_option("--models", arguments->models, "Folders in which model://NAME is searched first");
  sub->callback([arguments, &status] { status = withResources([&] { return check(*arguments); }); });
}

}  // namespace app
