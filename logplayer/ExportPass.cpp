// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/ExportPass.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "logplayer/Losses.h"
#include "logplayer/OutputFile.h"

namespace logplayer {

using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

constexpr std::uint64_t kMessagesPerProgress = 64;

}  // namespace

Result<void> forEachMessage(const std::shared_ptr<LogFile>& log, const std::vector<std::string>& streams,
                            const ExportOptions& options, PassShare share,
                            const std::function<Result<void>(const StreamMessage&)>& visit) {
  LogFile::Cursor cursor(log, streams);
  if (options.from) cursor.seek(*options.from);
  const Instant from = options.from.value_or(log->begin());
  const double length = robotlink::seconds(options.to.value_or(log->end()) - from);
  std::uint64_t count = 0;
  while (const auto message = cursor.next()) {
    if (options.to && *options.to < message->time) break;
    if (const auto done = visit(*message); !done) return done;
    if (++count % kMessagesPerProgress != 0 || !options.progress) continue;
    const double here =
        length > 0 ? std::clamp(robotlink::seconds(message->time - from) / length, 0.0, 1.0) : 1;
    if (!options.progress(share.from + (share.to - share.from) * here)) {
      return robotlink::failure("log.given-up", "given up");
    }
  }
  return {};
}

std::vector<std::string> chosenStreams(const LogFile& log, const StreamChoice& streams,
                                       const std::function<bool(const std::string& type)>& fitting) {
  std::vector<std::string> paths;
  for (const auto& stream : log.streams()) {
    if (streams.has(stream.path) && fitting(stream.type)) paths.push_back(stream.path);
  }
  return paths;
}

std::string plural(std::uint64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void noteDamage(const LogFile& log, ExportReport& report) {
  const auto losses = lossesOf(log.path(), log.complete(), log.damage());
  report.losses.insert(report.losses.end(), losses.begin(), losses.end());
}

Result<ExportReport> exportTo(const std::filesystem::path& file, bool overwrite,
                              const std::function<Result<ExportReport>(std::ostream&)>& write) {
  auto output = OutputFile::create(file, overwrite);
  if (!output) return tl::unexpected(output.error());
  std::ofstream stream(output->temporary(), std::ios::binary);
  auto report = write(stream);
  if (!report) return report;
  stream.close();
  if (!stream) {
    const std::string reason = std::strerror(errno);
    return robotlink::failure("file.io", "cannot write: " + reason, {file.string(), 0, 0}, {reason});
  }
  if (const auto named = output->commit(); !named) return tl::unexpected(named.error());
  return report;
}

}  // namespace logplayer
