// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/RunInputs.h"

#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "robotlink/base/Resources.h"
#include "robotlink/base/bytes/Fnv.h"

namespace app {
namespace {

/// Size and time of the last change of a file; empty if there is none.
std::string stateOf(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return "";
  const auto size = std::filesystem::file_size(file, error);
  const auto changed = std::filesystem::last_write_time(file, error).time_since_epoch().count();
  return error ? "" : fmt::format("{} {} {}\n", file.string(), size, changed);
}

int addLibrary(::dl_phdr_info* info, std::size_t /*size*/, void* states) {
  *static_cast<std::string*>(states) += stateOf(info->dlpi_name);
  return 0;
}

/// The state of the program that runs, its libraries and its resources.
std::string stateOfProgram() {
  std::error_code error;
  std::string states = stateOf(std::filesystem::read_symlink("/proc/self/exe", error));
  ::dl_iterate_phdr(addLibrary, &states);
  std::vector<std::string> resources;
  std::filesystem::recursive_directory_iterator entry(robotlink::resourceDirectory(), error), end;
  for (; !error && entry != end; entry.increment(error)) resources.push_back(stateOf(entry->path()));
  std::ranges::sort(resources);
  return states + fmt::format("{}", fmt::join(resources, ""));
}

}  // namespace

std::string inputsOf(const PlannedRun& run) {
  static const std::string kProgram = stateOfProgram();
  std::string states = kProgram;
  // A file may stand behind a name: "red=layout.yaml", "log:game.mcap".
  for (const std::string& argument : run.arguments)
    states += stateOf(argument) + stateOf(argument.substr(argument.find_first_of("=:") + 1));
  return fmt::format("# inputs {:016x}", robotlink::fnv1a(states));
}

}  // namespace app
