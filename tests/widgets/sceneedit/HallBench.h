// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/widgets/Bench.h"
#include "tests/widgets/sceneedit/ToyLanguage.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEdits.h"

namespace widgets::test {

inline const std::string kHall =
    "<sdf>\n"
    "  <world name=\"hall\">\n"
    "    <!-- a desk -->\n"
    "    <model name=\"desk\"><pose>1 0 0 0 0 0</pose></model>\n"
    "    <include>\n"
    "      <uri>model://rover</uri>\n"
    "      <pose>0 1 0 0 0 0</pose>\n"
    "    </include>\n"
    "    <light name=\"lamp\"><pose>0 0 3 0 0 0</pose></light>\n"
    "  </world>\n"
    "</sdf>\n";

inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) qFatal("the text has no such part");
  return text.replace(at, from.size(), to);
}

/// A window in which a scene is simulated that can be changed.
struct HallBench : Bench {
  explicit HallBench(std::shared_ptr<const SceneLanguage> language = std::make_shared<ToyLanguage>())
      : file(folder.write("hall.sdf", kHall)) {
    context.sceneLanguage = std::move(language);
    robotcontrol::SimulationStatus status;
    status.set_scene(file.string());
    push("simulation", status, 2);
    session.tick();
    edits().setHost(
        [this](const SceneEdits::Texts& unsaved,
               const SceneEdits::Refused& refused) -> robotlink::Result<void> {
          if (!refusal.empty()) return robotlink::failure("test", refusal);
          texts.push_back(unsaved);
          refuse = refused;
          return {};
        },
        [this](const std::filesystem::path& path) { return path.parent_path() == file.parent_path(); });
  }
  SceneEdits& edits() { return sceneEdits(context); }
  /// Another scene is simulated.
  void simulate(const std::filesystem::path& scene) {
    robotcontrol::SimulationStatus status;
    status.set_scene(scene.string());
    push("simulation", status, ++seconds);
    session.tick();
    sceneBench(context).tick();
  }
  /// Begins a change and waits until it is made: the object, or the reason against it.
  std::string made(const std::function<void(SceneEdits::Told)>& begin) {
    std::string outcome = "nothing was told";
    begin(telling(outcome));
    edits().finish();
    return outcome;
  }
  static SceneEdits::Told telling(std::string& outcome) {
    return [&outcome](const robotlink::Result<std::string>& object) {
      outcome = object ? *object : object.error().text;
    };
  }
  using Pose = std::array<double, 6>;
  std::string setPose(const std::string& object, const Pose& pose) {
    return made([&](const SceneEdits::Told& told) { edits().setPose(object, pose, told); });
  }
  std::string insert(const std::string& kind, double x, double y) {
    return made([&](const SceneEdits::Told& told) { edits().insert(kind, x, y, told); });
  }
  std::string copy(const std::string& object, const Pose& pose) {
    return made([&](const SceneEdits::Told& told) { edits().copy(object, pose, told); });
  }
  std::string rename(const std::string& object, const std::string& name) {
    return made([&](const SceneEdits::Told& told) { edits().rename(object, name, told); });
  }
  std::string erase(const std::string& object) {
    return made([&](const SceneEdits::Told& told) { edits().erase(object, told); });
  }
  /// The text with which the simulation went on last.
  std::string running() const { return texts.empty() ? std::string() : texts.back().begin()->second; }
  std::string saved() const { return robotlink::readFile(file).value_or(""); }

  const TestFolder folder;
  const std::filesystem::path file;
  int seconds = 2;
  std::vector<SceneEdits::Texts> texts;
  /// Refuses the last change; empty: it is made whatever is in its way.
  SceneEdits::Refused refuse;
  /// Why nothing can be simulated now.
  std::string refusal;
};

}  // namespace widgets::test
