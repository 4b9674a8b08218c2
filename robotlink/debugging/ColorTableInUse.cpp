// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ColorTableInUse.h"

namespace robotlink {

robotcontrol::ColorTable colorTableInUse(const robotcontrol::ColorTable* table) {
  robotcontrol::ColorTable inUse;
  if (table == nullptr || table->cells().empty()) {
    inUse.set_source(kBuiltInColorTable);
    return inUse;
  }
  *inUse.mutable_class_names() = table->class_names();
  inUse.set_source(table->source().empty() ? "sent, from an unknown source" : table->source());
  if (table->has_loaded()) *inUse.mutable_loaded() = table->loaded();
  return inUse;
}

std::string describeColorTable(const robotcontrol::ColorTable& inUse) {
  if (inUse.source() == kBuiltInColorTable) return "The color table is now the built-in one";
  return "The color table is now " + inUse.source();
}

}  // namespace robotlink
