// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/OwnPreview.h"

#include <utility>

#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"

namespace app {

using robotcontrol::WireAnswer;
using robotcontrol::WireOrder;

OwnPreview::OwnPreview(Ask ask, std::function<std::string()> refusal)
    : ask_(std::move(ask)), refusal_(std::move(refusal)) {
  WireOrder order;
  order.set_begin_preview(true);
  ask_(order);
}

std::string OwnPreview::add(const robotcontrol::Request& request) {
  return asked(request, false);
}

bool OwnPreview::answer(const robotcontrol::Request& request) {
  const std::string why = asked(request, true);
  // The program itself says in its queue why it refuses a request.
  if (const std::string gone = refusal_(); !gone.empty()) refuse(request, gone);
  return why.empty();
}

std::shared_ptr<const robotlink::SharedDebugQueue> OwnPreview::takeQueue(robotlink::Instant now) {
  WireOrder order;
  order.set_take_preview(now.time_since_epoch().count());
  const WireAnswer* answer = ask_(order);
  if (answer != nullptr && answer->has_queue()) return robotlink::fromWire(answer->queue());
  return std::exchange(refused_, nullptr);
}

std::string OwnPreview::asked(const robotcontrol::Request& request, bool withResult) {
  WireOrder order;
  *order.mutable_preview()->mutable_request() = request;
  order.mutable_preview()->set_with_result(withResult);
  const WireAnswer* answer = ask_(order);
  return answer != nullptr ? answer->refusal() : refusal_();
}

void OwnPreview::refuse(const robotcontrol::Request& request, const std::string& why) {
  if (!refused_) refused_ = std::make_shared<robotlink::SharedDebugQueue>();
  auto& result = refused_->add<robotcontrol::RequestResult>(robotlink::streams::kResults);
  result.set_id(request.id());
  result.set_reason(why);
}

}  // namespace app
