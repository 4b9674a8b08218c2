// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PlatformAdapter.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "robotlink/base/Registrations.h"

namespace app {

using robotlink::failure;
using robotlink::Result;

namespace {

robotlink::Registry<PlatformAdapter>& adapters() {
  static robotlink::Registry<PlatformAdapter> all(
      [](const PlatformAdapter& a, const PlatformAdapter& b) { return a.order < b.order; });
  return all;
}

}  // namespace

PlatformRegistration::PlatformRegistration(PlatformAdapter adapter) {
  const auto hasItsName = [&](const PlatformAdapter& other) {
    return std::string_view(other.name) == adapter.name;
  };
  const bool isNew = std::ranges::none_of(platformAdapters(), hasItsName);
  adapters().add(adapter, std::string("platform \"") + adapter.name + "\"",
                 isNew ? "" : "registered twice; names of platforms are unique");
}

const std::vector<PlatformAdapter>& platformAdapters() {
  return adapters().all();
}

const PlatformAdapter* adapterFor(const std::string& source) {
  const auto found = std::ranges::find_if(
      platformAdapters(), [&](const PlatformAdapter& adapter) { return adapter.opens(source); });
  return found == platformAdapters().end() ? nullptr : &*found;
}

PlatformForm formOf(const PlatformAdapter& adapter) {
  return adapter.form != nullptr ? adapter.form() : PlatformForm{};
}

PlatformChoices choicesOf(const PlatformForm& form, const std::vector<FormValue>& arguments) {
  PlatformChoices choices;
  const auto fields = form.arguments();
  for (std::size_t i = 0; i < std::min(fields.size(), arguments.size()); ++i) {
    // A number that was left out before others.
    if (const auto* number = std::get_if<double>(&arguments[i]); number && std::isnan(*number)) continue;
    if (const auto* source = std::get_if<std::string>(&arguments[i]); fields[i]->isSource && source) {
      choices.sources.push_back(*source);
    } else {
      choices.values[fields[i]->name] = arguments[i];
    }
  }
  return choices;
}

Result<PlatformOpening> openingOf(const PlatformAdapter& adapter, const PlatformChoices& choices) {
  const PlatformForm form = formOf(adapter);
  if (const std::string problem = problemOf(form, choices.values); !problem.empty())
    return failure(form.command, problem);
  if (choices.sources.size() > 1 && !adapter.severalSources) {
    return failure("platform.sources", choices.sources[1] + " cannot be opened together with " +
                                           choices.sources[0] + "; only logs can be opened together");
  }
  return adapter.open(choices);
}

Result<PlatformOpening> openingOf(const PlatformChoices& choices) {
  if (choices.sources.empty()) return failure("platform.sources", "there is nothing to open");
  const PlatformAdapter* adapter = adapterFor(choices.sources.front());
  if (adapter == nullptr) return failure("platform.sources", "nothing can open " + choices.sources.front());
  for (const std::string& source : choices.sources) {
    if (adapterFor(source) == adapter) continue;
    return failure("platform.sources", source + " cannot be opened together with " + choices.sources.front() +
                                           ", which is of another kind");
  }
  return openingOf(*adapter, choices);
}

}  // namespace app
