// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ColorTables.h"

#include "colortool/ColorTableFile.h"
#include "robotcontrol/Perception.pb.h"

namespace app {

robotlink::Result<std::shared_ptr<robotcontrol::ColorTable>> readColorTable(
    const std::filesystem::path& file) {
  const auto read = colortool::ColorTableFile::load(file);
  if (!read) return tl::unexpected(read.error());
  auto table = std::make_shared<robotcontrol::ColorTable>();
  for (const std::string_view name : colortool::ColorTableFile::kBHuman2009Classes)
    table->add_class_names(std::string(name));
  const std::vector<std::uint8_t> cells = read->singleClasses();
  table->set_cells(cells.data(), cells.size());
  return table;
}

}  // namespace app
