// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "robotlink/base/Error.h"
#include "simcore/Snapshot.h"

namespace app {

/// The snapshots of a simulation that are in memory, by the names that users gave them. Bounded: a further
/// one is refused, so that none is lost unasked. One thread at a time.
class SnapshotShelf {
 public:
  static constexpr std::size_t kMaxSnapshots = 100, kMaxBytes = std::size_t{512} << 20U;

  /// Keeps a snapshot; one of the same name is replaced. Fails if there is no room.
  robotlink::Result<void> keep(const std::string& name, simcore::Snapshot snapshot);
  /// Fails, with the names that there are, if there is none of this name.
  robotlink::Result<const simcore::Snapshot*> find(const std::string& name) const;
  /// Forgets one, or with an empty name all. Fails if there is none of this name.
  robotlink::Result<void> forget(const std::string& name);
  const std::map<std::string, simcore::Snapshot>& all() const { return snapshots_; }

 private:
  std::map<std::string, simcore::Snapshot> snapshots_;
};

}  // namespace app
