// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/TrainingOptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace colortool {
namespace {

using Settings = TrainingSettings;
using enum TrainingMethod;

constexpr std::array<std::string_view, 3> kMethods = {"votes", "gaussians", "support-vectors"};

constexpr std::array kOptions = {
    TrainingOption{"radius", kVotes, false, VoteOptions::kMinRadius, VoteOptions::kMaxRadius, false,
                   [](const Settings& s) { return s.votes.radius; },
                   [](Settings& s, double value) { s.votes.radius = value; }},
    TrainingOption{"brightness-weight", kVotes, false, VoteOptions::kMinBrightnessWeight, 1, false,
                   [](const Settings& s) { return s.votes.brightnessWeight; },
                   [](Settings& s, double value) { s.votes.brightnessWeight = value; }},
    TrainingOption{"rejection", kVotes, false, 0, 2, false,
                   [](const Settings& s) { return s.votes.rejection; },
                   [](Settings& s, double value) { s.votes.rejection = value; }},
    TrainingOption{"background-weight", kVotes, false, 0, VoteOptions::kMaxBackgroundWeight, false,
                   [](const Settings& s) { return s.votes.backgroundWeight; },
                   [](Settings& s, double value) { s.votes.backgroundWeight = value; }},
    TrainingOption{"shading", kVotes, false, 0, VoteOptions::kMaxShading, false,
                   [](const Settings& s) { return s.votes.shading; },
                   [](Settings& s, double value) { s.votes.shading = value; }},
    TrainingOption{"gray-guard", kVotes, false, 0, 40, false,
                   [](const Settings& s) { return s.votes.grayGuard; },
                   [](Settings& s, double value) { s.votes.grayGuard = value; }},
    TrainingOption{"gaussian-distance", kGaussians, false, 1, 400, true,
                   [](const Settings& s) { return s.gaussians.mostSquaredDistance; },
                   [](Settings& s, double value) { s.gaussians.mostSquaredDistance = value; }},
    TrainingOption{"cost", kSupportVectors, false, 0.1, 1000, true,
                   [](const Settings& s) { return s.supportVectors.cost; },
                   [](Settings& s, double value) { s.supportVectors.cost = value; }},
    TrainingOption{"gamma", kSupportVectors, false, 1e-5, 0.1, true,
                   [](const Settings& s) { return s.supportVectors.gamma; },
                   [](Settings& s, double value) { s.supportVectors.gamma = value; }},
    TrainingOption{"distance", kSupportVectors, false, 1, 200, false,
                   [](const Settings& s) { return s.supportVectors.mostDistance; },
                   [](Settings& s, double value) { s.supportVectors.mostDistance = value; }},
    TrainingOption{"remove-unsupported",
                   {},
                   true,
                   0,
                   1,
                   false,
                   [](const Settings& s) { return s.cleanUp.removeUnsupported ? 1.0 : 0.0; },
                   [](Settings& s, double value) { s.cleanUp.removeUnsupported = value != 0; }},
    TrainingOption{"fill-holes",
                   {},
                   true,
                   0,
                   1,
                   false,
                   [](const Settings& s) { return s.cleanUp.fillHoles ? 1.0 : 0.0; },
                   [](Settings& s, double value) { s.cleanUp.fillHoles = value != 0; }},
    TrainingOption{"correct-vignetting",
                   {},
                   true,
                   0,
                   1,
                   false,
                   [](const Settings& s) { return s.correctVignetting ? 1.0 : 0.0; },
                   [](Settings& s, double value) { s.correctVignetting = value != 0; }},
    TrainingOption{"correct-cameras",
                   {},
                   true,
                   0,
                   1,
                   false,
                   [](const Settings& s) { return s.correctCameras ? 1.0 : 0.0; },
                   [](Settings& s, double value) { s.correctCameras = value != 0; }},
};

/// Joins names: "radius, brightness-weight, ..."
template <typename Range, typename Name>
std::string listed(const Range& range, const Name& name) {
  std::string list;
  for (const auto& item : range) {
    if (!list.empty()) list += ", ";
    list += name(item);
  }
  return list;
}

}  // namespace

std::span<const TrainingOption> trainingOptions() {
  return kOptions;
}

const TrainingOption* findTrainingOption(std::string_view name) {
  const auto* found = std::ranges::find(kOptions, name, &TrainingOption::name);
  return found == kOptions.end() ? nullptr : found;
}

robotlink::Result<TrainingSettings> withOption(TrainingSettings settings, std::string_view name,
                                               double value) {
  const TrainingOption* option = findTrainingOption(name);
  if (option == nullptr) {
    return robotlink::failure("color.option",
                              fmt::format("there is no option '{}'; there are {}", name,
                                          listed(kOptions, [](const auto& each) { return each.name; })),
                              {}, {std::string(name)});
  }
  const bool neitherOnNorOff = option->isSwitch && value != 0 && value != 1;
  if (!(value >= option->least && value <= option->most) || neitherOnNorOff) {
    return robotlink::failure(
        "color.option-value",
        option->isSwitch ? fmt::format("{} is 0 (off) or 1 (on)", name)
                         : fmt::format("{} must be between {} and {}", name, option->least, option->most),
        {}, {std::string(name)});
  }
  option->set(settings, value);
  return settings;
}

std::string_view nameOf(TrainingMethod method) {
  return kMethods.at(static_cast<std::size_t>(method));
}

robotlink::Result<TrainingMethod> trainingMethod(std::string_view name) {
  const auto* found = std::ranges::find(kMethods, name);
  if (found != kMethods.end()) return static_cast<TrainingMethod>(found - kMethods.begin());
  return robotlink::failure("color.method",
                            fmt::format("there is no method '{}'; there are {}", name,
                                        listed(kMethods, [](std::string_view each) { return each; })),
                            {}, {std::string(name)});
}

}  // namespace colortool
