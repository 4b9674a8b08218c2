// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/JsonServices.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace app {

using robotlink::websocket::Reply;

JsonServices::JsonServices(std::shared_ptr<robotlink::websocket::Server> server)
    : server_(std::move(server)) {}

JsonServices::~JsonServices() {
  for (const std::uint32_t service : services_) server_->removeService(service);
  jobs_->close();
}

void JsonServices::offer(const std::string& name, const std::vector<ArgumentMember>& members, Handler handler,
                         robotlink::websocket::ServiceAccess access) {
  services_.push_back(server_->addService(
      jsonService(name, members),
      [jobs = jobs_, name, members, handler = std::move(handler)](
          const robotlink::websocket::ClientInfo&, const robotlink::websocket::ServiceCallRequest& call,
          Reply reply) {
        auto argument = argumentOfCall(name, members, call);
        if (!argument) return reply.fail(argument.error().text);
        jobs->add([handler, argument = *std::move(argument), reply] { handler(argument, reply); });
      },
      access));
}

}  // namespace app
