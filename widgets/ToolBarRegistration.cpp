// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ToolBarRegistration.h"

#include <algorithm>
#include <string>

#include "robotlink/base/Registrations.h"

namespace widgets {
namespace {

robotlink::Registry<ToolBarType>& toolBars() {
  static robotlink::Registry<ToolBarType> types;
  return types;
}

}  // namespace

const std::vector<ToolBarType>& registeredToolBars() {
  return toolBars().all();
}

ToolBarRegistration::ToolBarRegistration(ToolBarType type) {
  const std::string id = type.id;
  const bool isNew =
      std::ranges::none_of(registeredToolBars(), [&](const ToolBarType& other) { return other.id == id; });
  toolBars().add(std::move(type), "toolbar \"" + id + "\"",
                 isNew ? "" : "registered twice; identifiers of toolbars are unique");
}

}  // namespace widgets
