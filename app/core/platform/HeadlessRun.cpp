// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/HeadlessRun.h"

#include <algorithm>
#include <iterator>

#include "app/core/platform/PlatformAdapter.h"

namespace app {
namespace {

/// Returns the usage for users: "--platform is a log file, or a robot's address; ...".
std::string usageOf(const std::vector<HeadlessPlatform>& platforms) {
  std::string text;
  for (const HeadlessPlatform& platform : platforms)
    text += (text.empty() ? "--platform is " : ", or ") + std::string(platform.usage);
  for (const PlatformAdapter& adapter : platformAdapters()) {
    if (adapter.insteadOfHeadless != nullptr) text += std::string("; ") + adapter.insteadOfHeadless;
  }
  return text;
}

/// Whether a kind of platform has this option, too.
bool has(const HeadlessPlatform& platform, const PlatformField& option) {
  return std::ranges::any_of(platform.options,
                             [&](const PlatformField& own) { return own.option == option.option; });
}

}  // namespace

std::vector<HeadlessPlatform> headlessPlatforms() {
  std::vector<HeadlessPlatform> platforms;
  const auto& adapters = platformAdapters();
  for (auto adapter = std::rbegin(adapters); adapter != std::rend(adapters); ++adapter) {
    if (adapter->headless == nullptr) continue;
    platforms.push_back(adapter->headless());
    if (platforms.back().runs == nullptr) platforms.back().runs = adapter->opens;
  }
  return platforms;
}

robotlink::Result<HeadlessPlatform> headlessPlatformFor(const HeadlessChoices& choices) {
  std::vector<HeadlessPlatform> platforms = headlessPlatforms();
  const auto chosen = std::ranges::find_if(
      platforms, [&](const HeadlessPlatform& platform) { return platform.runs(choices.platform); });
  if (chosen == platforms.end()) return robotlink::failure("usage", usageOf(platforms));
  for (const HeadlessPlatform& other : platforms) {
    const bool given = std::ranges::any_of(other.options, [&](const PlatformField& option) {
      return choices.options.given(option) && !has(*chosen, option);
    });
    if (&other != &*chosen && given && other.optionsAreMine != nullptr)
      return robotlink::failure("usage", other.optionsAreMine);
  }
  return std::move(*chosen);
}

}  // namespace app
