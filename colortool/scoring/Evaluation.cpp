// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/Evaluation.h"

#include <algorithm>
#include <numeric>

namespace colortool {
namespace {

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Evaluation::Evaluation(int classes)
    : classes_(std::clamp(classes, 1, 255)),
      counts_(static_cast<std::size_t>(classes_) * static_cast<std::size_t>(classes_), 0) {}

void Evaluation::add(std::uint8_t label, std::uint8_t found, std::uint64_t pixels) {
  if (label >= classes_) return;
  const std::size_t column = found < classes_ ? found : ColorClasses::kNone;
  counts_[static_cast<std::size_t>(label) * static_cast<std::size_t>(classes_) + column] += pixels;
}

void Evaluation::add(const ColorTable& table, const ColorImage& image, std::span<const std::uint8_t> labels) {
  const std::size_t count = std::min(labels.size(), image.pixels.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (labels[i] != kIgnored) add(labels[i], table.classOf(image.pixels[i]));
  }
}

std::uint64_t Evaluation::count(int label, int found) const {
  return counts_[static_cast<std::size_t>(label) * static_cast<std::size_t>(classes_) +
                 static_cast<std::size_t>(found)];
}

std::uint64_t Evaluation::labeled(int label) const {
  const auto row = counts_.begin() + static_cast<std::ptrdiff_t>(label) * classes_;
  return std::accumulate(row, row + classes_, std::uint64_t{0});
}

double Evaluation::recall(int label) const {
  return share(count(label, label), labeled(label));
}

double Evaluation::meanRecall() const {
  double sum = 0;
  int occurring = 0;
  for (int label = 1; label < classes_; ++label) {
    if (labeled(label) == 0) continue;
    sum += recall(label);
    ++occurring;
  }
  return occurring == 0 ? 0 : sum / occurring;
}

double Evaluation::falseColor(std::span<const std::uint8_t> classes) const {
  std::uint64_t wrong = 0;
  for (const std::uint8_t colorClass : classes) {
    if (colorClass < classes_) wrong += count(ColorClasses::kNone, colorClass);
  }
  return share(wrong, labeled(ColorClasses::kNone));
}

}  // namespace colortool
