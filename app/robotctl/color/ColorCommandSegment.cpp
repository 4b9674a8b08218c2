// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl color segment`.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/robotctl/Commands.h"
#include "app/robotctl/color/ColorImages.h"
#include "app/robotctl/color/ColorSubcommands.h"
#include "colortool/image/ClassPresets.h"
#include "logplayer/base/Plural.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

using robotlink::Image;
using robotlink::Result;

struct SegmentArguments {
  std::string table, images, out;
  ClassNames classes;
  bool numbers = false;
};

/// An image with the class number of each pixel.
Image classImage(const colortool::ColorImage& image, const colortool::ColorTable& table) {
  Image classes(image.width, image.height, robotlink::PixelFormat::kMono8);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) classes.data[i] = table.classOf(image.pixels[i]);
  return classes;
}

Result<void> writeImage(const Image& image, const std::filesystem::path& to) {
  const auto png = logplayer::encodePng(image.view());
  if (!png) return tl::unexpected(png.error());
  return robotlink::writeFileAtomically(
      to, std::string_view(reinterpret_cast<const char*>(png->data()), png->size()));
}

/// Writes the names of the classes beside images of class numbers, unless they are the default ones.
Result<void> writeClasses(const colortool::ColorClasses& classes, const std::filesystem::path& folder) {
  if (classes == chosenClasses({}).value()) return {};
  return robotlink::writeFileAtomically(folder / kLabelClassesFile, colorClassesText(classes));
}

int segment(const SegmentArguments& arguments) {
  const auto named = loadTable(arguments.table, arguments.classes);
  if (!named) return printErrors(named.error());
  const auto images = ColorImages::open(arguments.images);
  if (!images) return printErrors({images.error()});
  const std::filesystem::path folder = arguments.out;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return printErrors(
        {{"file.io", "cannot make the folder: " + error.message(), {}, {arguments.out, 0, 0}}});
  const colortool::ColorTable table = singleTable(named->file);
  for (const std::string& name : images->names()) {
    const auto image = images->load(name);
    if (!image) return printErrors({image.error()});
    const Image classes = classImage(*image, table);
    const auto done = writeImage(arguments.numbers ? classes : shownImage(classes.view(), named->classes),
                                 folder / (std::filesystem::path(name).stem().string() + ".png"));
    if (!done) return printErrors({done.error()});
  }
  if (arguments.numbers) {
    if (const auto done = writeClasses(named->classes, folder); !done) return printErrors({done.error()});
  }
  std::cout << arguments.out << ": " << logplayer::plural(images->names().size(), "image") << "\n";
  return kDone;
}

}  // namespace

void addColorSegmentCommand(CLI::App& color, int& status) {
  auto arguments = std::make_shared<SegmentArguments>();
  CLI::App* command = color.add_subcommand("segment", "Writes images classified by a color table, as PNG");
  command->add_option("--table", arguments->table, "A color table (.c64)")->required();
  command->add_option("--images", arguments->images, "A folder of images (PNG, JPEG, .yuyv), or a log file")
      ->required();
  command->add_option("--out", arguments->out, "The folder for the pictures")->required();
  addClassesOption(
      *command, arguments->classes,
      "Names of the classes, in the order of their numbers, if not from the file next to the table");
  command->add_flag("--numbers", arguments->numbers,
                    "Gray pictures with the classes' numbers, in the format of labels");
  command->callback([arguments, &status] { status = segment(*arguments); });
}

}  // namespace app
