// SPDX-License-Identifier: GPL-3.0-or-later
// Export of messages as CSV and JSON lines.
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

#include "logplayer/base/Plural.h"
#include "logplayer/export/ExportPass.h"
#include "logplayer/export/JsonLine.h"
#include "logplayer/export/LogExport.h"
#include "logplayer/export/MessageTable.h"

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::Result;
using robotlink::StreamMessage;

std::string timeText(robotlink::Instant time) {
  const auto count = time.time_since_epoch().count();
  constexpr std::int64_t kSecond = 1'000'000'000;
  return secondsText(count / kSecond, count % kSecond);
}

/// A CSV table of one or several streams.
class CsvTable {
 public:
  CsvTable(const std::shared_ptr<LogFile>& log, std::vector<std::string> streams)
      : log_(log), streams_(std::move(streams)) {
    for (const std::string& stream : streams_) parts_.emplace(stream, Part{MessageTable(room_), {}, 0});
  }

  Result<void> write(std::ostream& out, const ExportOptions& options, ExportReport& report) {
    const auto learned = forEachMessage(log_, streams_, options, {0, 0.5},
                                        [this](const StreamMessage& message) -> Result<void> {
                                          Part& part = parts_.at(message.path);
                                          if (!isUndecoded(*log_, message) && part.takes(message))
                                            part.table.learn(*message.value);
                                          return {};
                                        });
    if (!learned) return tl::unexpected(learned.error());
    if (const auto begun = logplayer::put(out, csvLine(head())); !begun) return begun;
    const auto written =
        forEachMessage(log_, streams_, options, {0.5, 1}, [&](const StreamMessage& message) -> Result<void> {
          Part& part = parts_.at(message.path);
          if (isUndecoded(*log_, message)) {
            ++part.undecoded;
          } else if (!part.takes(message)) {
            ++part.ofOtherTypes;
          } else {
            ++report.written;
            return logplayer::put(out, csvLine(row(message)));
          }
          return {};
        });
    if (!written) return tl::unexpected(written.error());
    noteUnread(*written, report);
    noteLosses(report);
    return {};
  }

 private:
  struct Part {
    MessageTable table;
    std::string type;  // type of the first message; a table contains one type
    std::uint64_t ofOtherTypes = 0;
    std::uint64_t undecoded = 0;

    bool takes(const StreamMessage& message) {
      const std::string& name = message.value->GetDescriptor()->full_name();
      if (type.empty()) type = name;
      return type == name;
    }
  };

  bool single() const { return streams_.size() == 1; }

  std::vector<std::string> head() {
    std::vector<std::string> cells{"log_time"};
    if (!single()) cells.emplace_back("log_stream");
    cells.insert(cells.end(), {"log_process", "log_frame"});
    std::size_t column = cells.size();
    for (const std::string& stream : streams_) {
      begins_[stream] = column;
      for (const std::string& name : parts_.at(stream).table.columns()) {
        cells.push_back(single() ? name : stream + "." + name);
        ++column;
      }
    }
    width_ = column;
    return cells;
  }

  std::vector<std::string> row(const StreamMessage& message) const {
    std::vector<std::string> cells{timeText(message.time)};
    if (!single()) cells.push_back(message.path);
    cells.push_back(message.process);
    cells.push_back(message.frame > 0 ? std::to_string(message.frame) : std::string());
    cells.resize(width_);
    auto values = parts_.at(message.path).table.row(*message.value);
    std::move(values.begin(), values.end(),
              cells.begin() + static_cast<std::ptrdiff_t>(begins_.at(message.path)));
    return cells;
  }

  void noteLosses(ExportReport& report) const {
    std::uint64_t leftOut = 0;
    for (const auto& [stream, part] : parts_) {
      leftOut += part.table.leftOut();
      if (part.ofOtherTypes > 0) {
        report.losses.push_back(plural(part.ofOtherTypes, "message") + " of " + stream +
                                " are of another type than " + part.type + "; left out");
      }
      if (part.undecoded > 0) {
        report.losses.push_back(plural(part.undecoded, "message") + " of " + stream +
                                " are in an unsupported encoding; left out");
      }
    }
    if (leftOut == 0) return;
    report.losses.push_back(plural(leftOut, "value") + " left out, because a table is limited to " +
                            std::to_string(MessageTable::kMaxColumns) + " columns");
  }

  std::shared_ptr<LogFile> log_;
  std::vector<std::string> streams_;
  std::shared_ptr<std::size_t> room_ = std::make_shared<std::size_t>(MessageTable::kMaxColumns);
  std::map<std::string, Part> parts_;
  std::map<std::string, std::size_t> begins_;  // first column of each stream
  std::size_t width_ = 0;
};

}  // namespace

Result<ExportReport> writeCsv(const std::shared_ptr<LogFile>& log, const std::string& streams,
                              std::ostream& out, const ExportOptions& options) {
  ExportReport report;
  auto paths = namedStreams(*log, streams, report);
  if (!paths) return tl::unexpected(paths.error());
  if (auto written = CsvTable(log, std::move(*paths)).write(out, options, report); !written) {
    return tl::unexpected(written.error());
  }
  noteDamage(*log, report);
  return report;
}

Result<ExportReport> exportCsv(const std::shared_ptr<LogFile>& log, const std::string& streams,
                               const fs::path& file, const ExportOptions& options) {
  return exportTo(file, options.overwrite,
                  [&](std::ostream& out) { return writeCsv(log, streams, out, options); });
}

Result<ExportReport> writeJsonLines(const std::shared_ptr<LogFile>& log, const std::string& streams,
                                    std::ostream& out, const ExportOptions& options) {
  ExportReport report;
  const auto paths = namedStreams(*log, streams, report);
  if (!paths) return tl::unexpected(paths.error());
  std::map<std::string, std::uint64_t> failed;
  const auto done =
      forEachMessage(log, *paths, options, {}, [&](const StreamMessage& message) -> Result<void> {
        const auto line = isUndecoded(*log, message) ? "" : jsonLine(message).value_or("");
        if (!line.empty()) {
          ++report.written;
          return logplayer::put(out, line);
        }
        ++failed[message.path];
        return {};
      });
  if (!done) return tl::unexpected(done.error());
  noteUnread(*done, report);
  for (const auto& [stream, count] : failed) {
    report.losses.push_back(plural(count, "message") + " of " + stream +
                            " cannot be expressed in JSON; left out");
  }
  noteDamage(*log, report);
  return report;
}

Result<ExportReport> exportJsonLines(const std::shared_ptr<LogFile>& log, const std::string& streams,
                                     const fs::path& file, const ExportOptions& options) {
  return exportTo(file, options.overwrite,
                  [&](std::ostream& out) { return writeJsonLines(log, streams, out, options); });
}

}  // namespace logplayer
