// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/ContainerFile.h"

#include <map>
#include <mutex>
#include <tuple>

namespace logplayer {

using robotlink::Result;

namespace {

constexpr char kName[] = "log.mcap";

/// Replaces the copy's name in an error by that of the log, since the copy is about to be removed.
robotlink::Error named(robotlink::Error error, const std::filesystem::path& log,
                       const std::filesystem::path& folder) {
  if (error.where.file != (folder / kName).string()) return error;
  const std::string reason = error.arguments.empty() ? error.text : error.arguments.front();
  return {"log.temporary",
          "logs of older formats are converted to MCAP for reading, which failed in " +
              folder.parent_path().string() + ": " + reason + "; set TMPDIR to another place",
          {reason},
          {log.string(), 0, 0}};
}

}  // namespace

/// The converted copies that are in use.
class ContainerFile::Copies {
 public:
  /// Identifies the current state of a file: after a change it is another one.
  using Key = std::tuple<std::filesystem::path, std::uintmax_t, std::filesystem::file_time_type>;

  static Copies& all() {
    static Copies copies;
    return copies;
  }
  static Key keyOf(const std::filesystem::path& log) {
    std::error_code error;  // ignored: a file that does not exist has a key, too
    return {std::filesystem::weakly_canonical(log, error), std::filesystem::file_size(log, error),
            std::filesystem::last_write_time(log, error)};
  }
  std::shared_ptr<const Copy> find(const Key& key) {
    const std::lock_guard lock(mutex_);
    const auto found = copies_.find(key);
    return found == copies_.end() ? nullptr : found->second.lock();
  }
  void add(const Key& key, const std::shared_ptr<const Copy>& copy) {
    const std::lock_guard lock(mutex_);
    std::erase_if(copies_, [](const auto& entry) { return entry.second.expired(); });
    copies_[key] = copy;
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::weak_ptr<const Copy>> copies_;
};

Result<ContainerFile> ContainerFile::of(const std::filesystem::path& log, const Progress& progress) {
  if (!canImport(log)) return ContainerFile(log, nullptr);
  const Copies::Key key = Copies::keyOf(log);
  std::shared_ptr<const Copy> copy = Copies::all().find(key);
  if (copy == nullptr) {
    auto made = convert(log, progress);
    if (!made) return tl::unexpected(made.error());
    copy = std::move(*made);
    Copies::all().add(key, copy);
  }
  std::filesystem::path path = copy->folder.path() / kName;
  return ContainerFile(std::move(path), std::move(copy));
}

Result<std::shared_ptr<const ContainerFile::Copy>> ContainerFile::convert(const std::filesystem::path& log,
                                                                          const Progress& progress) {
  auto folder = TemporaryFolder::make();
  if (!folder) return tl::unexpected(folder.error());
  ImportOptions options;
  options.progress = progress;
  auto report = importLog(log, folder->path() / kName, options);
  if (!report) return tl::unexpected(named(report.error(), log, folder->path()));
  return std::make_shared<const Copy>(Copy{std::move(*folder), std::move(*report)});
}

}  // namespace logplayer
