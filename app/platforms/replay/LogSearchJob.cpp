// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/LogSearchJob.h"

#include <cstdio>
#include <memory>
#include <utility>

#include "app/core/CommandValues.h"
#include "app/core/LogCommands.h"
#include "app/core/Workbench.h"
#include "app/platforms/replay/ReplayComputation.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/export/MessageTable.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/search/LogSearch.h"
#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;

std::string fromStartText(robotlink::Duration time) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6f", robotlink::seconds(time));
  return text;
}

std::string hitRow(const logplayer::SearchHit& hit, const logplayer::LogFile& log) {
  const auto* text = hit.text ? dynamic_cast<const foxglove::Log*>(hit.text->value.get()) : nullptr;
  return logplayer::csvLine({log.path().filename().string(), hit.robot, fromStartText(hit.from - log.begin()),
                             hit.until ? fromStartText(*hit.until - log.begin()) : std::string(),
                             text != nullptr ? text->message() : std::string()});
}

/// Adds the rows of one log to the table.
Result<void> searchOne(const std::filesystem::path& path, const LogSearchJob::Plan& plan,
                       const std::stop_token& stop, std::string& table) {
  const auto goesOn = [&stop](double) { return !stop.stop_requested(); };
  logplayer::LogFile::Options opening;
  opening.progress = goesOn;
  const auto log = logplayer::LogFile::open(path, opening);
  if (!log) return tl::unexpected(log.error());
  const auto report = logplayer::searchLog(*log, plan.expression, {.progress = goesOn},
                                           [&](const logplayer::SearchHit& hit) {
                                             table += hitRow(hit, **log);
                                             return true;
                                           },
                                           {computationByReplay()});
  return report ? Result<void>() : tl::unexpected(report.error());
}

Result<void> searchAll(const LogSearchJob::Plan& plan, const std::stop_token& stop) {
  const std::string head = logplayer::csvLine({"log", "robot", "from", "until", "text"});
  std::string table = head;
  for (const auto& log : plan.logs) {
    if (auto searched = searchOne(log, plan, stop, table); !searched) return searched;
  }
  if (!plan.file.empty()) {
    if (auto written = robotlink::writeFileAtomically(plan.file, table); !written) return written;
  }
  if (table != head) return {};
  return failure("log.not-found", "there is no time in the log at which this is true: " + plan.expression, {},
                 {plan.expression});
}

}  // namespace

LogSearchJob::LogSearchJob()
    : worker_([this](Plan plan, const std::stop_token& stop) { worker_.publish(searchAll(plan, stop)); }) {}

Result<void> LogSearchJob::begin(Plan plan) {
  if (isRunning_) return failure("log.searching", "the log is being searched already");
  isRunning_ = true;
  worker_.post(std::move(plan));
  return {};
}

Result<bool> LogSearchJob::working() {
  if (auto done = worker_.take()) {
    isRunning_ = false;
    if (!*done) return tl::unexpected(done->error());
  }
  return isRunning_;
}

void addLogSearch(Workbench& workbench) {
  const auto job = std::make_shared<LogSearchJob>();
  workbench.commands().attach("log.search", [&workbench, job](const Values& values) -> Result<void> {
    auto logs = openLogs(workbench);
    if (!logs) return tl::unexpected(std::move(logs.error()));
    return job->begin({std::move(*logs), text(values, 0), text(values, 1)});
  });
  workbench.addJob([job] { return job->working(); });
}

}  // namespace app
