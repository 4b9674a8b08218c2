// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/ClassPresets.h"

#include <algorithm>
#include <array>

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

}  // namespace colortool
