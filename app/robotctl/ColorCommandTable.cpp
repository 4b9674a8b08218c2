// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with tables alone, or with a table and images.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/robotctl/ColorCommands.h"
#include "app/robotctl/ColorImages.h"
#include "app/robotctl/Commands.h"
#include "logplayer/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

using colortool::ColorTableFile;
using robotlink::Result;

struct TableArguments {
  std::string table, other, images, out;
  ClassNames classes = defaultClassNames();
  bool json = false;
  bool numbers = false;
};

/// The cells of each class, those of several under all their names: "orange+red".
std::map<std::string, std::uint64_t> cellCounts(const ColorTableFile& file, const ClassNames& names) {
  std::map<std::uint8_t, std::uint64_t> counts;
  for (const std::uint8_t cell : file.cells) ++counts[cell];
  std::map<std::string, std::uint64_t> named;
  for (const auto& [cell, count] : counts) {
    std::string name = className(names, cell);
    if ((cell & ColorTableFile::kSeveral) != 0) {
      name.clear();
      for (int bit = 0; bit < 7; ++bit) {
        if ((cell >> bit & 1) != 0) name += (name.empty() ? "" : "+") + className(names, bit + 1);
      }
    }
    named[name] += count;
  }
  return named;
}

int info(const TableArguments& arguments) {
  const auto file = ColorTableFile::load(arguments.table);
  if (!file) return printErrors({file.error()});
  const auto counts = cellCounts(*file, arguments.classes);
  if (arguments.json) {
    std::cout << nlohmann::ordered_json{{"file", arguments.table}, {"cells", counts}}.dump(2) << "\n";
    return kDone;
  }
  for (const auto& [name, count] : counts) {
    std::printf("%-24s %7llu cells %6.2f %%\n", name.c_str(), static_cast<unsigned long long>(count),
                100 * static_cast<double>(count) / static_cast<double>(ColorTableFile::kCellCount));
  }
  return kDone;
}

int diff(const TableArguments& arguments) {
  const auto first = ColorTableFile::load(arguments.table), second = ColorTableFile::load(arguments.other);
  if (!first) return printErrors({first.error()});
  if (!second) return printErrors({second.error()});
  const auto before = first->singleClasses(), after = second->singleClasses();
  std::map<std::pair<std::uint8_t, std::uint8_t>, std::uint64_t> changes;
  std::uint64_t changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) continue;
    ++changes[{before[i], after[i]}];
    ++changed;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [classes, count] : changes) {
    const std::string from = className(arguments.classes, classes.first),
                      to = className(arguments.classes, classes.second);
    if (arguments.json)
      list.push_back({{"from", from}, {"to", to}, {"cells", count}});
    else
      std::printf("%-12s -> %-12s %7llu cells\n", from.c_str(), to.c_str(),
                  static_cast<unsigned long long>(count));
  }
  if (arguments.json)
    std::cout << nlohmann::ordered_json{{"changed", changed}, {"changes", list}}.dump(2) << "\n";
  else
    std::printf("%llu of %zu cells differ\n", static_cast<unsigned long long>(changed), before.size());
  return kDone;
}

/// What a class is shown in.
robotlink::Rgb shownColor(const std::string& name) {
  static const std::map<std::string, robotlink::Rgb> colors = {
      {"orange", {255, 128, 0}},  {"yellow", {255, 230, 0}},   {"blue", {0, 80, 255}},
      {"white", {255, 255, 255}}, {"green", {0, 160, 40}},     {"black", {40, 40, 40}},
      {"red", {220, 0, 0}},       {"robotBlue", {0, 200, 255}}};
  const auto found = colors.find(name);
  return found == colors.end() ? robotlink::Rgb{128, 0, 128} : found->second;
}

Result<void> segment(const colortool::ColorImage& image, const colortool::ColorTable& table,
                     const TableArguments& arguments, const std::filesystem::path& to) {
  using robotlink::PixelFormat;
  robotlink::Image shown(image.width, image.height,
                         arguments.numbers ? PixelFormat::kMono8 : PixelFormat::kRgb8);
  std::array<robotlink::Rgb, 256> colors{};
  for (int i = 1; i < 256; ++i)
    colors[static_cast<std::size_t>(i)] = shownColor(className(arguments.classes, i));
  std::uint8_t* out = shown.data.data();
  for (const robotlink::YCbCr& pixel : image.pixels) {
    const std::uint8_t colorClass = table.classOf(pixel);
    if (arguments.numbers) {
      *out++ = colorClass;
      continue;
    }
    const robotlink::Rgb color = colors[colorClass];
    *out++ = color.r;
    *out++ = color.g;
    *out++ = color.b;
  }
  const auto png = logplayer::encodePng(shown.view());
  if (!png) return tl::unexpected(png.error());
  return robotlink::writeFileAtomically(
      to, std::string_view(reinterpret_cast<const char*>(png->data()), png->size()));
}

int segmentAll(const TableArguments& arguments) {
  const auto file = ColorTableFile::load(arguments.table);
  if (!file) return printErrors({file.error()});
  const auto images = ColorImages::open(arguments.images);
  if (!images) return printErrors({images.error()});
  std::error_code error;
  std::filesystem::create_directories(arguments.out, error);
  if (error)
    return printErrors(
        {{"file.io", "cannot make the folder: " + error.message(), {}, {arguments.out, 0, 0}}});
  const colortool::ColorTable table = singleTable(*file);
  for (const std::string& name : images->names()) {
    const auto image = images->load(name);
    if (!image) return printErrors({image.error()});
    const auto to =
        std::filesystem::path(arguments.out) / (std::filesystem::path(name).stem().string() + ".png");
    if (const auto done = segment(*image, table, arguments, to); !done) return printErrors({done.error()});
  }
  std::cout << arguments.out << ": " << images->names().size() << " images\n";
  return kDone;
}

}  // namespace

void addColorTableCommands(CLI::App& color, int& status) {
  auto arguments = std::make_shared<TableArguments>();
  const auto add = [&](const char* name, const char* help, int (*run)(const TableArguments&)) {
    CLI::App* command = color.add_subcommand(name, help);
    command
        ->add_option("--classes", arguments->classes,
                     "Names of the classes, in the order of their numbers, instead of the usual ones")
        ->delimiter(',');
    command->callback([arguments, &status, run] { status = run(*arguments); });
    return command;
  };
  CLI::App* infos = add("info", "Says how many cells of a colour table are of which class", info);
  infos->add_option("table", arguments->table, "A colour table (.c64)")->required();
  infos->add_flag("--json", arguments->json, "Prints JSON");
  CLI::App* differences = add("diff", "Says which cells of two colour tables differ", diff);
  differences->add_option("before", arguments->table, "A colour table (.c64)")->required();
  differences->add_option("after", arguments->other, "Another one")->required();
  differences->add_flag("--json", arguments->json, "Prints JSON");
  CLI::App* segments = add("segment", "Writes what a colour table makes of images, as PNG", segmentAll);
  segments->add_option("--table", arguments->table, "A colour table (.c64)")->required();
  segments->add_option("--images", arguments->images, "A folder of images (PNG, JPEG, .yuyv), or a log file")
      ->required();
  segments->add_option("--out", arguments->out, "The folder for the pictures")->required();
  segments->add_flag("--numbers", arguments->numbers,
                     "Grey pictures with the classes' numbers, as labels have them");
}

}  // namespace app
