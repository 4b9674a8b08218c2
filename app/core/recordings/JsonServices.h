// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/core/recordings/JobQueue.h"
#include "app/core/recordings/ServiceArgument.h"
#include "robotlink/foxglove/server/Server.h"

namespace app {

/// The encoding of answers that are JSON objects.
inline constexpr char kJsonEncoding[] = "json";

/// Services of a server whose arguments are JSON objects, answered one after the other in a thread of their
/// own. The server may outlive this object, whose destructor withdraws the services and waits for the call in
/// progress: it is the last member of a class whose other members the handlers use.
class JsonServices {
 public:
  /// Answers a call, in the services' thread.
  using Handler =
      std::function<void(const nlohmann::json& argument, const robotlink::websocket::Reply& reply)>;

  explicit JsonServices(std::shared_ptr<robotlink::websocket::Server> server);
  ~JsonServices();
  JsonServices(const JsonServices&) = delete;
  JsonServices& operator=(const JsonServices&) = delete;

  /// Offers a service; a call with another member, or a value of another type, fails.
  void offer(const std::string& name, const std::vector<ArgumentMember>& members, Handler handler,
             robotlink::websocket::ServiceAccess access);
  /// Adds a job that is done after the calls that wait.
  void add(JobQueue::Job job) { jobs_->add(std::move(job)); }

 private:
  const std::shared_ptr<robotlink::websocket::Server> server_;
  std::vector<std::uint32_t> services_;
  /// Outlives this object with the server's handlers.
  const std::shared_ptr<JobQueue> jobs_ = std::make_shared<JobQueue>();
};

}  // namespace app
