// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/truth/ErrorKeys.h"

#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Presets.h"
#include "robotlink/truth/TruthErrors.h"

namespace app {

std::shared_ptr<const robotlink::Preset> presetForErrors(
    const std::shared_ptr<const robotlink::Preset>& chosen) {
  robotlink::Preset preset = chosen ? *chosen : robotlink::Preset();
  auto& keys = preset.parts[robotlink::Preset::kKeys];
  if (!keys) keys.emplace();
  const auto always = [&](const std::string& package) { (*keys)["package/" + package] = "always"; };
  always(robotlink::kOracleWorld.name);
  always(robotlink::kGameState.name);
  for (const std::string& package : robotlink::TruthErrors::packages()) always(package);
  return std::make_shared<const robotlink::Preset>(std::move(preset));
}

}  // namespace app
