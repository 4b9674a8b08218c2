// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/Samples.h"

#include <algorithm>
#include <map>
#include <set>

namespace colortool {
namespace {

/// A picture of the area's bounding box with the same amount of surroundings, reduced by skipping pixels.
Thumbnail thumbnailOf(const ColorImage& image, const PixelArea& area) {
  int left = image.width, right = 0;
  for (const PixelRun& run : area) {
    left = std::min(left, run.begin);
    right = std::max(right, run.end);
  }
  const int top = area.front().y, bottom = area.back().y + 1;
  const int side = std::max({2 * (right - left), 2 * (bottom - top), 16});
  const int width = std::min(side, image.width), height = std::min(side, image.height);
  const int x0 = std::clamp((left + right - width) / 2, 0, image.width - width);
  const int y0 = std::clamp((top + bottom - height) / 2, 0, image.height - height);
  const double step = std::max(1.0, std::max(width, height) / static_cast<double>(Thumbnail::kMaxSide));
  Thumbnail result;
  result.width = std::clamp(static_cast<int>(width / step), 1, Thumbnail::kMaxSide);
  result.height = std::clamp(static_cast<int>(height / step), 1, Thumbnail::kMaxSide);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const int fromX = std::min(x0 + static_cast<int>((x + 0.5) * step), image.width - 1),
                fromY = std::min(y0 + static_cast<int>((y + 0.5) * step), image.height - 1);
      result.pixels.push_back(robotlink::toRgb(image.at(fromX, fromY)));
    }
  }
  return result;
}

std::uint64_t lastId(const Samples& samples) {
  return samples.strokes.empty() ? 0 : samples.strokes.back()->id;
}

/// The id of an image with equal properties; it is added if there is none.
std::uint64_t imageLike(Samples& samples, const SampleImage& where) {
  std::uint64_t last = 0;
  for (const SampleImage& known : samples.images) {
    SampleImage same = where;
    same.id = known.id;
    same.lighting = known.lighting;
    if (same == known) return known.id;
    last = std::max(last, known.id);
  }
  samples.images.push_back(where);
  samples.images.back().id = last + 1;
  return last + 1;
}

/// The stroke without the area; null if nothing remains.
StrokePtr strokeWithout(const StrokePtr& stroke, const PixelArea& area) {
  auto rest = std::make_shared<Stroke>(*stroke);
  rest->area = colortool::without(stroke->area, area);
  if (rest->area == stroke->area) return stroke;
  if (rest->area.empty()) return nullptr;
  rest->colors.clear();
  auto color = stroke->colors.begin();
  for (const PixelRun& run : stroke->area) {
    for (int x = run.begin; x < run.end; ++x, ++color) {
      if (contains(rest->area, x, run.y)) rest->colors.push_back(*color);
    }
  }
  return rest;
}

void removeUnusedImages(Samples& samples) {
  std::set<std::uint64_t> used;
  for (const StrokePtr& stroke : samples.strokes) used.insert(stroke->image);
  std::erase_if(samples.images, [&](const SampleImage& image) { return !used.contains(image.id); });
}

/// Replaces the strokes with these ids by copies that `change` modifies.
template <typename Change>
void replace(Samples& samples, const std::vector<std::uint64_t>& ids, const Change& change) {
  for (StrokePtr& stroke : samples.strokes) {
    if (std::ranges::find(ids, stroke->id) == ids.end()) continue;
    auto changed = std::make_shared<Stroke>(*stroke);
    change(*changed);
    stroke = std::move(changed);
  }
}

}  // namespace

const SampleImage* Samples::image(std::uint64_t id) const {
  const auto found = std::ranges::find(images, id, &SampleImage::id);
  return found == images.end() ? nullptr : &*found;
}

ColorCorrection Samples::correctionOf(const std::string& camera) const {
  const auto found = std::ranges::find(corrections, camera, &CameraCorrection::camera);
  if (found == corrections.end()) return {};
  ColorCorrection correction = found->correction;
  if (!settings.correctVignetting) correction.vignetting = {};
  if (!settings.correctCameras) correction.channels = {};
  return correction;
}

bool Samples::operator==(const Samples& other) const {
  return classes == other.classes && settings == other.settings && corrections == other.corrections &&
         images == other.images &&
         std::ranges::equal(strokes, other.strokes,
                            [](const StrokePtr& a, const StrokePtr& b) { return a == b || *a == *b; });
}

std::uint64_t addStroke(Samples& samples, const SampleImage& where, const ColorImage& image,
                        const PixelArea& area, const StrokeMeaning& meaning) {
  if (area.empty() || !isValid(area, image.width, image.height)) return 0;
  auto stroke = std::make_shared<Stroke>();
  stroke->id = lastId(samples) + 1;
  SampleImage place = where;
  place.width = image.width;
  place.height = image.height;
  stroke->image = imageLike(samples, place);
  stroke->colorClass = meaning.colorClass;
  stroke->mustNotBe = meaning.mustNotBe;
  stroke->weight = std::clamp(meaning.weight, Stroke::kMinWeight, Stroke::kMaxWeight);
  stroke->tool = meaning.tool;
  stroke->area = area;
  for (const PixelRun& run : area) {
    for (int x = run.begin; x < run.end; ++x) stroke->colors.push_back(image.at(x, run.y));
  }
  stroke->thumbnail = thumbnailOf(image, area);
  samples.strokes.push_back(std::move(stroke));
  return samples.strokes.back()->id;
}

bool erase(Samples& samples, const SampleImage& where, const PixelArea& area) {
  bool changed = false;
  for (StrokePtr& stroke : samples.strokes) {
    const SampleImage* image = samples.image(stroke->image);
    if (image == nullptr || image->name != where.name || image->camera != where.camera) continue;
    StrokePtr rest = strokeWithout(stroke, area);
    changed = changed || rest != stroke;
    stroke = std::move(rest);
  }
  std::erase(samples.strokes, nullptr);
  removeUnusedImages(samples);
  return changed;
}

void erasePart(Samples& samples, std::uint64_t id, const PixelArea& area) {
  for (StrokePtr& stroke : samples.strokes) {
    if (stroke->id == id) stroke = strokeWithout(stroke, area);
  }
  std::erase(samples.strokes, nullptr);
  removeUnusedImages(samples);
}

void removeStrokes(Samples& samples, const std::vector<std::uint64_t>& ids) {
  std::erase_if(samples.strokes,
                [&](const StrokePtr& stroke) { return std::ranges::find(ids, stroke->id) != ids.end(); });
  removeUnusedImages(samples);
}

void restate(Samples& samples, const std::vector<std::uint64_t>& ids, const StrokeMeaning& meaning) {
  replace(samples, ids, [&](Stroke& stroke) {
    stroke.colorClass = meaning.colorClass;
    stroke.mustNotBe = meaning.mustNotBe;
    stroke.weight = std::clamp(meaning.weight, Stroke::kMinWeight, Stroke::kMaxWeight);
  });
}

void changeClasses(Samples& samples, ColorClasses classes, const std::vector<std::uint8_t>& newNumbers) {
  const auto newNumber = [&](std::uint8_t old) {
    return old < newNumbers.size() ? newNumbers[old] : ColorClasses::kNone;
  };
  std::erase_if(samples.strokes, [&](const StrokePtr& stroke) {
    return stroke->colorClass != ColorClasses::kNone && newNumber(stroke->colorClass) == ColorClasses::kNone;
  });
  std::vector<std::uint64_t> moved;
  for (const StrokePtr& stroke : samples.strokes) {
    if (newNumber(stroke->colorClass) != stroke->colorClass) moved.push_back(stroke->id);
  }
  replace(samples, moved, [&](Stroke& stroke) { stroke.colorClass = newNumber(stroke.colorClass); });
  samples.classes = std::move(classes);
  removeUnusedImages(samples);
}

void merge(Samples& samples, const Samples& other) {
  std::vector<NamedColor> classes;
  for (int i = 1; i < samples.classes.size(); ++i)
    classes.push_back({samples.classes.name(i), samples.classes.shownColor(i)});
  for (int i = 1; i < other.classes.size() && classes.size() < 255; ++i) {
    if (samples.classes.index(other.classes.name(i)) == ColorClasses::kNone)
      classes.push_back({other.classes.name(i), other.classes.shownColor(i)});
  }
  samples.classes = ColorClasses(std::move(classes));
  for (const CameraCorrection& correction : other.corrections) {
    if (std::ranges::find(samples.corrections, correction.camera, &CameraCorrection::camera) ==
        samples.corrections.end())
      samples.corrections.push_back(correction);
  }
  std::map<std::uint64_t, std::uint64_t> imageIds;
  for (const SampleImage& image : other.images) imageIds[image.id] = imageLike(samples, image);
  std::uint64_t id = lastId(samples);
  const std::size_t own = samples.strokes.size();
  for (const StrokePtr& stroke : other.strokes) {
    auto copy = std::make_shared<Stroke>(*stroke);
    copy->image = imageIds[stroke->image];
    if (stroke->colorClass != ColorClasses::kNone) {
      copy->colorClass = samples.classes.index(other.classes.name(stroke->colorClass));
      if (copy->colorClass == ColorClasses::kNone) continue;
    }
    const bool known =
        std::any_of(samples.strokes.begin(), samples.strokes.begin() + static_cast<std::ptrdiff_t>(own),
                    [&](const StrokePtr& mine) {
                      copy->id = mine->id;
                      return *mine == *copy;
                    });
    if (known) continue;
    copy->id = ++id;
    samples.strokes.push_back(std::move(copy));
  }
  removeUnusedImages(samples);
}

}  // namespace colortool
