// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/robotctl/ColorCommands.h"
#include "app/robotctl/ColorImages.h"
#include "app/robotctl/Commands.h"
#include "colortool/Evaluation.h"

namespace app {
namespace {

using colortool::Evaluation;
using robotlink::Result;

struct EvaluateArguments {
  std::string table, images, labels;
  ClassNames classes = defaultClassNames();
  bool json = false;
};

/// Background that is sorted into one of these is what a robot stumbles over.
std::vector<std::uint8_t> falseClasses(const ClassNames& names) {
  std::vector<std::uint8_t> classes;
  for (const char* name : {"orange", "blue", "yellow", "red"}) {
    if (const int number = classNumber(names, name); number != 0)
      classes.push_back(static_cast<std::uint8_t>(number));
  }
  return classes;
}

void printJson(const Evaluation& evaluation, const ClassNames& names) {
  nlohmann::ordered_json recall = nlohmann::ordered_json::object(),
                         confusion = nlohmann::ordered_json::object();
  for (int label = 0; label < evaluation.classes(); ++label) {
    const std::uint64_t all = evaluation.labelled(label);
    if (all == 0) continue;
    const std::string name = label == 0 ? "background" : className(names, label);
    if (label != 0) recall[name] = evaluation.recall(label);
    for (int found = 0; found < evaluation.classes(); ++found) {
      const std::uint64_t count = evaluation.count(label, found);
      if (count != 0)
        confusion[name][className(names, found)] = static_cast<double>(count) / static_cast<double>(all);
    }
  }
  const nlohmann::ordered_json result{{"recall", recall},
                                      {"mean_recall", evaluation.meanRecall()},
                                      {"false_color", evaluation.falseColor(falseClasses(names))},
                                      {"confusion", confusion}};
  std::cout << result.dump(2) << "\n";
}

void printText(const Evaluation& evaluation, const ClassNames& names) {
  for (int label = 0; label < evaluation.classes(); ++label) {
    const std::uint64_t all = evaluation.labelled(label);
    if (all == 0) continue;
    std::printf("%-12s %10llu pixels", label == 0 ? "background" : className(names, label).c_str(),
                static_cast<unsigned long long>(all));
    for (int found = 0; found < evaluation.classes(); ++found) {
      const std::uint64_t count = evaluation.count(label, found);
      if (count != 0)
        std::printf("  %s %.2f %%", className(names, found).c_str(),
                    100 * static_cast<double>(count) / static_cast<double>(all));
    }
    std::printf("\n");
  }
  std::printf("mean recall  %.2f %%\nfalse colour %.3f %%\n", 100 * evaluation.meanRecall(),
              100 * evaluation.falseColor(falseClasses(names)));
}

/// Adds an image if it has labels. How many images were added.
Result<int> add(const ColorImages& images, const std::string& name, const EvaluateArguments& arguments,
                const colortool::ColorTable& table, Evaluation& evaluation) {
  const auto labels =
      std::filesystem::path(arguments.labels) / (std::filesystem::path(name).stem().string() + ".png");
  std::error_code error;
  if (!std::filesystem::exists(labels, error)) return 0;
  const auto labelled = ColorImages::loadLabels(labels);
  if (!labelled) return tl::unexpected(labelled.error());
  const auto image = images.load(name);
  if (!image) return tl::unexpected(image.error());
  if (image->width != labelled->width || image->height != labelled->height) {
    return robotlink::failure("image.size", "the labels are not of the size of image " + name,
                              {labels.string(), 0, 0}, {name});
  }
  evaluation.add(table, *image, labelled->data);
  return 1;
}

int run(const EvaluateArguments& arguments) {
  const auto file = colortool::ColorTableFile::load(arguments.table);
  if (!file) return printErrors({file.error()});
  const auto images = ColorImages::open(arguments.images);
  if (!images) return printErrors({images.error()});
  Evaluation evaluation(static_cast<int>(arguments.classes.size()) + 1);
  const colortool::ColorTable table = singleTable(*file);
  int evaluated = 0;
  for (const std::string& name : images->names()) {
    const auto added = add(*images, name, arguments, table, evaluation);
    if (!added) return printErrors({added.error()});
    evaluated += *added;
  }
  if (evaluated == 0) {
    return printErrors({{"color.labels",
                         "no image has labels here: PNG files of the same names",
                         {},
                         {arguments.labels, 0, 0}}});
  }
  if (arguments.json)
    printJson(evaluation, arguments.classes);
  else
    printText(evaluation, arguments.classes);
  return kDone;
}

}  // namespace

void addColorEvaluateCommand(CLI::App& color, int& status) {
  auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command =
      color.add_subcommand("evaluate", "Compares what a colour table makes of images with their labels");
  command->add_option("--table", arguments->table, "A colour table (.c64)")->required();
  command->add_option("--images", arguments->images, "A folder of images (PNG, JPEG, .yuyv), or a log file")
      ->required();
  command
      ->add_option("--labels", arguments->labels,
                   "A folder of grey PNG files with the classes' numbers, named like the images; 0 is "
                   "background, 255 is passed over")
      ->required();
  command
      ->add_option("--classes", arguments->classes,
                   "Names of the classes, in the order of their numbers, instead of the usual ones")
      ->delimiter(',');
  command->add_flag("--json", arguments->json, "Prints JSON: fractions");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace app
