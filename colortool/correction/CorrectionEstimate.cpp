// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/correction/CorrectionEstimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "colortool/correction/RadialFit.h"

namespace colortool {
namespace {

/// Number of fields in each direction into which an image is divided. The pixels of a stroke in one field
/// form one sample, since they are too similar to count individually.
constexpr int kFields = 8;
/// A sample that covers at least this share of its field has weight 1; a smaller stroke has this weight in
/// total.
constexpr double kFullShare = 0.25;
/// The range of Y that is neither clipped nor too coarse.
constexpr int kDarkestY = 8, kBrightestY = 247;

constexpr std::size_t kMinClasses = 3;
/// A gain is found only if a channel's means differ by at least this between the classes.
constexpr double kMinSpread = 10;
/// The standard deviations that a class's mean (in values of a channel) and a gain are expected to have.
constexpr double kMeanError = 2, kTypicalGain = 0.2;
constexpr double kMinGain = 0.5, kMaxGain = 2, kMaxOffset = 100;
constexpr std::array kChannels = {"Y", "Cb", "Cr"};

/// Colors are compared within a class and a lighting.
using Kind = std::pair<std::uint8_t, std::string>;

/// The pixels of a stroke in one field of its image.
struct Patch {
  Kind kind;
  double pixels = 0, weight = 0, squaredRadius = 0;
  /// Number and mean log Y of the pixels that are neither too dark nor too bright.
  double usable = 0, logarithm = 0;
  std::array<double, 3> values{};  ///< Mean Y, Cb, Cr.
};

struct Camera {
  std::string name;
  std::size_t strokes = 0;
  std::vector<Patch> patches;
  ColorCorrection correction;
};

void addPatches(Camera& camera, const SampleImage& image, const Stroke& stroke) {
  std::map<int, Patch> fields;
  auto color = stroke.colors.begin();
  for (const PixelRun& run : stroke.area) {
    for (int x = run.begin; x < run.end && color != stroke.colors.end(); ++x, ++color) {
      Patch& patch = fields[run.y * kFields / image.height * kFields + x * kFields / image.width];
      patch.pixels += 1;
      patch.squaredRadius += squaredImageRadius(x, run.y, image.width, image.height);
      if (color->y >= kDarkestY && color->y <= kBrightestY) {
        patch.usable += 1;
        patch.logarithm += std::log(color->y);
      }
      patch.values[0] += color->y;
      patch.values[1] += color->cb;
      patch.values[2] += color->cr;
    }
  }
  const double whole = std::min(static_cast<double>(stroke.colors.size()),
                                kFullShare * image.width * image.height / (kFields * kFields));
  for (auto& [field, patch] : fields) {
    patch.weight = std::min(1.0, patch.pixels / whole);
    patch.kind = {stroke.colorClass, image.lighting};
    patch.squaredRadius /= patch.pixels;
    if (patch.usable > 0) patch.logarithm /= patch.usable;
    for (double& value : patch.values) value /= patch.pixels;
    camera.patches.push_back(std::move(patch));
  }
}

std::vector<Camera> camerasOf(const Samples& samples) {
  std::vector<Camera> cameras;
  for (const SampleImage& image : samples.images) {
    if (std::ranges::find(cameras, image.camera, &Camera::name) == cameras.end())
      cameras.push_back({image.camera, 0, {}, {}});
  }
  for (const StrokePtr& stroke : samples.strokes) {
    const SampleImage* image = samples.image(stroke->image);
    if (stroke->mustNotBe || stroke->colorClass == ColorClasses::kNone || image == nullptr) continue;
    if (image->width <= 0 || image->height <= 0) continue;
    Camera& camera = *std::ranges::find(cameras, image->camera, &Camera::name);
    ++camera.strokes;
    addPatches(camera, *image, *stroke);
  }
  return cameras;
}

std::string cameraNameOf(const Camera& camera) {
  return camera.name.empty() ? "The camera" : "Camera " + camera.name;
}

/// The samples of a channel: 0 is Y, 1 is Cb, 2 is Cr.
std::vector<RadialSample> radialSamples(const std::vector<Patch>& patches, std::size_t channel) {
  std::map<Kind, std::size_t> groups;
  std::vector<RadialSample> samples;
  for (const Patch& patch : patches) {
    if (channel == 0 && patch.usable * 2 < patch.pixels) continue;
    const std::size_t group = groups.try_emplace(patch.kind, groups.size()).first->second;
    samples.push_back(
        {group, patch.squaredRadius, channel == 0 ? patch.logarithm : patch.values[channel], patch.weight});
  }
  return samples;
}

void estimateVignetting(Camera& camera, std::vector<std::string>& notes) {
  using Outcome = RadialFit::Outcome;
  const RadialFit luma = fitRadial(radialSamples(camera.patches, 0), RadialModel::kShade),
                  blue = fitRadial(radialSamples(camera.patches, 1), RadialModel::kTint),
                  red = fitRadial(radialSamples(camera.patches, 2), RadialModel::kTint);
  camera.correction.vignetting = {luma.coefficients, blue.coefficients, red.coefficients};
  if (blue.outcome == Outcome::kTooNarrow) {
    notes.push_back(cameraNameOf(camera) +
                    ": no vignetting is estimated; for that, make strokes of the same class in the middle of "
                    "the image and toward its corners.");
    return;
  }
  const auto atCorner = [](const RadialFit& fit) { return fit.coefficients[0] + fit.coefficients[1]; };
  if (camera.correction.none()) {
    notes.push_back(cameraNameOf(camera) + ": the corners of its images are like their center.");
    return;
  }
  notes.push_back(
      fmt::format("{}: in the corners Y is {:.0f} % of what it is in the middle, Cb differs by {:+.1f} and "
                  "Cr by {:+.1f}.",
                  cameraNameOf(camera), 100 * (1 + atCorner(luma)), atCorner(blue), atCorner(red)));
}

/// The mean color of a kind as a camera sees it without vignetting, and its accuracy.
struct KindMean {
  double weight = 0;
  std::array<double, 3> values{};
};
std::map<Kind, KindMean> meansOf(const Camera& camera) {
  ColorCorrection flat;
  flat.vignetting = camera.correction.vignetting;
  std::map<Kind, KindMean> means;
  for (const Patch& patch : camera.patches) {
    const double r2 = patch.squaredRadius;
    const std::array lines = {flat.lumaAt(r2), flat.blueAt(r2), flat.redAt(r2)};
    KindMean& mean = means[patch.kind];
    mean.weight += patch.weight;
    for (std::size_t i = 0; i < 3; ++i) mean.values[i] += patch.weight * lines[i].of(patch.values[i]);
  }
  for (auto& [kind, mean] : means) {
    for (double& value : mean.values) value /= mean.weight;
  }
  return means;
}

/// The same kind seen by both cameras, in one channel.
struct Pair {
  double weight, own, reference;
};

/// A least squares fit with a prior for a gain of 1.
ChannelLine lineThrough(const std::vector<Pair>& pairs, bool withGain) {
  double weight = 0, own = 0, reference = 0;
  for (const Pair& pair : pairs) {
    weight += pair.weight;
    own += pair.weight * pair.own;
    reference += pair.weight * pair.reference;
  }
  own /= weight;
  reference /= weight;
  double square = 0, product = 0;
  for (const Pair& pair : pairs) {
    const double off = pair.own - own;
    square += pair.weight * off * off;
    product += pair.weight * off * (pair.reference - reference - off);
  }
  ChannelLine line;
  if (withGain && square >= weight * kMinSpread * kMinSpread) {
    const double prior = kMeanError * kMeanError / (kTypicalGain * kTypicalGain);
    line.gain = std::clamp(1 + product / (square + prior), kMinGain, kMaxGain);
  }
  line.offset = std::clamp(reference - line.gain * own, -kMaxOffset, kMaxOffset);
  return line;
}

void estimateLines(Camera& camera, const Camera& reference, std::vector<std::string>& notes) {
  const auto own = meansOf(camera), others = meansOf(reference);
  std::array<std::vector<Pair>, 3> pairs;
  std::set<std::uint8_t> classes;
  for (const auto& [kind, mean] : own) {
    const auto other = others.find(kind);
    if (other == others.end()) continue;
    classes.insert(kind.first);
    const double weight = mean.weight * other->second.weight / (mean.weight + other->second.weight);
    for (std::size_t i = 0; i < 3; ++i) pairs[i].push_back({weight, mean.values[i], other->second.values[i]});
  }
  if (classes.empty()) {
    notes.push_back(cameraNameOf(camera) + ": cannot be compared with " + reference.name +
                    "; for that, make strokes of the same class and lighting in images of both.");
    return;
  }
  std::string note = cameraNameOf(camera) + ": to be like " + reference.name;
  for (std::size_t i = 0; i < 3; ++i) {
    ChannelLine& line = camera.correction.channels[i];
    line = lineThrough(pairs[i], classes.size() >= kMinClasses);
    note += fmt::format("{} {} x {:.2f} {:+.1f}", i == 0 ? "," : ";", kChannels[i], line.gain, line.offset);
  }
  if (classes.size() < kMinClasses)
    note += " (with strokes of three classes in both, gains can be estimated)";
  notes.push_back(note + ".");
}

}  // namespace

CorrectionEstimate estimateCorrections(const Samples& samples) {
  CorrectionEstimate estimate;
  std::vector<Camera> cameras = camerasOf(samples);
  std::erase_if(cameras, [](const Camera& camera) { return camera.strokes == 0; });
  if (cameras.empty()) {
    estimate.notes.emplace_back("There are no strokes of a color class yet: nothing is estimated.");
    return estimate;
  }
  for (Camera& camera : cameras) estimateVignetting(camera, estimate.notes);
  const auto reference = std::ranges::max_element(cameras, {}, &Camera::strokes);
  for (auto camera = cameras.begin(); camera != cameras.end(); ++camera) {
    if (camera != reference) estimateLines(*camera, *reference, estimate.notes);
  }
  for (const Camera& camera : cameras) {
    if (!camera.correction.none()) estimate.corrections.push_back({camera.name, camera.correction});
  }
  return estimate;
}

}  // namespace colortool
