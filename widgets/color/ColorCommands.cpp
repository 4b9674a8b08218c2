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
#include "robotlink/commands/CommandTable.h"
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
using Values = CommandTable::Values;
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

/// Attaches commands of a table. They hold weak references, so they fail once the window no longer exists.
class Commands {
 public:
  explicit Commands(ViewContext& context) : table_(context.commands) {
    files_ = &colorFiles(context);
    bench_ = context.colors;
  }
  void attach(const char* name, const Run& run) {
    const auto act = [run, files = files_, shared = bench_](const Values& values) -> Result<void> {
      const auto bench = shared.lock();
      if (bench == nullptr) return failure("color.closed", "the window of this color table is closed");
      return run(*bench, *files, values);
    };
    table_.attach(name, act);
  }

 private:
  CommandTable& table_;
  std::weak_ptr<ColorBench> bench_;
  ColorFiles* files_;  // a child of the bench
};

void attachFileCommands(Commands& commands) {
  commands.attach("color.new", [](auto&, ColorFiles& files, auto&) {
    return nothingUnsaved(files).map([&files] { files.startAnew(); });
  });
  commands.attach("color.open", [](auto&, ColorFiles& files, const Values& values) {
    return nothingUnsaved(files).and_then([&] { return files.open(text(values, 0)); });
  });
  commands.attach("color.save", [](auto&, ColorFiles& files, auto&) { return files.save(); });
  commands.attach("color.save-as", [](auto&, ColorFiles& files, const Values& values) {
    return files.saveAs(text(values, 0));
  });
  commands.attach("color.discard", [](auto&, ColorFiles& files, auto&) { return discard(files); });
  commands.attach("color.merge", [](auto&, ColorFiles& files, const Values& values) {
    return files.merge(text(values, 0));
  });
  commands.attach("color.open-pictures", [](auto&, ColorFiles& files, const Values& values) -> Result<void> {
    files.openPictures({text(values, 0)});
    return {};
  });
  commands.attach("color.export", [](auto&, ColorFiles& files, const Values& values) {
    return files.exportTable(text(values, 0), false);
  });
  commands.attach("color.compare", [](ColorBench& bench, ColorFiles& files, const Values& values) {
    return compare(bench, files, text(values, 0));
  });
}

void attachStrokeCommands(Commands& commands) {
  commands.attach("color.class", [](ColorBench& bench, auto&, const Values& values) {
    return chooseClass(bench, text(values, 0));
  });
  commands.attach("color.must-not", [](ColorBench& bench, auto&, const Values& values) -> Result<void> {
    bench.setMustNotBe(std::get<bool>(values[0]));
    return {};
  });
  commands.attach("color.weight", [](ColorBench& bench, auto&, const Values& values) {
    return setWeight(bench, number(values, 0));
  });
  commands.attach("color.stroke",
                  [](ColorBench& bench, auto&, const Values& values) { return addStroke(bench, values); });
  commands.attach("color.undo",
                  [](ColorBench& bench, auto&, auto&) { return step(bench.undoStack(), false); });
  commands.attach("color.redo",
                  [](ColorBench& bench, auto&, auto&) { return step(bench.undoStack(), true); });
}

void attachTableCommands(Commands& commands) {
  commands.attach("color.preset", [](ColorBench& bench, auto&, const Values& values) {
    return usePreset(bench, text(values, 0));
  });
  commands.attach("color.method", [](ColorBench& bench, auto&, const Values& values) {
    return setMethod(bench, text(values, 0));
  });
  commands.attach("color.option", [](ColorBench& bench, auto&, const Values& values) {
    return setOption(bench, text(values, 0), number(values, 1));
  });
  commands.attach("color.send", [](ColorBench& bench, auto&, auto&) -> Result<void> {
    if (bench.session().selectedRobot().empty())
      return failure("color.no-robot", "there is no robot; open a scene or a log first");
    colorSender(bench).send();
    return {};
  });
  commands.attach("color.auto-send", [](ColorBench& bench, auto&, const Values& values) -> Result<void> {
    colorSender(bench).setAutoSend(std::get<bool>(values[0]));
    return {};
  });
}

/// The finder is a child of the bench.
void attachSearchCommands(Commands& commands, ColorFrameFinder* finder) {
  commands.attach("color.find-frames", [finder](auto&, auto&, auto&) { return finder->search(); });
}

}  // namespace

void addColorCommands(ViewContext& context) {
  if (context.commands.isAttached("color.new")) return;
  Commands commands(context);
  attachFileCommands(commands);
  attachStrokeCommands(commands);
  attachTableCommands(commands);
  attachSearchCommands(commands, &colorFrameFinder(context));
}

}  // namespace widgets
