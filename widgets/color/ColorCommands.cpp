// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorCommands.h"

#include <QUndoStack>
#include <functional>
#include <memory>
#include <utility>

#include "colortool/image/ClassPresets.h"
#include "colortool/image/PixelArea.h"
#include "colortool/samples/ClassEdits.h"
#include "colortool/training/TrainingOptions.h"
#include "robotlink/session/CommandTable.h"
#include "robotlink/session/Session.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/color/ColorFrameFinder.h"
#include "widgets/color/ColorReferences.h"
#include "widgets/color/ColorSender.h"

namespace widgets {
namespace {

using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;
using Type = CommandTable::Type;
using Values = std::vector<CommandTable::Value>;
using Run = std::function<Result<void>(ColorBench&, ColorFiles&, const Values&)>;

const std::string& text(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}
double number(const Values& values, std::size_t index) {
  return std::get<double>(values[index]);
}
QString shown(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

Result<void> nothingUnsaved(const ColorFiles& files) {
  if (!files.changed()) return {};
  return failure(
      "color.unsaved",
      "the samples were changed; save them (color.save-as FILE) or discard the changes (color.discard)");
}

Result<void> discard(ColorFiles& files) {
  if (!files.file().empty()) return files.open(files.file());
  files.startAnew();
  return {};
}

Result<void> chooseClass(ColorBench& bench, const std::string& name) {
  const auto& classes = bench.samples().classes;
  const auto found = classes.index(name);
  if (found == colortool::ColorClasses::kNone && name != "background") {
    std::string names;
    for (const std::string& each : classes.names()) names += each + ", ";
    return failure("color.class", "there is no class '" + name + "'; there are " + names + "background", {},
                   {name});
  }
  bench.setCurrentClass(found);
  return {};
}

Result<void> setWeight(ColorBench& bench, double weight) {
  using colortool::Stroke;
  if (!(weight >= Stroke::kMinWeight && weight <= Stroke::kMaxWeight))
    return failure("color.weight", "a weight is between 0.1 and 10");
  bench.setWeight(weight);
  return {};
}

Result<void> addStroke(ColorBench& bench, const Values& values) {
  if (!bench.frame())
    return failure("color.no-image", "no image is shown; open the view Color image, and a stream of images");
  const double radius = number(values, 2);
  if (!(radius >= 0 && radius <= 1000))
    return failure("color.radius", "a radius is between 0 and 1000 pixels");
  const colortool::ImagePoint at[] = {{number(values, 0), number(values, 1)}};
  const auto area = colortool::brushArea(bench.frame()->width(), bench.frame()->height(), at, radius);
  if (area.empty()) return failure("color.outside", "this is outside of the image");
  bench.addStroke(area, "brush");
  return {};
}

Result<void> step(QUndoStack& stack, bool forth) {
  if (forth ? !stack.canRedo() : !stack.canUndo())
    return failure("color.history", forth ? "there is nothing to redo" : "there is nothing to undo");
  forth ? stack.redo() : stack.undo();
  return {};
}

Result<void> setMethod(ColorBench& bench, const std::string& name) {
  const auto method = colortool::trainingMethod(name);
  if (!method) return tl::unexpected(method.error());
  colortool::Samples next = bench.samples();
  next.settings.method = *method;
  bench.change(QStringLiteral("Method: %1").arg(shown(name)), std::move(next));
  return {};
}

Result<void> setOption(ColorBench& bench, const std::string& name, double value) {
  colortool::Samples next = bench.samples();
  auto settings = colortool::withOption(next.settings, name, value);
  if (!settings) return tl::unexpected(settings.error());
  next.settings = *settings;
  bench.change(QStringLiteral("Option: %1").arg(shown(name)), std::move(next));
  return {};
}

Result<void> usePreset(ColorBench& bench, const std::string& name) {
  const colortool::ClassPreset* preset = colortool::findClassPreset(name);
  if (preset == nullptr) {
    std::string names;
    for (const auto& each : colortool::classPresets())
      names += (names.empty() ? "" : ", ") + std::string(each.name);
    return failure("color.preset", "there is no preset '" + name + "'; there are " + names, {}, {name});
  }
  bench.change(QStringLiteral("Preset: %1").arg(shown(preset->title)),
               colortool::withClasses(bench.samples(), preset->classes()));
  return {};
}

Result<void> compare(ColorBench& bench, ColorFiles& files, const std::string& table) {
  if (table != "now" && table != "none") return files.importReference(table);
  bench.setReference(table == "now" ? referenceOfNow(bench) : ReferenceTable());
  return {};
}

/// Adds commands to a table. They hold weak references, so they fail once the window is gone.
class Commands {
 public:
  explicit Commands(ViewContext& context) : table_(context.commands) {
    files_ = &colorFiles(context);
    bench_ = context.colors;
  }
  void add(const char* name, const char* help, std::vector<CommandTable::Argument> arguments,
           const Run& run) {
    const auto act = [run, files = files_, shared = bench_](const Values& values) -> Result<void> {
      const auto bench = shared.lock();
      if (bench == nullptr) return failure("color.closed", "the window of this color table is closed");
      return run(*bench, *files, values);
    };
    table_.add({name, help, std::move(arguments), act});
  }

 private:
  CommandTable& table_;
  std::weak_ptr<ColorBench> bench_;
  ColorFiles* files_;  // a child of the bench
};

void addFileCommands(Commands& commands) {
  const CommandTable::Argument file{"file", Type::kText, "a .samples file"};
  commands.add("color.new", "Starts new samples of a color table", {}, [](auto&, ColorFiles& files, auto&) {
    return nothingUnsaved(files).map([&files] { files.startAnew(); });
  });
  commands.add("color.open", "Opens the samples of a color table", {file},
               [](auto&, ColorFiles& files, const Values& values) {
                 return nothingUnsaved(files).and_then([&] { return files.open(text(values, 0)); });
               });
  commands.add("color.save", "Saves the samples of the color table to the file they are from", {},
               [](auto&, ColorFiles& files, auto&) { return files.save(); });
  commands.add("color.save-as", "Saves the samples of the color table", {file},
               [](auto&, ColorFiles& files, const Values& values) { return files.saveAs(text(values, 0)); });
  commands.add("color.discard", "Discards unsaved changes of the samples", {},
               [](auto&, ColorFiles& files, auto&) { return discard(files); });
  commands.add("color.merge", "Adds the samples of another file", {file},
               [](auto&, ColorFiles& files, const Values& values) { return files.merge(text(values, 0)); });
  commands.add("color.open-pictures", "Adds pictures to the strip and shows the first",
               {{"path", Type::kText, "a picture (.png, .jpg, .jpeg, .yuyv) or a folder of them"}},
               [](auto&, ColorFiles& files, const Values& values) -> Result<void> {
                 files.openPictures({text(values, 0)});
                 return {};
               });
  commands.add("color.export", "Writes the color table to a file", {{"file", Type::kText, "a .c64 file"}},
               [](auto&, ColorFiles& files, const Values& values) {
                 return files.exportTable(text(values, 0), false);
               });
  commands.add("color.compare", "Compares the table with another one",
               {{"table", Type::kText, "a file, now (what it is now), or none"}},
               [](ColorBench& bench, ColorFiles& files, const Values& values) {
                 return compare(bench, files, text(values, 0));
               });
}

void addStrokeCommands(Commands& commands) {
  commands.add(
      "color.class", "Chooses the class of the next stroke",
      {{"name", Type::kText, "of a class, or background"}},
      [](ColorBench& bench, auto&, const Values& values) { return chooseClass(bench, text(values, 0)); });
  commands.add("color.must-not", "Chooses whether the next strokes must not be of the class",
               {{"on", Type::kBool, ""}}, [](ColorBench& bench, auto&, const Values& values) -> Result<void> {
                 bench.setMustNotBe(std::get<bool>(values[0]));
                 return {};
               });
  commands.add(
      "color.weight", "Sets how much the next strokes count", {{"weight", Type::kNumber, "0.1 to 10"}},
      [](ColorBench& bench, auto&, const Values& values) { return setWeight(bench, number(values, 0)); });
  commands.add(
      "color.stroke", "Adds a disc of the color view's image to the samples",
      {{"x", Type::kNumber, "pixels"}, {"y", Type::kNumber, "pixels"}, {"radius", Type::kNumber, "pixels"}},
      [](ColorBench& bench, auto&, const Values& values) { return addStroke(bench, values); });
  commands.add("color.undo", "Undoes the last change of the samples", {},
               [](ColorBench& bench, auto&, auto&) { return step(bench.undoStack(), false); });
  commands.add("color.redo", "Redoes what was undone", {},
               [](ColorBench& bench, auto&, auto&) { return step(bench.undoStack(), true); });
}

void addTableCommands(Commands& commands) {
  commands.add(
      "color.preset", "Sets the classes; strokes keep the class of their name",
      {{"name", Type::kText, "2002 or bhuman2009"}},
      [](ColorBench& bench, auto&, const Values& values) { return usePreset(bench, text(values, 0)); });
  commands.add(
      "color.method", "Chooses how the table is made",
      {{"name", Type::kText, "votes, gaussians or support-vectors"}},
      [](ColorBench& bench, auto&, const Values& values) { return setMethod(bench, text(values, 0)); });
  commands.add("color.option", "Sets an option of how the table is made",
               {{"name", Type::kText, "such as radius"}, {"value", Type::kNumber, "switches: 0 or 1"}},
               [](ColorBench& bench, auto&, const Values& values) {
                 return setOption(bench, text(values, 0), number(values, 1));
               });
  commands.add("color.send", "Sends the table to the selected robot's program", {},
               [](ColorBench& bench, auto&, auto&) -> Result<void> {
                 if (bench.session().selectedRobot().empty())
                   return failure("color.no-robot", "there is no robot; open a scene or a log first");
                 colorSender(bench).send();
                 return {};
               });
  commands.add("color.auto-send", "Chooses whether each new table is sent to the robot at once",
               {{"on", Type::kBool, ""}}, [](ColorBench& bench, auto&, const Values& values) -> Result<void> {
                 colorSender(bench).setAutoSend(std::get<bool>(values[0]));
                 return {};
               });
}

/// The finder is a child of the bench.
void addSearchCommands(Commands& commands, ColorFrameFinder* finder) {
  commands.add("color.find-frames", "Searches for the images where the table looks most suspicious", {},
               [finder](auto&, auto&, auto&) { return finder->search(); });
}

}  // namespace

void addColorCommands(ViewContext& context) {
  if (context.commands.find("color.new") != nullptr) return;
  Commands commands(context);
  addFileCommands(commands);
  addStrokeCommands(commands);
  addTableCommands(commands);
  addSearchCommands(commands, &colorFrameFinder(context));
}

}  // namespace widgets
