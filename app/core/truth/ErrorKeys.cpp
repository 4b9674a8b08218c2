// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/truth/ErrorKeys.h"

#include "robotlink/session/Presets.h"
#include "robotlink/truth/TruthErrors.h"

namespace app {

std::shared_ptr<const robotlink::Preset> presetForErrors(
    const std::shared_ptr<const robotlink::Preset>& chosen) {
  robotlink::Preset preset = chosen ? *chosen : robotlink::Preset();
  auto& keys = preset.parts[robotlink::Preset::kKeys];
  if (!keys) keys.emplace();
  for (const std::string& package : robotlink::TruthErrors::neededPackages())
    (*keys)["package/" + package] = "always";
  return std::make_shared<const robotlink::Preset>(std::move(preset));
}

}  // namespace app
