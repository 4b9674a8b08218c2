// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/ExportPass.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "logplayer/base/DamageReport.h"
#include "logplayer/base/OutputFile.h"
#include "logplayer/base/Plural.h"
#include "logplayer/base/RecordedStreams.h"
#include "robotcontrol/Debugging.pb.h"

namespace logplayer {

using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

constexpr std::uint64_t kMessagesPerProgress = 64;

}  // namespace

Result<Unread> forEachMessage(const std::shared_ptr<LogFile>& log, const std::vector<std::string>& streams,
                              const ExportOptions& options, PassShare share,
                              const std::function<Result<void>(const StreamMessage&)>& visit) {
  LogFile::Cursor cursor(log, streams);
  if (options.from) cursor.seek(*options.from);
  const Instant from = options.from.value_or(log->begin());
  const double length = robotlink::seconds(options.to.value_or(log->end()) - from);
  std::uint64_t count = 0;
  while (const auto time = cursor.nextTime()) {
    if (options.to && *options.to < *time) break;
    const auto message = cursor.next();
    if (!message || (options.to && *options.to < message->time)) break;
    if (const auto done = visit(*message); !done) return tl::unexpected(done.error());
    if (++count % kMessagesPerProgress != 0 || !options.progress) continue;
    const double here =
        length > 0 ? std::clamp(robotlink::seconds(message->time - from) / length, 0.0, 1.0) : 1;
    if (!options.progress(share.from + (share.to - share.from) * here)) {
      return robotlink::failure("log.given-up", "canceled");
    }
  }
  return cursor.unread();
}

std::vector<std::string> chosenStreams(const LogFile& log, const StreamFilter& streams,
                                       const std::function<bool(const LogFile::Stream&)>& fitting) {
  std::vector<std::string> paths;
  for (const auto& stream : log.streams()) {
    if (streams.has(stream.path) && fitting(stream)) paths.push_back(stream.path);
  }
  return paths;
}

Result<std::vector<std::string>> namedStreams(const LogFile& log, const std::string& text,
                                              ExportReport& report) {
  const auto exactly = [&](const LogFile::Stream& stream) { return stream.path == text; };
  const auto& all = log.streams();
  StreamFilter choice{{text}, {}};
  const bool one = std::any_of(all.begin(), all.end(), exactly);
  if (!one) {
    const auto selection = readSelection(text);
    if (!selection) return tl::unexpected(selection.error());
    choice = {{selection->include().begin(), selection->include().end()},
              {selection->exclude().begin(), selection->exclude().end()}};
  }
  std::vector<std::string> paths;
  std::string undecoded;
  for (const auto& stream : all) {
    if (one ? !exactly(stream) : !choice.has(stream.path)) continue;
    if (stream.isDecoded()) {
      paths.push_back(stream.path);
      continue;
    }
    undecoded = "the messages of " + stream.path + " are in the encoding '" + stream.encoding +
                "', which is not supported";
    report.losses.push_back(log.path().string() + ": " + undecoded + "; " + plural(stream.count, "message") +
                            " left out");
  }
  if (!paths.empty()) return paths;
  if (!undecoded.empty())
    return robotlink::failure("export.encoding", undecoded, {log.path().string(), 0, 0}, {text});
  return robotlink::failure("export.stream",
                            "there is no stream " + text + " in it; 'robotctl log info' lists them",
                            {log.path().string(), 0, 0}, {text});
}

void noteUnread(const Unread& unread, ExportReport& report) {
  for (const auto& [stream, count] : unread) {
    report.losses.push_back(plural(count, "message") + " of " + stream + " could not be read; left out");
  }
}

bool isUndecoded(const LogFile& log, const StreamMessage& message) {
  if (dynamic_cast<const robotcontrol::PackageCopy*>(message.value.get()) == nullptr) return false;
  const auto& all = log.streams();
  return std::any_of(all.begin(), all.end(),
                     [&](const auto& stream) { return stream.path == message.path && stream.undecoded > 0; });
}

void noteDamage(const LogFile& log, ExportReport& report) {
  const auto losses = describeDamage(log.path(), log.complete(), log.damage());
  report.losses.insert(report.losses.end(), losses.begin(), losses.end());
}

Result<void> put(std::ostream& out, const std::string& text) {
  errno = 0;
  if (out << text) return {};
  const std::string reason = errno != 0 ? std::strerror(errno) : "unknown reason";
  return robotlink::failure("file.io", "cannot write: " + reason, {}, {reason});
}

Result<ExportReport> exportTo(const std::filesystem::path& file, bool overwrite,
                              const std::function<Result<ExportReport>(std::ostream&)>& write) {
  auto output = OutputFile::create(file, overwrite);
  if (!output) return tl::unexpected(output.error());
  std::ofstream stream(output->temporary(), std::ios::binary);
  auto report = write(stream);
  if (!report) {
    robotlink::Error error = output->named(report.error());
    if (error.id == "file.io" && error.where.file.empty()) error.where.file = file.string();
    return tl::unexpected(error);
  }
  stream.close();
  if (!stream) {
    const std::string reason = std::strerror(errno);
    return robotlink::failure("file.io", "cannot write: " + reason, {file.string(), 0, 0}, {reason});
  }
  if (const auto named = output->commit(); !named) return tl::unexpected(named.error());
  return report;
}

}  // namespace logplayer
