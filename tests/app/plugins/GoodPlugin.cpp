// SPDX-License-Identifier: GPL-3.0-or-later
// A plug-in for tests: a command and a log format.
#include "logplayer/file/LogFormat.h"
#include "robotlink/base/Plugin.h"
#include "robotlink/commands/CommandRegistration.h"

namespace {

logplayer::LogFormat::Robot nobody() {
  return {.name = "nobody"};
}

bool recognizesTest(const std::filesystem::path& file) {
  return file.extension() == ".test-log";
}

robotlink::Result<logplayer::ImportReport> importTest(const std::filesystem::path& from,
                                                      const logplayer::ImportSink&,
                                                      const logplayer::ImportOptions&) {
  if (from.stem() == "throwing") throw std::runtime_error("the disk is round");
  return robotlink::failure("test.import", "nothing can be read of it", {from.string(), 0, 0});
}

}  // namespace

ROBOTCONTROL_PLUGIN("good", "2.1", "Is good.") {
  using robotlink::CommandTable;
  static const robotlink::CommandRegistration kCommand{
      {{"good.check",
        "Fails for numbers below 0, and throws for 13",
        {{"number", CommandTable::Type::kNumber, ""}}},
       [](robotlink::Session&, const CommandTable::Values& values) -> robotlink::Result<void> {
         const double number = std::get<double>(values[0]);
         if (number == 13) throw std::runtime_error("13 is unlucky");
         if (number < 0) return robotlink::failure("good.negative", "it is negative");
         return {};
       }}};
  static const logplayer::LogFormatRegistration kFormat{{"test log", nobody, recognizesTest, importTest}};
}
