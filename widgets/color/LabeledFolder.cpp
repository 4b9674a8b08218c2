// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/LabeledFolder.h"

#include <algorithm>
#include <map>
#include <utility>

#include "colortool/image/ClassPresets.h"
#include "colortool/table/NamedColorTable.h"
#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "logplayer/images/PictureFile.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/packages/Conversions.h"

namespace widgets {
namespace {

namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Image;
using robotlink::Result;

constexpr const char* kNamesFile = "labels.classes";

std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    files.push_back(entry->path());
  std::ranges::sort(files);
  return files;
}

fs::path labelFolder(const fs::path& folder) {
  std::error_code error;
  for (const fs::path& candidate : {folder / "labels", folder.parent_path() / "labels"}) {
    if (fs::is_directory(candidate, error)) return candidate;
  }
  return folder;
}

/// Images of a folder and its subfolders, by their base names; the first of a name counts.
std::map<std::string, fs::path> imagesIn(const fs::path& folder, const fs::path& labels) {
  std::map<std::string, fs::path> images;
  const auto add = [&images, &labels](const fs::path& file) {
    const bool isLabel = robotlink::fileSuffix(file) == ".png" && file.parent_path() == labels;
    if (!isLabel && logplayer::isPictureFile(file)) images.try_emplace(file.stem().string(), file);
  };
  for (const fs::path& file : filesOf(folder)) {
    std::error_code error;
    if (!fs::is_directory(file, error)) {
      add(file);
    } else if (file != labels) {
      for (const fs::path& inside : filesOf(file)) add(inside);
    }
  }
  return images;
}

/// The labels of an image's pixels. In a .yuyv file two pixels share a label, which is given to the second
/// one.
Result<std::vector<std::uint8_t>> labelsFor(const Image& image, const fs::path& file, bool yuyv) {
  const auto labels = logplayer::readPicture(file, logplayer::YuyvPixels::kAll);
  if (!labels) return tl::unexpected(labels.error());
  const int step = yuyv ? 2 : 1;
  if (labels->format != robotlink::PixelFormat::kMono8)
    return failure("image.labels", "labels are a gray PNG with the classes' numbers; this one has colors",
                   {file.string()});
  if (labels->width * step != image.width || labels->height != image.height)
    return failure("image.labels", "the labels differ in size from their image", {file.string()});
  std::vector<std::uint8_t> result(
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
      colortool::Evaluation::kIgnored);
  std::size_t at = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < labels->width; ++x, at += static_cast<std::size_t>(step))
      result[at + static_cast<std::size_t>(step) - 1] = labels->row(y)[x];
  }
  return result;
}

Result<std::vector<std::string>> namesOf(const fs::path& labels) {
  colortool::ColorClasses classes = colortool::findClassPreset("bhuman2009")->classes();
  std::error_code error;
  if (const fs::path file = labels / kNamesFile; fs::exists(file, error)) {
    const auto text = robotlink::readFile(file);
    if (!text) return tl::unexpected(text.error());
    const auto named = colortool::parseColorClasses(*text, file.string());
    if (!named) return failure(named.error().front().id, robotlink::describe(named.error()));
    classes = *named;
  }
  std::vector<std::string> names = classes.names();
  names.insert(names.begin(), "none");
  return names;
}

}  // namespace

LabeledFolder::LabeledFolder(fs::path folder, std::string camera)
    : camera_(std::move(camera)), worker_([this](const fs::path& chosen, const std::stop_token& stop) {
        worker_.publish(readAll(chosen, stop));
      }) {
  worker_.post(std::move(folder));
}

Result<LabeledFolder::Read> LabeledFolder::readAll(const fs::path& chosen, const std::stop_token& stop) {
  std::error_code none;
  if (!fs::is_directory(chosen, none))
    return failure("image.labels", "there is no such folder", {chosen.string(), 0, 0});
  const fs::path given = chosen.has_filename() ? chosen : chosen.parent_path();
  const bool isLabels = given.filename() == "labels";
  const fs::path folder = isLabels ? given.parent_path() : given;
  const fs::path labels = isLabels ? given : labelFolder(folder);
  const auto names = namesOf(labels);
  if (!names) return tl::unexpected(names.error());
  const auto images = imagesIn(folder, labels);
  Read read;
  std::size_t done = 0;
  for (const auto& [name, file] : images) {
    if (stop.stop_requested()) break;
    progress_ = static_cast<double>(done++) / static_cast<double>(images.size());
    const fs::path label = labels / (name + ".png");
    std::error_code error;
    if (!fs::exists(label, error)) continue;
    const auto image = logplayer::readPicture(file, logplayer::YuyvPixels::kAll);
    auto values = image ? labelsFor(*image, label, robotlink::fileSuffix(file) == ".yuyv")
                        : tl::unexpected(image.error());
    if (!values) {
      read.problems.push_back(values.error());
      continue;
    }
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, image->view(), {}, "camera");
    const std::string stream = (camera_.empty() ? "file" : camera_) + "/" + name;
    read.frames.push_back({std::make_shared<ColorFrame>(message, stream, file.string(), robotlink::Instant{}),
                           std::move(*values), *names});
  }
  if (!read.frames.empty()) return read;
  // A PNG in the folder itself counts as an image without labels, not as labels without an image.
  const std::size_t count = imagesIn(folder, {}).size();
  return failure(
      "image.labels",
      !read.problems.empty() ? robotlink::describe(read.problems)
      : count == 0
          ? "there are no images here. Choose the folder that contains the images, with a folder \"labels\" "
            "inside it or next to it, or that folder of labels itself"
          : (count == 1 ? "the only image here has no labels"
                        : "none of the " + std::to_string(count) + " images here has labels") +
                std::string(": a gray PNG of the same name in a folder \"labels\" inside of this one "
                            "or beside it"),
      {chosen.string()});
}

}  // namespace widgets
