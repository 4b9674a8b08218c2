// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/snapshots/SnapshotShelf.h"

namespace app {

robotlink::Result<void> SnapshotShelf::keep(const std::string& name, simcore::Snapshot snapshot) {
  std::size_t others = 0, bytes = snapshot.bytes();
  for (const auto& [other, kept] : snapshots_) {
    if (other == name) continue;
    ++others;
    bytes += kept.bytes();
  }
  if (others >= kMaxSnapshots || bytes > kMaxBytes) {
    return robotlink::failure("snapshot.room",
                              "there is no room for another snapshot: delete one, or write it to a file", {},
                              {name});
  }
  snapshots_[name] = std::move(snapshot);
  return {};
}

robotlink::Result<const simcore::Snapshot*> SnapshotShelf::find(const std::string& name) const {
  const auto found = snapshots_.find(name);
  if (found != snapshots_.end()) return &found->second;
  std::string names;
  for (const auto& [other, kept] : snapshots_) names += (names.empty() ? "" : ", ") + other;
  return robotlink::failure(
      "snapshot.unknown",
      "there is no snapshot '" + name + "'" + (names.empty() ? "; none was taken" : "; there are " + names),
      {}, {name});
}

robotlink::Result<void> SnapshotShelf::forget(const std::string& name) {
  if (name.empty()) {
    snapshots_.clear();
    return {};
  }
  if (const auto found = find(name); !found) return tl::unexpected(found.error());
  snapshots_.erase(name);
  return {};
}

}  // namespace app
