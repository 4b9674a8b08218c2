// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEditorCommands.h"

#include <filesystem>
#include <functional>
#include <memory>

#include "robotcontrol/World.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEdits.h"
#include "widgets/sceneedit/SceneFileObjects.h"
#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/world/ObjectPose.h"
#include "widgets/world/SceneSelection.h"
#include "widgets/world/SceneState.h"

namespace widgets {
namespace {

using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;

const std::string& sceneWord(const CommandTable::Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}

/// Shows the editor, with the object of a path, a file, or what is selected.
Result<void> editScene(SceneBench& bench, const std::string& what) {
  const auto shown = bench.context().commands.run("view.show", {std::string("scene-editor")});
  if (!shown) return shown;
  std::error_code unknown;
  if (!what.empty() && std::filesystem::is_regular_file(what, unknown))
    return bench.open(what).map([](SceneFile*) {});
  return bench.goTo(QString::fromStdString(what.empty() ? sceneSelection(bench.context()).object() : what));
}

using Object = std::function<Result<void>(SceneBench&, const std::string& object)>;

/// Runs something with an object, the selected one if none is named.
Object withObject(Object run) {
  return [run = std::move(run)](SceneBench& bench, const std::string& named) -> Result<void> {
    const std::string& object = named.empty() ? sceneSelection(bench.context()).object() : named;
    if (object.empty()) return failure("scene.object", "nothing is selected in the scene; name an object");
    return run(bench, object);
  };
}

/// The current pose of an object.
Result<ObjectPose> poseNow(SceneBench& bench, const std::string& path) {
  auto& session = bench.context().session;
  SceneState state;
  state.update(session.store(), session.timeline().newest());
  const auto* object = worldObject(session, path);
  const auto pose = object == nullptr ? std::nullopt : worldPose(*object, state);
  if (!pose)
    return failure("scene.object", "there is no object " + path + " with a place in the scene", {}, {path});
  return objectPose(*pose);
}

/// Has a change made before the next command, which may depend on it; returns its outcome.
Result<void> finished(SceneBench& bench,
                      const std::function<void(SceneEdits& edits, SceneEdits::Told told)>& begin) {
  SceneEdits& edits = sceneEdits(bench.context());
  Result<void> done;
  begin(edits, [&done](const Result<std::string>& object) {
    done = object ? Result<void>() : tl::unexpected(object.error());
  });
  edits.finish();
  return done;
}

Result<void> copyBeside(SceneBench& bench, const std::string& object) {
  constexpr double kBeside = 0.5;  // m
  auto pose = poseNow(bench, object);
  if (!pose) return tl::unexpected(pose.error());
  (*pose)[0] += kBeside;
  (*pose)[1] += kBeside;
  return finished(bench, [&](SceneEdits& edits, auto told) { edits.copy(object, *pose, told); });
}

Result<void> writePose(SceneBench& bench, const std::string& object) {
  const auto pose = poseNow(bench, object);
  if (!pose) return tl::unexpected(pose.error());
  return finished(bench, [&](SceneEdits& edits, auto told) { edits.setPose(object, *pose, told); });
}

/// The objects of the files that are open.
std::vector<std::string> knownObjects(SceneBench& bench) {
  std::vector<std::string> names;
  for (const SceneFile* file : bench.files()) {
    for (const SceneObject& object : sceneObjects(file->text())) names.push_back(object.path.toStdString());
  }
  return names;
}

/// The models and lamps of the simulated scene.
std::vector<std::string> worldModels(SceneBench& bench) {
  std::vector<std::string> names;
  auto& session = bench.context().session;
  const auto* all = session.store().latestAs<robotcontrol::WorldObjects>(robotlink::streams::kObjects,
                                                                         session.timeline().newest());
  if (all == nullptr) return names;
  for (const auto& object : all->objects()) {
    if (object.parent().empty()) names.push_back(object.path());
  }
  return names;
}

using BenchCommand = std::function<Result<void>(SceneBench&, const CommandTable::Values&)>;

/// A command with one text, which may be left out.
BenchCommand withText(Object run) {
  return [run = std::move(run)](SceneBench& bench, const CommandTable::Values& values) {
    return run(bench, values.empty() ? std::string() : sceneWord(values, 0));
  };
}

/// Attaches a command that fails once the window with the scene editor is closed.
void attachToBench(ViewContext& context, const char* name, BenchCommand run, CommandTable::Offer offer = {}) {
  context.commands.attach(
      name,
      [shared = std::weak_ptr<SceneBench>(context.scenes),
       run = std::move(run)](const CommandTable::Values& values) -> Result<void> {
        if (const auto bench = shared.lock()) return run(*bench, values);
        return failure("scene.closed", "the window with the scene editor is closed");
      },
      std::move(offer));
}

/// Offers names for the first argument of a command.
CommandTable::Offer offered(const ViewContext& context, std::vector<std::string> (*names)(SceneBench&)) {
  return [shared = std::weak_ptr<SceneBench>(context.scenes), names](const auto& before) {
    const auto bench = shared.lock();
    return bench && before.empty() ? names(*bench) : std::vector<std::string>();
  };
}

/// The commands about the editor and its files.
void attachEditorCommands(ViewContext& context) {
  attachToBench(context, "scene.edit", withText(editScene), offered(context, knownObjects));
  attachToBench(context, "scene.save", withText([](SceneBench& bench, const std::string& file) {
                  return file.empty() ? bench.save() : bench.saveAs(file);
                }));
  attachToBench(context, "scene.apply",
                [](SceneBench& bench, const auto&) { return sceneEdits(bench.context()).apply(); });
  attachToBench(context, "scene.undo-edit",
                [](SceneBench& bench, const auto&) { return sceneEdits(bench.context()).undo(); });
  attachToBench(context, "scene.redo-edit",
                [](SceneBench& bench, const auto&) { return sceneEdits(bench.context()).redo(); });
}

/// The commands that change objects of the simulated scene.
void attachObjectCommands(ViewContext& context) {
  using Values = CommandTable::Values;
  const auto objects = offered(context, worldModels);
  attachToBench(context, "scene.copy", withText(withObject(copyBeside)), objects);
  attachToBench(context, "scene.write", withText(withObject(writePose)), objects);
  const Object erase = withObject([](SceneBench& bench, const std::string& object) {
    return finished(bench, [&](SceneEdits& edits, auto told) { edits.erase(object, told); });
  });
  attachToBench(context, "scene.erase", withText(erase), objects);
  const BenchCommand rename = [](SceneBench& bench, const Values& values) {
    return finished(bench, [&](SceneEdits& edits, auto told) {
      edits.rename(sceneWord(values, 0), sceneWord(values, 1), told);
    });
  };
  attachToBench(context, "scene.rename", rename, objects);
  const BenchCommand insert = [](SceneBench& bench, const Values& values) {
    return finished(bench, [&](SceneEdits& edits, auto told) {
      edits.insert(sceneWord(values, 0), std::get<double>(values[1]), std::get<double>(values[2]), told);
    });
  };
  attachToBench(context, "scene.insert", insert, [](const auto& before) {
    return before.empty() ? std::vector<std::string>(kSceneObjectKinds.begin(), kSceneObjectKinds.end())
                          : std::vector<std::string>();
  });
}

}  // namespace

void attachSceneEditorCommands(ViewContext& context) {
  if (context.commands.isAttached("scene.edit")) return;
  sceneBench(context);
  attachEditorCommands(context);
  attachObjectCommands(context);
}

}  // namespace widgets
