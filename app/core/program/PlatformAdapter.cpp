// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/PlatformAdapter.h"

#include <algorithm>

namespace app {
namespace {

std::vector<PlatformAdapter>& adapters() {
  static std::vector<PlatformAdapter> all;
  return all;
}

}  // namespace

PlatformRegistration::PlatformRegistration(PlatformAdapter adapter) {
  auto& all = adapters();
  const auto place =
      std::ranges::find_if(all, [&](const PlatformAdapter& other) { return other.order > adapter.order; });
  all.insert(place, adapter);
}

const std::vector<PlatformAdapter>& platformAdapters() {
  return adapters();
}

const PlatformAdapter* adapterFor(const std::string& source) {
  const auto found =
      std::ranges::find_if(adapters(), [&](const PlatformAdapter& adapter) { return adapter.opens(source); });
  return found == adapters().end() ? nullptr : &*found;
}

}  // namespace app
