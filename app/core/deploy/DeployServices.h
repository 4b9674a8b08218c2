// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/core/deploy/ResourceFolder.h"
#include "app/core/deploy/RunningPrograms.h"
#include "app/core/recordings/JsonServices.h"
#include "robotlink/foxglove/server/Server.h"

namespace app {

/// Lets clients of a server see and replace the files of a robot's resource folder. Arguments and answers are
/// JSON objects; a call with another member, or a value of another type, fails:
///
/// - `deploy/list`: {"files": [{"path", "bytes", "sha256"}]}, in the order of their paths, and with programs
///   {"robots": [{"robot", "layout", "waiting"}]}: the file of the layout in which the robot's program runs,
///   and the paths of the files that it has not read since they were written
/// - `deploy/put` {"path", "content" (base64), "sha256"}: the file as it is now. Written only if the checksum
///   fits, as a whole or not at all; up to 2 MiB.
/// - with programs `deploy/restart` {"robot", "layout"}: starts the robot's program again, so that it reads
/// the
///   files; in this layout ("own.yaml", one of those here) if it is given and another one.
///
/// Those who may only watch may list, but not put or restart. Files are read and written in a thread of their
/// own. The server may outlive this object, whose destructor withdraws the services.
class DeployServices {
 public:
  /// Called after a file was written, in that thread.
  using Written = std::function<void(const std::string& path)>;
  /// The robots' programs; both functions are called in that thread.
  struct Programs {
    std::function<std::vector<RunningPrograms::Program>()> list;
    /// `done` is called once, from any thread, with the reason why it was not done; empty if it was.
    std::function<void(const std::string& robot, const std::filesystem::path& layout,
                       std::function<void(const std::string& why)> done)>
        restart;
  };

  DeployServices(std::shared_ptr<robotlink::websocket::Server> server, ResourceFolder folder,
                 Written written = {}, Programs programs = {});
  DeployServices(const DeployServices&) = delete;
  DeployServices& operator=(const DeployServices&) = delete;

 private:
  using Reply = robotlink::websocket::Reply;
  using Handler = void (DeployServices::*)(const nlohmann::json& argument, const Reply& reply);

  /// Offers a service that a member function answers.
  void offer(const std::string& name, const std::vector<ArgumentMember>& members, Handler handler,
             robotlink::websocket::ServiceAccess access);
  // The handlers run in the queue's thread.
  void list(const nlohmann::json& argument, const Reply& reply);
  void put(const nlohmann::json& argument, const Reply& reply);
  void restart(const nlohmann::json& argument, const Reply& reply);

  const ResourceFolder folder_;
  const Written written_;
  const Programs programs_;
  /// The last member, since its thread uses the others.
  JsonServices services_;
};

}  // namespace app
