// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorRecovery.h"

#include <QLockFile>
#include <string>
#include <system_error>
#include <utility>

namespace widgets {
namespace {

constexpr int kMaxPrograms = 9;

std::filesystem::path fileAt(const std::filesystem::path& folder, int number) {
  return folder / (number == 1 ? "recovery.samples" : "recovery-" + std::to_string(number) + ".samples");
}

/// Renames a file to the first free "NAME-damaged-N.samples" beside it.
std::filesystem::path setAside(const std::filesystem::path& file) {
  for (int number = 1;; ++number) {
    std::filesystem::path aside = file;
    aside.replace_filename(file.stem().string() + "-damaged-" + std::to_string(number) + ".samples");
    std::error_code error;
    if (std::filesystem::exists(aside, error)) continue;
    std::filesystem::rename(file, aside, error);
    return error ? file : aside;
  }
}

}  // namespace

ColorRecovery::ColorRecovery(std::filesystem::path folder, std::function<void(robotlink::Error)> failed)
    : failed_(std::move(failed)),
      worker_([this](const Job& job, const std::stop_token&) { work(job); }, {.finishesJobs = true}) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);  // if this fails, writing fails as well and is reported
  choosePlace(folder);
}

ColorRecovery::~ColorRecovery() = default;

/// Chooses the first unlocked file that was left behind, else the first unlocked name.
void ColorRecovery::choosePlace(const std::filesystem::path& folder) {
  for (int number = 1; number <= kMaxPrograms; ++number) {
    const std::filesystem::path place = fileAt(folder, number);
    std::error_code error;
    const bool left = std::filesystem::exists(place, error);
    if (lock_ && !left) continue;
    auto lock = std::make_unique<QLockFile>(QString::fromStdString(place.string() + ".lock"));
    lock->setStaleLockTime(
        // Locks of dead programs do not count, however new; those of living ones do, however old.
        0);
    if (!lock->tryLock(0)) continue;
    lock_ = std::move(lock);
    file_ = place;
    if (left) return;
  }
  // All are held, or the folder cannot be written: a place that no other program uses, so that nothing is
  // lost.
  if (!lock_) file_ = fileAt(folder, kMaxPrograms + 1);
}

std::optional<robotlink::Result<colortool::ReadSamples>> ColorRecovery::left() {
  std::error_code error;
  if (!lock_ || !std::filesystem::exists(file_, error)) return std::nullopt;
  auto read = colortool::loadSamples(file_);
  if (read && read->problems.empty()) return read;
  const std::string note = "what was there is kept in " + setAside(file_).string();
  if (!read) {
    robotlink::Error damaged = read.error();
    damaged.text += "; " + note;
    return tl::unexpected(damaged);
  }
  read->problems.push_back({"color.recovery-damaged", note, {}, {}});
  return read;
}

void ColorRecovery::work(const Job& job) const {
  if (!job) {
    std::error_code error;
    std::filesystem::remove(file_, error);
    if (error)
      failed_({"color.recovery", "the file cannot be removed: " + error.message(), {}, {file_.string()}});
    return;
  }
  if (const auto saved = colortool::saveSamples(*job, file_); !saved) failed_(saved.error());
}

}  // namespace widgets
