// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/RecoveryFile.h"

#include <QCoreApplication>
#include <QLockFile>
#include <charconv>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace widgets {

RecoveryFile::RecoveryFile(std::filesystem::path folder, std::string suffix,
                           std::function<void(robotlink::Error)> failed)
    : suffix_(std::move(suffix)),
      failed_(std::move(failed)),
      worker_([this](const Write& write, const std::stop_token&) { work(write); }, {.finishesJobs = true}) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);  // if this fails, writing fails as well and is reported
  choosePlace(folder);
}

RecoveryFile::~RecoveryFile() = default;

std::filesystem::path RecoveryFile::fileAt(const std::filesystem::path& folder, int number) const {
  return folder / ("recovery" + (number == 1 ? "" : "-" + std::to_string(number)) + suffix_);
}

/// Chooses the first unlocked file that was left behind, else the first unlocked name.
void RecoveryFile::choosePlace(const std::filesystem::path& folder) {
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
  for (const int number : numbers) {
    if (lock(fileAt(folder, number)) == Locking::kDone) return;
  }
  // The names of programs that run are locked; of these there are few.
  int number = 1;
  while (lock(fileAt(folder, number)) == Locking::kTaken) ++number;
  // If no lock can be made, the folder cannot be written, or has no locks; no other program uses this name.
  if (!lock_)
    file_ =
        folder / ("recovery-" + std::to_string(QCoreApplication::applicationPid()) + ".unlocked" + suffix_);
}

RecoveryFile::Locking RecoveryFile::lock(const std::filesystem::path& place) {
  auto lock = std::make_unique<QLockFile>(QString::fromStdString(place.string() + ".lock"));
  // Locks of dead programs do not count, however new; those of living ones do, however old.
  lock->setStaleLockTime(0);
  if (!lock->tryLock(0))
    return lock->error() == QLockFile::LockFailedError ? Locking::kTaken : Locking::kImpossible;
  lock_ = std::move(lock);
  file_ = place;
  return Locking::kDone;
}

bool RecoveryFile::isLeft() const {
  std::error_code error;
  return lock_ != nullptr && std::filesystem::exists(file_, error);
}

std::filesystem::path RecoveryFile::setAside() const {
  for (int number = 1;; ++number) {
    std::filesystem::path aside = file_;
    aside.replace_filename(file_.stem().string() + "-damaged-" + std::to_string(number) + suffix_);
    std::error_code error;
    if (std::filesystem::exists(aside, error)) continue;
    std::filesystem::rename(file_, aside, error);
    return error ? file_ : aside;
  }
}

void RecoveryFile::work(const Write& write) const {
  if (write) {
    if (const auto saved = write(file_); !saved) failed_(saved.error());
    return;
  }
  std::error_code error;
  std::filesystem::remove(file_, error);
  if (error)
    failed_({"recovery.remove", "the file cannot be removed: " + error.message(), {}, {file_.string()}});
}

}  // namespace widgets
