// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/core/recordings/JsonServices.h"
#include "app/core/recordings/RecordingFolder.h"
#include "robotlink/foxglove/server/Server.h"

namespace logplayer {
class Recorder;
}

namespace app {

/// Lets clients of a server record into a folder of the robot, and list, read, check and delete what was
/// recorded there. Arguments are JSON objects, and so are the answers, but for that of `read`. A call with
/// another member, or a value of another type, fails:
///
/// - `recordings/list`: {"recordings": [{"name", "bytes", "modified" (seconds since 1970), "recording",
///   "whole"}]}, the newest first; one that is not whole was cut off, as by a crash
/// - `recordings/start`, `recordings/stop`, `recordings/status`: the RecordingStatus
/// - `recordings/read` {"name", "offset", "bytes"}: the bytes, with the encoding "binary"; up to 1 MiB, fewer
///   at the end of the file
/// - `recordings/check` {"name", "bytes"}: {"bytes", "crc32"} of the first bytes; of all without "bytes"
/// - `recordings/delete` {"name"}; not while it is being recorded
///
/// Those who may only watch may not start, stop and delete. Files are read in a thread of their own. The
/// server may outlive this object, whose destructor withdraws the services; the recorder must outlive it.
class RecordingServices {
 public:
  RecordingServices(std::shared_ptr<robotlink::websocket::Server> server, RecordingFolder folder,
                    logplayer::Recorder& recorder);
  RecordingServices(const RecordingServices&) = delete;
  RecordingServices& operator=(const RecordingServices&) = delete;

 private:
  using Reply = robotlink::websocket::Reply;
  /// Answers a call; an exception-free object of the caller's argument.
  using Handler = void (RecordingServices::*)(const nlohmann::json& argument, const Reply& reply);

  /// Offers a service that a member function answers.
  void offer(const std::string& name, const std::vector<ArgumentMember>& members, Handler handler,
             robotlink::websocket::ServiceAccess access = robotlink::websocket::ServiceAccess::kControl);
  // The handlers run in the worker's thread.
  void list(const nlohmann::json& argument, const Reply& reply);
  void read(const nlohmann::json& argument, const Reply& reply);
  void check(const nlohmann::json& argument, const Reply& reply);
  void remove(const nlohmann::json& argument, const Reply& reply);
  void start(const nlohmann::json& argument, const Reply& reply);
  void stop(const nlohmann::json& argument, const Reply& reply);
  void status(const nlohmann::json& argument, const Reply& reply);
  /// A long file is checked in steps, between which others have their turn.
  void continueCheck(const std::string& name, std::uint64_t bytes, RecordingFolder::Checksum before,
                     const Reply& reply);
  /// The name of the file that is being recorded in the folder; empty if there is none.
  std::string recorded() const;

  const RecordingFolder folder_;
  logplayer::Recorder& recorder_;
  /// The last member, since its thread uses the others.
  JsonServices services_;
};

}  // namespace app
