// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEditorCommands.h"

#include <filesystem>
#include <functional>
#include <memory>

#include "robotlink/commands/CommandTable.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneObjects.h"
#include "widgets/world/SceneSelection.h"

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

/// The objects of the files that are open.
std::vector<std::string> knownObjects(SceneBench& bench) {
  std::vector<std::string> names;
  for (const SceneFile* file : bench.files()) {
    for (const SceneObject& object : sceneObjects(file->text())) names.push_back(object.path.toStdString());
  }
  return names;
}

}  // namespace

void attachSceneEditorCommands(ViewContext& context) {
  if (context.commands.isAttached("scene.edit")) return;
  sceneBench(context);
  const std::weak_ptr<SceneBench> shared = context.scenes;
  const auto attach = [&](const char* name, std::function<Result<void>(SceneBench&, const std::string&)> run,
                          CommandTable::Offer offer) {
    context.commands.attach(
        name,
        [shared, run = std::move(run)](const CommandTable::Values& values) -> Result<void> {
          if (const auto bench = shared.lock()) return run(*bench, sceneWord(values, 0));
          return failure("scene.closed", "the window with the scene editor is closed");
        },
        std::move(offer));
  };
  attach("scene.edit", editScene, [shared](const auto& before) {
    const auto bench = shared.lock();
    return bench && before.empty() ? knownObjects(*bench) : std::vector<std::string>();
  });
  attach("scene.save",
         [](SceneBench& bench, const std::string& file) {
           return file.empty() ? bench.save() : bench.saveAs(file);
         },
         {});
}

}  // namespace widgets
