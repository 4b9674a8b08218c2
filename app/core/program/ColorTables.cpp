// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ColorTables.h"

#include "colortool/table/TableImport.h"
#include "robotcontrol/Perception.pb.h"

namespace app {

robotlink::Result<std::shared_ptr<robotcontrol::ColorTable>> readColorTable(
    const std::filesystem::path& file) {
  const auto imported = colortool::importTable(file);
  if (!imported) {
    robotlink::Error error = imported.error().front();
    if (error.where.file.empty()) error.where.file = file.string();
    return tl::unexpected(std::move(error));
  }
  const colortool::NamedColorTable* read = &imported->table;
  auto table = std::make_shared<robotcontrol::ColorTable>();
  for (const std::string& name : read->classes.names()) table->add_class_names(name);
  const std::vector<std::uint8_t> cells = read->file.singleClasses();
  table->set_cells(cells.data(), cells.size());
  std::error_code unknown;
  const std::filesystem::path whole = std::filesystem::absolute(file, unknown);
  table->set_source((unknown ? file : whole).lexically_normal().string());
  return table;
}

robotcontrol::ColorTable colorTableOfLog(const robotcontrol::ColorTable& logged) {
  robotcontrol::ColorTable table = logged;
  if (logged.source().starts_with(kOfTheLog)) return table;
  table.set_source(logged.source().empty() ? kOfTheLog : std::string(kOfTheLog) + ": " + logged.source());
  return table;
}

}  // namespace app
