// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/View.h"

#include <algorithm>

namespace widgets {
namespace {

std::vector<ViewType>& registeredViews() {
  static std::vector<ViewType> types;
  return types;
}

}  // namespace

View::View(ViewContext& context, QWidget* parent) : QWidget(parent), context_(context) {}

const std::vector<ViewType>& ViewRegistry::all() {
  return registeredViews();
}

const ViewType* ViewRegistry::find(const std::string& id) {
  const auto& types = registeredViews();
  const auto found = std::find_if(types.begin(), types.end(), [&](const ViewType& t) { return id == t.id; });
  return found == types.end() ? nullptr : &*found;
}

ViewRegistration::ViewRegistration(ViewType type) {
  registeredViews().push_back(std::move(type));
}

}  // namespace widgets
