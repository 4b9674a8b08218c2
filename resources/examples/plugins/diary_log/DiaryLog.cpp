// SPDX-License-Identifier: GPL-3.0-or-later
// A log format: text files that begin with "# diary", with a line for each entry: seconds, a blank, a text.
#include <fstream>
#include <string>

#include "foxglove/Robot.pb.h"
#include "logplayer/file/LogFormat.h"
#include "robotlink/base/Plugin.h"
#include "robotlink/packages/Conversions.h"

namespace {

constexpr char kFirstLine[] = "# diary";

bool recognizes(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::ifstream stream(file);
  std::string line(sizeof kFirstLine - 1, ' ');
  return stream.read(line.data(), static_cast<std::streamsize>(line.size())) && line == kFirstLine;
}

/// Sets the time and the text of an entry; false if the line is none.
bool readEntry(const std::string& line, double& seconds, std::string& text) {
  try {
    std::size_t used = 0;
    seconds = std::stod(line, &used);
    if (used >= line.size() || line[used] != ' ') return false;
    text = line.substr(used + 1);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

robotlink::Result<logplayer::ImportReport> import(const std::filesystem::path& from,
                                                  const logplayer::ImportSink& sink,
                                                  const logplayer::ImportOptions& options) {
  logplayer::ImportReport report;
  report.format = "diary";
  std::ifstream stream(from);
  std::string line;
  std::getline(stream, line);
  for (int number = 2; std::getline(stream, line); ++number) {
    double seconds = 0;
    std::string text;
    if (!readEntry(line, seconds, text)) {
      report.damage = "line " + std::to_string(number) + " is no entry";
      ++report.notUnderstood["line"];
      continue;
    }
    auto entry = std::make_shared<foxglove::Log>();
    entry->set_level(foxglove::Log::INFO);
    entry->set_message(text);
    entry->set_name("diary");
    const robotlink::Instant time(std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
    robotlink::assign(*entry->mutable_timestamp(), time);
    if (auto passed = sink({{options.robot + "/log", time, std::move(entry), "diary"}}); !passed)
      return tl::unexpected(passed.error());
    ++report.messages;
    ++report.imported["entry"];
    if (options.progress && !options.progress(0)) return robotlink::failure("log.given-up", "given up");
  }
  if (report.messages == 0)
    return robotlink::failure("diary.empty", "there are no entries", {from.string(), 0, 0});
  return report;
}

}  // namespace

ROBOTCONTROL_PLUGIN("diary-log", "1.0", "Opens diaries, text files that begin with '# diary', as logs.") {
  logplayer::LogFormatRegistration({.name = "diary",
                                    .robot = [] { return logplayer::LogFormat::Robot{.name = "writer"}; },
                                    .recognizes = recognizes,
                                    .import = import});
}
