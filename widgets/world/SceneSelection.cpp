// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/SceneSelection.h"

#include "widgets/View.h"

namespace widgets {

void SceneSelection::select(const std::string& object) {
  if (object == object_) return;
  object_ = object;
  Q_EMIT changed();
}

SceneSelection& sceneSelection(ViewContext& context) {
  if (context.selection == nullptr) context.selection = std::make_shared<SceneSelection>();
  return *context.selection;
}

}  // namespace widgets
