// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/HistoryKeeper.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "logplayer/scratch/ScratchLog.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

constexpr char kMemory[] = "memory_mib", kDisk[] = "disk_mib";
constexpr double kMib = 1U << 20U;

std::uint64_t bytesOf(double mib) {
  return static_cast<std::uint64_t>(mib * kMib);
}

}  // namespace

HistoryKeeper::HistoryKeeper(robotlink::Session& session, std::filesystem::path file)
    : session_(session), settings_(std::move(file)) {
  if (const auto loaded = settings_.load(); !loaded) problem_ = loaded.error();
  session_.store().setBytes(memory());
}

HistoryKeeper::~HistoryKeeper() {
  session_.history().setArchive(nullptr);
}

void HistoryKeeper::setLive(bool live) {
  auto& history = session_.history();
  if (live == (history.archive() != nullptr)) return;
  history.setArchive(
      live ? std::make_unique<logplayer::ScratchLog>(logplayer::ScratchLog::Options{.bytes = disk()})
           : nullptr);
}

robotlink::Result<void> HistoryKeeper::setMemory(std::uint64_t bytes) {
  if (bytes < kMinMemory || bytes > kMaxMemory) {
    return robotlink::failure("history.memory",
                              "the history needs at least 64 MiB of memory, and at most 1 TiB");
  }
  settings_.set(kMemory, static_cast<double>(bytes) / kMib);
  session_.store().setBytes(bytes);
  return settings_.save();
}

robotlink::Result<void> HistoryKeeper::setDisk(std::uint64_t bytes) {
  settings_.set(kDisk, static_cast<double>(bytes) / kMib);
  if (auto* archive = session_.history().archive()) archive->setLimit(bytes);
  return settings_.save();
}

std::uint64_t HistoryKeeper::memory() const {
  const double least = static_cast<double>(kMinMemory) / kMib, most = static_cast<double>(kMaxMemory) / kMib;
  return bytesOf(std::clamp(settings_.number(kMemory, 1024), least, most));
}

std::uint64_t HistoryKeeper::disk() const {
  return bytesOf(std::clamp(settings_.number(kDisk, 4096), 0.0, 1e9));
}

bool HistoryKeeper::isLosing() const {
  const auto* archive = session_.history().archive();
  return archive != nullptr && archive->isLosing();
}

std::optional<robotlink::Error> HistoryKeeper::takeProblem() {
  if (problem_) return std::exchange(problem_, std::nullopt);
  auto* archive = session_.history().archive();
  return archive ? archive->takeProblem() : std::nullopt;
}

}  // namespace app
