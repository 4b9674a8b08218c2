// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ColorTables.h"

#include "colortool/NamedColorTable.h"
#include "robotcontrol/Perception.pb.h"

namespace app {

robotlink::Result<std::shared_ptr<robotcontrol::ColorTable>> readColorTable(
    const std::filesystem::path& file) {
  const auto read = colortool::NamedColorTable::load(file);
  if (!read) return tl::unexpected(read.error().front());
  auto table = std::make_shared<robotcontrol::ColorTable>();
  for (const std::string& name : read->classes.names()) table->add_class_names(name);
  const std::vector<std::uint8_t> cells = read->file.singleClasses();
  table->set_cells(cells.data(), cells.size());
  return table;
}

}  // namespace app
