// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl color evaluate`.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "app/platforms/simulated/world/TrueClasses.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/color/ColorImages.h"
#include "app/robotctl/color/ColorSubcommands.h"
#include "colortool/scoring/Evaluation.h"

namespace app {
namespace {

using colortool::ColorClasses;
using colortool::Evaluation;
using robotlink::Result;

struct EvaluateArguments {
  std::string table, images, labels;
  ClassNames classes, labelClasses;
  bool json = false;
};

/// The classes that are harmful to a robot if background is classified as one of them.
std::vector<std::uint8_t> falseClasses(const ColorClasses& classes) {
  std::vector<std::uint8_t> numbers;
  for (const char* name : {"orange", "blue", "yellow", "red"}) {
    if (const std::uint8_t number = classes.index(name); number != ColorClasses::kNone)
      numbers.push_back(number);
  }
  return numbers;
}

void printFigures(const Evaluation& evaluation, const ColorClasses& classes) {
  nlohmann::ordered_json recall = nlohmann::ordered_json::object(),
                         confusion = nlohmann::ordered_json::object();
  for (int label = 0; label < evaluation.classes(); ++label) {
    const std::uint64_t all = evaluation.labeled(label);
    if (all == 0) continue;
    const std::string name = label == 0 ? "background" : classes.name(label);
    if (label != 0) recall[name] = evaluation.recall(label);
    for (int found = 0; found < evaluation.classes(); ++found) {
      const std::uint64_t count = evaluation.count(label, found);
      if (count != 0)
        confusion[name][classes.name(found)] = static_cast<double>(count) / static_cast<double>(all);
    }
  }
  const nlohmann::ordered_json result{{"recall", recall},
                                      {"mean_recall", evaluation.meanRecall()},
                                      {"false_color", evaluation.falseColor(falseClasses(classes))},
                                      {"confusion", confusion}};
  std::cout << jsonOutput(result);
}

void printFiguresAsText(const Evaluation& evaluation, const ColorClasses& classes) {
  for (int label = 0; label < evaluation.classes(); ++label) {
    const std::uint64_t all = evaluation.labeled(label);
    if (all == 0) continue;
    std::printf("%-12s %10llu pixels", label == 0 ? "background" : classes.name(label).c_str(),
                static_cast<unsigned long long>(all));
    for (int found = 0; found < evaluation.classes(); ++found) {
      const std::uint64_t count = evaluation.count(label, found);
      if (count != 0)
        std::printf("  %s %.2f %%", classes.name(found).c_str(),
                    100 * static_cast<double>(count) / static_cast<double>(all));
    }
    std::printf("\n");
  }
  std::printf("mean recall  %.2f %%\nfalse color %.3f %%\n", 100 * evaluation.meanRecall(),
              100 * evaluation.falseColor(falseClasses(classes)));
}

/// Whether the labels are in the log that also contains the images.
bool inLog(const EvaluateArguments& arguments) {
  std::error_code error;
  return std::filesystem::is_regular_file(arguments.labels, error);
}

Result<std::optional<robotlink::Image>> labelsOf(const ColorImages& images, const std::string& name,
                                                 const EvaluateArguments& arguments) {
  if (inLog(arguments)) return images.trueClasses(name);
  const auto file =
      std::filesystem::path(arguments.labels) / (std::filesystem::path(name).stem().string() + ".png");
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  auto labels = ColorImages::loadLabels(file);
  if (!labels) return tl::unexpected(labels.error());
  return std::move(*labels);
}

/// Adds an image if it has labels. How many images were added.
Result<int> addImage(const ColorImages& images, const std::string& name, const EvaluateArguments& arguments,
                     const colortool::ColorTable& table, Evaluation& evaluation) {
  const auto labels = labelsOf(images, name, arguments);
  if (!labels) return tl::unexpected(labels.error());
  if (!*labels) return 0;
  const auto image = images.load(name);
  if (!image) return tl::unexpected(image.error());
  if (image->width != (*labels)->width || image->height != (*labels)->height) {
    return robotlink::failure("image.size", "the labels differ in size from image " + name,
                              {arguments.labels, 0, 0}, {name});
  }
  evaluation.add(table, *image, (*labels)->data);
  return 1;
}

/// The classes of the labels' numbers: those of the option, or else those of the file beside the labels.
tl::expected<ColorClasses, robotlink::Errors> labelClasses(const EvaluateArguments& arguments) {
  if (inLog(arguments) && arguments.labelClasses.empty()) return TrueClasses::classes();
  if (arguments.labelClasses.empty() && arguments.classes.empty()) {
    auto named = namedLabelClasses(arguments.labels);
    if (!named) return tl::unexpected(named.error());
    if (*named) return std::move(**named);
  }
  auto chosen = chosenClasses(arguments.labelClasses.empty() ? arguments.classes : arguments.labelClasses);
  if (!chosen) return tl::unexpected(robotlink::Errors{chosen.error()});
  return *chosen;
}

int evaluate(const EvaluateArguments& arguments) {
  const auto named = loadTable(arguments.table, arguments.classes);
  if (!named) return printErrors(named.error());
  const auto labeled = labelClasses(arguments);
  if (!labeled) return printErrors(labeled.error());
  const auto images = ColorImages::open(arguments.images);
  if (!images) return printErrors({images.error()});
  std::error_code different;
  if (inLog(arguments) && !std::filesystem::equivalent(arguments.labels, arguments.images, different)) {
    return printErrors(
        {{"color.labels",
          "true classes are read from the log file that the images are from; name the same file",
          {},
          {arguments.labels, 0, 0}}});
  }
  // Classes are matched by name, since labels and table may have different numbers.
  const ColorClasses classes = unite(*labeled, named->classes);
  const auto table =
      colortool::ColorTable::translated(named->file.singleClasses(), classNumbers(named->classes, classes));
  Evaluation evaluation(classes.size());
  int evaluated = 0;
  for (const std::string& name : images->names()) {
    const auto added = addImage(*images, name, arguments, table, evaluation);
    if (!added) return printErrors({added.error()});
    evaluated += *added;
  }
  if (evaluated == 0) {
    return printErrors({{"color.labels",
                         inLog(arguments) ? "no image has true classes here: record with --class-images"
                                          : "no image has labels here: add PNG files with the images' names",
                         {},
                         {arguments.labels, 0, 0}}});
  }
  if (arguments.json)
    printFigures(evaluation, classes);
  else
    printFiguresAsText(evaluation, classes);
  return kDone;
}

}  // namespace

void addColorEvaluateCommand(CLI::App& color, int& status) {
  auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command =
      color.add_subcommand("evaluate",
                           "Compares a color table's classes in images with their labels: how much of each "
                           "class is found, and how "
                           "much of the background is taken for orange, blue, yellow or red (false color)");
  command->add_option("--table", arguments->table, "A color table (.c64)")->required();
  command->add_option("--images", arguments->images, "A folder of images (PNG, JPEG, .yuyv), or a log file")
      ->required();
  command
      ->add_option("--labels", arguments->labels,
                   "A folder of gray PNG files with the classes' numbers, named like the images; 0 is "
                   "background, 255 is ignored; or again the log file, with true classes")
      ->required();
  addClassesOption(
      *command, arguments->classes,
      "Names of the table's classes, in the order of their numbers, if not from the file next to it");
  command
      ->add_option("--label-classes", arguments->labelClasses,
                   "Names of the labels' classes, if numbered differently; default: --classes, the file "
                   "labels.classes among the labels, or the classes in the log")
      ->delimiter(',');
  command->add_flag("--json", arguments->json, "Prints JSON: fractions");
  command->callback([arguments, &status] { status = evaluate(*arguments); });
}

}  // namespace app
