// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "app/robotctl/ColorCommands.h"
#include "app/robotctl/ColorImages.h"
#include "app/robotctl/Commands.h"
#include "colortool/ColorVotes.h"
#include "colortool/StrokeList.h"

namespace app {
namespace {

using colortool::ColorTableFile;
using colortool::ColorVotes;
using colortool::DiscStroke;
using robotlink::Errors;

constexpr char kKernel[] = "kernel", kGauss[] = "gauss", kSupportVectors[] = "svm";

struct TrainArguments {
  std::string strokes, images, out;
  std::string method = kKernel;
  ClassNames classes;
  double several = 0;  ///< 0: each cell has one class
  colortool::VoteOptions options;
  colortool::GaussianOptions gauss;
  colortool::SupportVectorOptions supportVectors;
};

/// The classes that strokes are of, by their names; all that are not known are told.
tl::expected<std::map<std::string, std::uint8_t>, Errors> classesOf(const std::vector<DiscStroke>& strokes,
                                                                    const colortool::ColorClasses& known,
                                                                    const std::string& file) {
  std::map<std::string, std::uint8_t> classes{{std::string(DiscStroke::kBackground), 0}};
  Errors errors;
  for (const DiscStroke& stroke : strokes) {
    if (classes.contains(stroke.colorClass)) continue;
    const std::uint8_t number = known.index(stroke.colorClass);
    classes[stroke.colorClass] = number;
    if (number != colortool::ColorClasses::kNone) continue;
    std::string names;
    for (const std::string& name : known.names()) names += ", " + name;
    errors.push_back({"color.class",
                      "there is no class '" + stroke.colorClass + "'; the classes are background" + names +
                          " (see --classes)",
                      {stroke.colorClass},
                      {file, 0, 0}});
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return classes;
}

/// Adds what a stroke touches of its image. False: nothing.
bool add(const DiscStroke& stroke, const colortool::ColorImage& image, std::uint8_t colorClass,
         ColorVotes& votes) {
  const double scale = static_cast<double>(image.width) / DiscStroke::kReferenceWidth;
  bool any = false;
  colortool::visitDisc(image.width, image.height, stroke.x * scale, stroke.y * scale, stroke.radius * scale,
                       [&](int x, int y) {
                         votes.add(colortool::ColorTable::cellOf(image.at(x, y)), colorClass,
                                   ColorVotes::kUnit);
                         any = true;
                       });
  return any;
}

/// What the votes make; with several classes a cell if that is wanted.
ColorTableFile::Packed tableOf(const TrainArguments& arguments, ColorVotes& votes) {
  colortool::ColorTable table;
  if (arguments.method == kGauss)
    table = gaussianTable(votes.samples(), arguments.gauss);
  else if (arguments.method == kSupportVectors)
    table = supportVectorTable(votes.samples(), arguments.supportVectors);
  else
    table = votes.update();
  std::vector<std::uint16_t> masks(ColorTableFile::kCellCount);
  for (std::size_t cell = 0; cell < masks.size() && arguments.several > 0; ++cell) {
    if (table.cells()[cell] != 0) masks[cell] = votes.classesOf(cell, arguments.several);
  }
  return ColorTableFile::pack(table.cells(), masks);
}

/// Says what was lost, and how the program ends because of it.
int tellLosses(const TrainArguments& arguments, int strokesOutside, const ColorTableFile::Packed& made) {
  if (strokesOutside != 0) {
    std::cerr << arguments.strokes << ": "
              << (strokesOutside == 1
                      ? "one stroke lies outside of its image"
                      : std::to_string(strokesOutside) + " strokes lie outside of their images")
              << "\n";
  }
  if (made.reducedCells != 0) {
    std::cerr << arguments.out << ": of " << made.reducedCells
              << " cells of several classes only the best is kept, since a .c64 has room for several classes "
                 "with numbers up to "
              << ColorTableFile::kMostOfSeveral << "\n";
  }
  return strokesOutside != 0 || made.reducedCells != 0 ? kDoneWithLosses : kDone;
}

int run(const TrainArguments& arguments) {
  const auto strokes = colortool::readStrokeList(arguments.strokes);
  if (!strokes) return printErrors(strokes.error());
  auto known = chosenClasses(arguments.classes);
  if (!known) return printErrors({known.error()});
  const auto classes = classesOf(*strokes, *known, arguments.strokes);
  if (!classes) return printErrors(classes.error());
  const auto images = ColorImages::open(arguments.images);
  if (!images) return printErrors({images.error()});

  ColorVotes votes(known->size(), arguments.options);
  std::map<std::string, colortool::ColorImage> loaded;
  int outside = 0;
  for (const DiscStroke& stroke : *strokes) {
    auto image = loaded.find(stroke.image);
    if (image == loaded.end()) {
      auto read = images->load(stroke.image);
      if (!read) return printErrors({read.error()});
      image = loaded.emplace(stroke.image, std::move(*read)).first;
    }
    if (!add(stroke, image->second, classes->at(stroke.colorClass), votes)) ++outside;
  }
  const auto made = tableOf(arguments, votes);
  const colortool::NamedColorTable table{made.file, std::move(*known)};
  if (const auto saved = table.save(arguments.out); !saved) return printErrors({saved.error()});
  std::cout << arguments.out << ": " << strokes->size() << " strokes in " << loaded.size() << " images\n";
  return tellLosses(arguments, outside, made);
}

}  // namespace

void addColorTrainCommand(CLI::App& color, int& status) {
  auto arguments = std::make_shared<TrainArguments>();
  CLI::App* command = color.add_subcommand("train", "Makes a colour table from strokes in images");
  command
      ->add_option("--strokes", arguments->strokes,
                   "CSV with the header image,class,x,y,radius; in pixels of the image at a width of 320; "
                   "class background is none of them")
      ->required();
  command
      ->add_option("--images", arguments->images,
                   "The folder of the images (PNG, JPEG, .yuyv), or a log file")
      ->required();
  command->add_option("--out", arguments->out, "The colour table (.c64)")->required();
  addClassesOption(*command, arguments->classes,
                   "Names of the classes, in the order of their numbers; they are written beside the table");
  command
      ->add_option(
          "--method", arguments->method,
          "kernel: samples vote around them; gauss: one Gaussian per class; svm: a support vector machine")
      ->check(CLI::IsMember({kKernel, kGauss, kSupportVectors}))
      ->capture_default_str();
  auto& options = arguments->options;
  using Options = colortool::VoteOptions;
  command
      ->add_option("--radius", options.radius,
                   "How far a sample reaches in Cb and Cr: one standard deviation")
      ->check(CLI::Range(Options::kLeastRadius, Options::kMostRadius))
      ->capture_default_str();
  command
      ->add_option("--y-weight", options.brightnessWeight,
                   "What a difference in Y counts against one in Cb or Cr")
      ->check(CLI::Range(Options::kLeastBrightnessWeight, 1.0))
      ->capture_default_str();
  command
      ->add_option("--rejection", options.rejection,
                   "What a class needs at least, as a share of one sample's own vote")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--background-weight", options.backgroundWeight,
                   "What a sample of the background counts against one of a class")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command
      ->add_option("--reject-distance", arguments->gauss.mostSquaredDistance,
                   "gauss: squared Mahalanobis distance from a class past which a colour is not of it")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--several", arguments->several,
                   "kernel: a cell keeps all classes that have this share of the best one's votes")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--cost", arguments->supportVectors.cost, "svm: what a sample on the wrong side costs")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--gamma", arguments->supportVectors.gamma, "svm: of its radial basis functions")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--reject-radius", arguments->supportVectors.mostDistance,
                   "svm: how far from a sample a class reaches at most")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace app
