// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl color train`.
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/core/platform/NumberRange.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/color/ColorImages.h"
#include "app/robotctl/color/ColorSubcommands.h"
#include "app/robotctl/color/LabelStrokes.h"
#include "colortool/samples/SampleFile.h"
#include "colortool/samples/StrokeList.h"
#include "colortool/training/TableTrainer.h"
#include "logplayer/base/Plural.h"
#include "robotlink/base/Printable.h"

namespace app {
namespace {

using colortool::ColorTableFile;
using colortool::DiscStroke;
using colortool::Samples;
using colortool::TrainingMethod;
using robotlink::Errors;

const std::map<std::string, TrainingMethod> kMethods = {{"kernel", TrainingMethod::kVotes},
                                                        {"gauss", TrainingMethod::kGaussians},
                                                        {"svm", TrainingMethod::kSupportVectors}};

struct TrainArguments {
  std::string strokes, labels, images, samples, out, samplesOut;
  /// Strokes in each class of a labeled image.
  std::size_t discs = 3;
  std::string method = "kernel";
  ClassNames classes;
  /// Share of the winner's votes for further classes of a cell; 0: each cell has one class.
  double several = 0;
  bool asLearned = false;
  colortool::TrainingSettings settings;
};

/// The samples made from strokes, and the strokes that could not be used.
struct Learned {
  Samples samples;
  int outside = 0;
  Errors problems;
};

/// Fails with one error per unknown class name.
tl::expected<void, Errors> checkClasses(const std::vector<DiscStroke>& strokes,
                                        const colortool::ColorClasses& known, const std::string& file) {
  Errors errors;
  std::set<std::string> reported{std::string(DiscStroke::kBackground)};
  for (const DiscStroke& stroke : strokes) {
    if (known.index(stroke.colorClass) != colortool::ColorClasses::kNone ||
        !reported.insert(stroke.colorClass).second)
      continue;
    std::string names;
    for (const std::string& name : known.names()) names += ", " + name;
    errors.push_back({"color.class",
                      "there is no class '" + stroke.colorClass + "'; the classes are background" + names +
                          " (see --classes)",
                      {stroke.colorClass},
                      {file, 0, 0}});
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return {};
}

/// Adds what a stroke touches of its image. False: nothing.
bool addStroke(Samples& samples, const DiscStroke& stroke, const colortool::ColorImage& image) {
  const double scale = static_cast<double>(image.width) / DiscStroke::kReferenceWidth;
  const colortool::ImagePoint at[] = {{stroke.x * scale, stroke.y * scale}};
  const auto area = colortool::brushArea(image.width, image.height, at, stroke.radius * scale);
  return addStroke(samples, {0, stroke.image, "", "", 0, 0}, image, area,
                   {samples.classes.index(stroke.colorClass), false, 1, "point"}) != 0;
}

/// Returns the classes of the option, else those in the file beside the labels.
tl::expected<colortool::ColorClasses, Errors> classesOf(const TrainArguments& arguments) {
  if (!arguments.labels.empty() && arguments.classes.empty()) {
    auto named = namedLabelClasses(arguments.labels);
    if (!named) return tl::unexpected(named.error());
    if (*named) return std::move(**named);
  }
  auto chosen = chosenClasses(arguments.classes);
  if (!chosen) return tl::unexpected(Errors{chosen.error()});
  return std::move(*chosen);
}

tl::expected<std::vector<DiscStroke>, Errors> strokesOf(const TrainArguments& arguments,
                                                        const ColorImages& images,
                                                        const colortool::ColorClasses& classes) {
  if (arguments.labels.empty()) return colortool::readStrokeList(arguments.strokes);
  auto made = strokesOfLabels(images, arguments.labels, classes, arguments.discs);
  if (!made) return tl::unexpected(Errors{made.error()});
  return std::move(*made);
}

tl::expected<Learned, Errors> samplesOfStrokes(const TrainArguments& arguments) {
  auto classes = classesOf(arguments);
  if (!classes) return tl::unexpected(classes.error());
  const auto images = ColorImages::open(arguments.images);
  if (!images) return tl::unexpected(Errors{images.error()});
  const auto strokes = strokesOf(arguments, *images, *classes);
  if (!strokes) return tl::unexpected(strokes.error());
  if (auto checked = checkClasses(*strokes, *classes, arguments.strokes); !checked)
    return tl::unexpected(checked.error());
  Learned learned;
  learned.samples.classes = std::move(*classes);
  std::map<std::string, colortool::ColorImage> loaded;
  for (const DiscStroke& stroke : *strokes) {
    auto image = loaded.find(stroke.image);
    if (image == loaded.end()) {
      auto read = images->load(stroke.image);
      if (!read) return tl::unexpected(Errors{read.error()});
      image = loaded.emplace(stroke.image, std::move(*read)).first;
    }
    if (!addStroke(learned.samples, stroke, image->second)) ++learned.outside;
  }
  return learned;
}

tl::expected<Learned, Errors> samplesOfFile(const std::string& file) {
  auto read = colortool::loadSamples(file);
  if (!read) return tl::unexpected(Errors{read.error()});
  return Learned{std::move(read->samples), 0, std::move(read->problems)};
}

/// The table learned from the samples, with several classes per cell if requested.
ColorTableFile::Packed tableOf(const Samples& samples, double several) {
  colortool::TableTrainer trainer;
  const colortool::ColorTable& table = trainer.train(samples);
  std::vector<std::uint16_t> masks(ColorTableFile::kCellCount);
  for (std::size_t cell = 0; cell < masks.size() && several > 0; ++cell) {
    if (table.cells()[cell] != 0) masks[cell] = trainer.votes().classesOf(cell, several);
  }
  return ColorTableFile::pack(table.cells(), masks);
}

/// Reports losses to stderr and returns the resulting ExitStatus.
int printTrainedLosses(const TrainArguments& arguments, const Learned& learned,
                       const ColorTableFile::Packed& made) {
  for (const robotlink::Error& problem : learned.problems)
    std::cerr << robotlink::printable(problem.describe()) << "\n";
  if (learned.outside != 0) {
    std::cerr << (arguments.labels.empty() ? arguments.strokes : arguments.labels) << ": "
              << (learned.outside == 1
                      ? "one stroke is outside its image"
                      : std::to_string(learned.outside) + " strokes are outside their images")
              << "\n";
  }
  if (made.reducedCells != 0) {
    std::cerr << arguments.out << ": of " << made.reducedCells
              << " cells of several classes only the best is kept, since a .c64 has room for several classes "
                 "with numbers up to "
              << ColorTableFile::kMaxOfSeveral << "\n";
  }
  const bool losses = !learned.problems.empty() || learned.outside != 0 || made.reducedCells != 0;
  return losses ? kDoneWithLosses : kDone;
}

int train(const TrainArguments& arguments) {
  auto learned = arguments.samples.empty() ? samplesOfStrokes(arguments) : samplesOfFile(arguments.samples);
  if (!learned) return printErrors(learned.error());
  Samples& samples = learned->samples;
  if (!arguments.asLearned) {
    samples.settings = arguments.settings;
    samples.settings.method = kMethods.at(arguments.method);
  }
  const auto made = tableOf(samples, arguments.several);
  const colortool::NamedColorTable table{made.file, samples.classes};
  if (const auto saved = table.save(arguments.out); !saved) return printErrors({saved.error()});
  if (!arguments.samplesOut.empty()) {
    if (const auto saved = saveSamples(samples, arguments.samplesOut); !saved)
      return printErrors({saved.error()});
  }
  std::cout << arguments.out << ": " << logplayer::plural(samples.strokes.size(), "stroke") << " in "
            << logplayer::plural(samples.images.size(), "image") << "\n";
  return printTrainedLosses(arguments, *learned, made);
}

/// Adds the options of the training methods, with their defaults.
void addSettings(CLI::App& command, colortool::TrainingSettings& settings) {
  using Votes = colortool::VoteOptions;
  const auto number = [&](const char* name, double& value, const char* help, const CLI::Validator& range) {
    command.add_option(name, value, help)->check(range)->capture_default_str();
  };
  number("--radius", settings.votes.radius,
         "Reach of a sample in Cb and Cr: one standard deviation; for strong colors more along their "
         "saturation, less across it",
         numberFrom(Votes::kMinRadius, Votes::kMaxRadius));
  number("--y-weight", settings.votes.brightnessWeight, "Weight of a difference in Y, relative to Cb or Cr",
         numberFrom(Votes::kMinBrightnessWeight, 1));
  number("--rejection", settings.votes.rejection,
         "Minimum votes that a class needs, as a fraction of one sample's own vote", nonNegativeNumber());
  number("--background-weight", settings.votes.backgroundWeight,
         "Weight of a background sample, relative to one of a class",
         numberFrom(0, Votes::kMaxBackgroundWeight));
  number("--shading", settings.votes.shading,
         "Vote of a sample for its color in shadow and glare, as a fraction of its own vote",
         numberFrom(0, Votes::kMaxShading));
  number("--gray-guard", settings.votes.grayGuard,
         "Extra votes that nearly gray colors of objects need, for each stroke of the class",
         nonNegativeNumber());
  number("--reject-distance", settings.gaussians.mostSquaredDistance,
         "gauss: squared Mahalanobis distance from a class beyond which a color does not belong to it",
         positiveNumber());
  number("--cost", settings.supportVectors.cost, "svm: cost of a misclassified sample", positiveNumber());
  number("--gamma", settings.supportVectors.gamma, "svm: gamma of its radial basis functions",
         positiveNumber());
  number("--reject-radius", settings.supportVectors.mostDistance,
         "svm: maximum distance of a class from its samples", positiveNumber());
  command.add_flag("!--keep-unsupported", settings.cleanUp.removeUnsupported,
                   "Keeps cells that no sample supports");
  command.add_flag("!--keep-holes", settings.cleanUp.fillHoles, "Keeps holes inside a class");
}

}  // namespace

void addColorTrainCommand(CLI::App& color, int& status) {
  auto arguments = std::make_shared<TrainArguments>();
  CLI::App* command = color.add_subcommand(
      "train", "Makes a color table from strokes in images, from labeled images, or from samples");
  CLI::Option* strokes = command->add_option("--strokes", arguments->strokes,
                                             "CSV with the header image,class,x,y,radius; in pixels of the "
                                             "image at a width of 320; class background means none of them");
  CLI::Option* images = command->add_option("--images", arguments->images,
                                            "The folder of the images (PNG, JPEG, .yuyv), or a log file");
  CLI::Option* samples = command->add_option("--samples", arguments->samples,
                                             "Samples that the workbench saved, instead of strokes");
  CLI::Option* labels = command->add_option(
      "--labels", arguments->labels,
      "A folder of gray PNG files with the true classes' numbers, as robotctl sim --labelled-images writes "
      "them, instead of strokes: strokes are made inside each class");
  command->add_option("--discs", arguments->discs, "Number of strokes made in each class of a labeled image")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str()
      ->needs(labels);
  strokes->needs(images)->excludes(samples)->excludes(labels);
  labels->needs(images)->excludes(samples);
  images->excludes(samples);
  command->add_option("--out", arguments->out, "The color table (.c64)")->required();
  command->add_option("--save-samples", arguments->samplesOut,
                      "Also writes the training samples, for the workbench");
  addClassesOption(*command, arguments->classes,
                   "Names of the classes, in the order of their numbers; they are written next to the table");
  command
      ->add_option(
          "--method", arguments->method,
          "kernel: samples vote around them; gauss: one Gaussian per class; svm: a support vector machine")
      ->check(CLI::IsMember(kMethods))
      ->capture_default_str();
  command
      ->add_option("--several", arguments->several,
                   "kernel: a cell keeps all classes with at least this fraction of the best one's votes")
      ->check(numberFrom(0, 1));
  addSettings(*command, arguments->settings);
  CLI::Option* own = command->add_flag("--own-settings", arguments->asLearned,
                                       "Uses the options in the samples file instead of those given here");
  own->needs(samples);
  command->callback([arguments, strokes, labels, samples, &status] {
    if (strokes->empty() && labels->empty() && samples->empty())
      throw CLI::RequiredError("--strokes or --labels with --images, or --samples");
    status = train(*arguments);
  });
}

}  // namespace app
