// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ClassPresets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace colortool {
namespace {

constexpr std::array<ClassPreset::Color, 9> k2002 = {{{"orange", {255, 105, 0}},
                                                      {"yellow", {250, 215, 0}},
                                                      {"skyblue", {40, 165, 235}},
                                                      {"pink", {250, 90, 160}},
                                                      {"green", {0, 130, 50}},
                                                      {"white", {235, 235, 235}},
                                                      {"red", {200, 15, 25}},
                                                      {"blue", {15, 30, 130}},
                                                      {"black", {45, 45, 50}}}};

constexpr std::array<ClassPreset::Color, 8> kBHuman2009 = {{{"orange", {255, 128, 0}},
                                                            {"yellow", {255, 230, 0}},
                                                            {"blue", {0, 80, 255}},
                                                            {"white", {255, 255, 255}},
                                                            {"green", {0, 160, 40}},
                                                            {"black", {40, 40, 40}},
                                                            {"red", {220, 0, 0}},
                                                            {"robotBlue", {0, 200, 255}}}};

constexpr std::array<ClassPreset, 2> kPresets = {
    {{"2002", "Four-legged league 2002", k2002}, {"bhuman2009", "B-Human 2009", kBHuman2009}}};

robotlink::Rgb colorOf(std::string_view name, int number) {
  for (const ClassPreset& preset : kPresets) {
    const auto found = std::ranges::find(preset.colors, name, &ClassPreset::Color::name);
    if (found != preset.colors.end()) return found->rgb;
  }
  return spareColor(number);
}

}  // namespace

ColorClasses ClassPreset::classes() const {
  std::vector<NamedColor> named;
  for (const Color& color : colors) named.push_back({std::string(color.name), color.rgb});
  return ColorClasses(std::move(named));
}

std::span<const ClassPreset> classPresets() {
  return kPresets;
}

const ClassPreset* findClassPreset(std::string_view name) {
  const auto* found = std::ranges::find(kPresets, name, &ClassPreset::name);
  return found == kPresets.end() ? nullptr : found;
}

const ClassPreset& presetFor(std::span<const std::string> colors) {
  return *std::ranges::max_element(kPresets, {}, [&](const ClassPreset& preset) {
    return std::ranges::count_if(preset.colors, [&](const ClassPreset::Color& color) {
      return std::ranges::find(colors, color.name) != colors.end();
    });
  });
}

robotlink::Result<ColorClasses> chooseClasses(std::span<const std::string> names) {
  if (names.size() == 1) {
    if (const ClassPreset* preset = findClassPreset(names[0])) return preset->classes();
  }
  std::vector<NamedColor> classes;
  for (const std::string& name : names) {
    std::string problem = classNameProblem(name);
    if (std::ranges::find(classes, name, &NamedColor::name) != classes.end())
      problem = "the class '" + name + "' is named twice";
    if (!problem.empty()) return robotlink::failure("color.classes", std::move(problem), {}, {name});
    classes.push_back({name, colorOf(name, static_cast<int>(classes.size()) + 1)});
  }
  if (classes.size() > ColorClasses::kMax)
    return robotlink::failure("color.classes", "there are more than 255 classes");
  return ColorClasses(std::move(classes));
}

robotlink::Rgb spareColor(int number) {
  // Successive hues are a golden section apart, so that they repeat late; six phases yield the saturated
  // color of a hue.
  const double phase = std::fmod(0.78 + 0.618034 * number, 1.0) * 6;
  const auto channel = [phase](double offset) {
    const double at = std::fmod(offset + phase, 6);
    return static_cast<std::uint8_t>(
        std::lround(40 + 215 * (1 - std::clamp(std::min(at, 4 - at), 0.0, 1.0))));
  };
  return {channel(5), channel(3), channel(1)};
}

NamedColor spareClass(int number, std::span<const NamedColor> others) {
  NamedColor spare{"class " + std::to_string(number), spareColor(number)};
  while (std::ranges::find(others, spare.name, &NamedColor::name) != others.end()) spare.name += "'";
  return spare;
}

}  // namespace colortool
