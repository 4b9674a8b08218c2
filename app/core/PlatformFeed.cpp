// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PlatformFeed.h"

namespace app {

std::string LoadedPlatform::name() const {
  if (simulation) return simulation->scene.stem().string();
  if (pioneer) return pioneer->url;
  std::string names;
  for (const ReplayLog& log : logs) names += (names.empty() ? "" : " + ") + log.file.filename().string();
  return names;
}

}  // namespace app
