// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/PackageSubscription.h"

#include <algorithm>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

constexpr std::size_t kTables = 64;  // upper bound of remembered key tables

}  // namespace

bool isGlance(const robotcontrol::KeyMode& mode) {
  return mode.kind() == robotcontrol::KeyMode::EVERY_MS && mode.n() == kGlanceMs;
}

void PackageSubscription::want(robotlink::Session& session, const std::string& robot,
                               std::span<const char* const> packages) {
  if (const auto generation = session.store().generation(); generation != generation_) {
    generation_ = generation;
    settled_.clear();
    seen_.clear();
    refused_ = std::make_shared<std::set<std::string>>();
    patience_ = kFirstPatience;
  }
  tryAgain();
  const auto* message =
      session.store().latest(robot + '/' + robotlink::streams::kKeys, session.timeline().newest());
  if (message == nullptr || !seen_.insert(message->value).second) return;
  const auto* table = dynamic_cast<const robotcontrol::KeyTable*>(message->value.get());
  if (table == nullptr) return;
  if (seen_.size() > kTables) seen_ = {message->value};
  for (const char* package : packages) {
    const std::string name = std::string("package/") + package;
    const auto key = std::ranges::find(table->keys(), name, [](const auto& entry) { return entry.name(); });
    if (key == table->keys().end() || !settled_.insert(robot + '/' + package).second) continue;
    if (key->mode().kind() != robotcontrol::KeyMode::OFF && !isGlance(key->mode())) continue;
    robotcontrol::Request request;
    request.mutable_set_key()->set_name(name);
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    request.set_robot(robot);
    // In a replay the table may be that of a program that does not run. The user need not know that its key
    // cannot be switched on, so refusals are not reported.
    session.request(std::move(request), [refused = refused_, path = robot + '/' + package](
                                            const robotcontrol::RequestResult& result) {
      if (!result.accepted()) refused->insert(path);
    });
  }
}

void PackageSubscription::tryAgain() {
  if (refused_->empty() || ++calls_ < patience_) return;
  calls_ = 0;
  patience_ = std::min(2 * patience_, kMaxPatience);
  for (const std::string& path : *refused_) settled_.erase(path);
  refused_->clear();
  seen_.clear();
}

}  // namespace widgets
