// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/overview/GlanceSubscription.h"

#include <algorithm>

#include "robotlink/debugging/Streams.h"
#include "widgets/PackageSubscription.h"
#include "widgets/Requests.h"

namespace widgets {
namespace {

using robotcontrol::KeyMode;

/// Null if the robot has no such key, or has not said so yet.
const robotcontrol::KeyTable::Key* findKey(robotlink::Session& session, const std::string& robot,
                                           const std::string& name) {
  const auto* table = session.store().latestAs<robotcontrol::KeyTable>(
      robot + '/' + robotlink::streams::kKeys, session.timeline().newest());
  if (table == nullptr) return nullptr;
  const auto found = std::ranges::find(table->keys(), name, [](const auto& key) { return key.name(); });
  return found == table->keys().end() ? nullptr : &*found;
}

void setMode(robotlink::Session& session, const std::string& robot, const std::string& key,
             KeyMode::Kind kind) {
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(kind);
  if (kind == KeyMode::EVERY_MS) request.mutable_set_key()->mutable_mode()->set_n(kGlanceMs);
  // Like other subscriptions, this one ignores keys that cannot be switched.
  ask(session, robot, std::move(request), nullptr, [](bool, const QString&) {});
}

}  // namespace

void GlanceSubscription::want(robotlink::Session& session, const std::string& robot,
                              std::initializer_list<const char*> packages) {
  for (const char* package : packages) {
    const std::string name = std::string("package/") + package;
    if (settled_.contains({robot, name})) continue;
    const auto* key = findKey(session, robot, name);
    if (key == nullptr) continue;
    settled_.insert({robot, name});
    if (key->mode().kind() != KeyMode::OFF) continue;
    requested_.insert({robot, name});
    setMode(session, robot, name, KeyMode::EVERY_MS);
  }
}

void GlanceSubscription::release(robotlink::Session& session) {
  for (const auto& [robot, name] : requested_) {
    const auto* key = findKey(session, robot, name);
    if (key != nullptr && isGlance(key->mode())) setMode(session, robot, name, KeyMode::OFF);
  }
  requested_.clear();
  settled_.clear();
}

}  // namespace widgets
