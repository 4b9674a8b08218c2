// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/core/deploy/ResourceFolder.h"
#include "robotlink/base/BoundedQueue.h"

namespace robotlink {
class Session;
}

namespace app {

/// Lets robots use the color tables that were deployed to them: "colortables/red1.c64" is that of red1, from
/// the start, and as soon as a new one was written. One thread, that of Session::tick(), unless it says
/// otherwise; the session must outlive it.
class DeployedTables {
 public:
  DeployedTables(robotlink::Session& session, ResourceFolder folder);

  /// A file was written; any thread.
  void noteWritten(const std::string& path) { written_.push(path); }
  /// Sends the tables of all robots of the session, as far as there are some.
  void begin();
  /// Sends those that were written since the last time. Returns what is wrong with them.
  robotlink::Errors tick();

 private:
  robotlink::Errors use(const std::string& path);

  robotlink::Session& session_;
  const ResourceFolder folder_;
  robotlink::BoundedQueue<std::string> written_{1000};
};

}  // namespace app
