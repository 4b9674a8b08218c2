// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorRecovery.h"

#include <QCoreApplication>
#include <QLockFile>
#include <charconv>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace widgets {
namespace {

/// The recovery file of a number, counted from 1.
std::filesystem::path fileAt(const std::filesystem::path& folder, int number) {
  return folder / (number == 1 ? "recovery.samples" : "recovery-" + std::to_string(number) + ".samples");
}

/// The numbers of the recovery files in a folder, in order.
std::set<int> numbersIn(const std::filesystem::path& folder) {
  std::set<int> numbers;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    constexpr std::string_view kBegin = "recovery-";
    int number = 1;
    if (name.starts_with(kBegin))
      std::from_chars(name.data() + kBegin.size(), name.data() + name.size(), number);
    // Other names, such as those of damaged files, are not those of their number.
    if (entry.path() == fileAt(folder, number)) numbers.insert(number);
  }
  return numbers;
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
  for (const int number : numbersIn(folder)) {
    if (lock(fileAt(folder, number)) == Locking::kDone) return;
  }
  // The names of programs that run are locked; of these there are few.
  int number = 1;
  while (lock(fileAt(folder, number)) == Locking::kTaken) ++number;
  // If no lock can be made, the folder cannot be written, or has no locks; no other program uses this name.
  if (!lock_)
    file_ = folder / ("recovery-" + std::to_string(QCoreApplication::applicationPid()) + ".unlocked.samples");
}

ColorRecovery::Locking ColorRecovery::lock(const std::filesystem::path& place) {
  auto lock = std::make_unique<QLockFile>(QString::fromStdString(place.string() + ".lock"));
  // Locks of dead programs do not count, however new; those of living ones do, however old.
  lock->setStaleLockTime(0);
  if (!lock->tryLock(0))
    return lock->error() == QLockFile::LockFailedError ? Locking::kTaken : Locking::kImpossible;
  lock_ = std::move(lock);
  file_ = place;
  return Locking::kDone;
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
