// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/DeployServices.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/core/platform/JsonOutput.h"
#include "app/core/recordings/ServiceArgument.h"
#include "robotlink/foxglove/protocol/Base64.h"
#include "robotlink/foxglove/security/Digest.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::websocket::ServiceAccess;

constexpr char kJsonEncoding[] = "json";

std::string memberOf(const json& argument, const char* member) {
  const auto found = argument.find(member);
  return found != argument.end() && found->is_string() ? found->get<std::string>() : std::string();
}

json objectOf(const ResourceFolder::Entry& entry) {
  return {{"path", entry.path}, {"bytes", entry.bytes}, {"sha256", entry.sha256}};
}

}  // namespace

DeployServices::DeployServices(std::shared_ptr<robotlink::websocket::Server> server, ResourceFolder folder,
                               Written written, Programs programs)
    : server_(std::move(server)),
      folder_(std::move(folder)),
      written_(std::move(written)),
      programs_(std::move(programs)),
      jobs_(std::make_shared<JobQueue>()) {
  offer("deploy/list", {}, &DeployServices::list, ServiceAccess::kAnybody);
  offer("deploy/put", {{"path"}, {"content"}, {"sha256"}}, &DeployServices::put, ServiceAccess::kControl);
  if (programs_.restart)
    offer("deploy/restart", {{"robot"}, {"layout"}}, &DeployServices::restart, ServiceAccess::kControl);
}

DeployServices::~DeployServices() {
  for (const std::uint32_t service : services_) server_->removeService(service);
  jobs_->close();
}

void DeployServices::offer(const std::string& name, const std::vector<ArgumentMember>& members,
                           Handler handler, ServiceAccess access) {
  services_.push_back(server_->addService(
      jsonService(name, members),
      [this, jobs = jobs_, name, members, handler](const robotlink::websocket::ClientInfo&,
                                                   const robotlink::websocket::ServiceCallRequest& call,
                                                   Reply reply) {
        auto argument = argumentOfCall(name, members, call);
        if (!argument) return reply.fail(argument.error().text);
        jobs->add(
            [this, handler, argument = *std::move(argument), reply] { (this->*handler)(argument, reply); });
      },
      access));
}

void DeployServices::list(const json&, const Reply& reply) {
  const auto entries = folder_.list();
  if (!entries) return reply.fail(entries.error().describe());
  json all = json::array();
  for (const auto& entry : *entries) all.push_back(objectOf(entry));
  json answer{{"files", std::move(all)}};
  if (programs_.list) {
    answer["robots"] = json::array();
    for (const auto& program : programs_.list())
      answer["robots"].push_back(
          {{"robot", program.robot}, {"layout", program.layout}, {"waiting", program.waiting}});
  }
  reply.succeed(jsonMessage(answer), kJsonEncoding);
}

void DeployServices::put(const json& argument, const Reply& reply) {
  const std::string path = memberOf(argument, "path");
  const auto contents = robotlink::websocket::fromBase64(memberOf(argument, "content"));
  if (!contents) return reply.fail("the content of '" + path + "' is not base64");
  if (robotlink::websocket::sha256(*contents) != memberOf(argument, "sha256"))
    return reply.fail("the content of '" + path + "' is not that of its checksum; send it again");
  const auto written = folder_.put(path, *contents);
  if (!written) return reply.fail(written.error().describe());
  if (written_) written_(path);
  reply.succeed(jsonMessage(objectOf(*written)), kJsonEncoding);
}

void DeployServices::restart(const json& argument, const Reply& reply) {
  const std::string robot = memberOf(argument, "robot"), layout = memberOf(argument, "layout");
  std::filesystem::path file;
  if (!layout.empty()) {
    const auto found = folder_.find("layouts/" + layout);
    if (!found) return reply.fail(found.error().describe());
    std::error_code error;
    if (!std::filesystem::is_regular_file(*found, error))
      return reply.fail("there is no layout '" + layout + "' here; deploy it first");
    file = *found;
  }
  programs_.restart(robot, file, [reply](const std::string& why) {
    why.empty() ? reply.succeed("{}", kJsonEncoding) : reply.fail(why);
  });
}

}  // namespace app
