// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramRequests.h"

#include <algorithm>

#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"

namespace app {

using robotcontrol::Request;

namespace {

/// The maximum number of open requests.
constexpr std::size_t kMaxOpen = 1000;
/// Names the user's choice in a request, for a message that it was lost; empty if it does not matter.
std::string choiceOf(const Request& request) {
  const robotlink::RequestKind& kind = robotlink::kindOf(request);
  return kind.choice != nullptr ? kind.choice(request) : std::string();
}

}  // namespace

std::vector<std::string> ProgramRequests::begin(HostedProgram& program) {
  const std::lock_guard lock(mutex_);
  preview_.reset();
  // Requests whose acceptance was reported are among the overrides already.
  std::deque<Open> asked = std::exchange(open_, {});
  std::erase_if(asked, [](const Open& open) { return open.reported || robotlink::isRepeated(open.request); });
  std::vector<std::string> lost;
  const auto preview = program.preview();
  std::vector<Request> own = overrides_.requests(robot_);
  own.insert(own.end(), continued_.begin(), continued_.end());
  for (Request& request : own) {
    const std::string why = preview->add(request);
    if (why.empty()) {
      addOwn(std::move(request));
      continue;
    }
    if (const std::string what = choiceOf(request); !what.empty())
      lost.push_back(robot_ + " could not keep " + what + ": " + why);
    std::erase_if(continued_, [&](const Request& before) { return robotlink::setTheSame(before, request); });
  }
  for (Open& open : asked) open_.push_back({std::move(open.request)});
  return lost;
}

void ProgramRequests::choose(const std::vector<Request>& overrides) {
  const std::lock_guard lock(mutex_);
  for (const Request& request : overrides) {
    if (!overrides_.contains(request)) overrides_.note(request);
  }
}

void ProgramRequests::replaceChoices(const std::vector<Request>& overrides) {
  const std::lock_guard lock(mutex_);
  for (const Request& request : overrides) overrides_.note(request);
}

void ProgramRequests::beginOverridden() {
  const std::lock_guard lock(mutex_);
  preview_.reset();
  for (Open& open : open_) open.handed = open.previewed = false;
}

void ProgramRequests::note(const Request& request) {
  if (overrides_.note(request) && overridden_) overridden_(request);
  const robotlink::RequestKind& kind = robotlink::kindOf(request);
  if (!kind.isContinued) return;
  std::erase_if(continued_, [&](const Request& before) { return robotlink::setTheSame(before, request); });
  if (!kind.removes(request)) continued_.push_back(request);
}

bool ProgramRequests::takeBack(const Request& request) {
  const std::lock_guard lock(mutex_);
  return std::erase_if(continued_, [&](const Request& before) {
           return robotlink::setTheSame(before, request) && robotlink::kindOf(request).removes(request);
         }) > 0;
}

void ProgramRequests::startOver() {
  const std::lock_guard lock(mutex_);
  continued_.clear();
}

void ProgramRequests::startOverWith(ProgramOverrides overrides) {
  const std::lock_guard lock(mutex_);
  continued_.clear();
  open_.clear();
  overrides_ = std::move(overrides);
}

void ProgramRequests::addOwn(Request request) {
  request.set_id(robotlink::kRepeatedIds | ++ownRequests_);
  open_.push_back({std::move(request)});
}

bool ProgramRequests::replacesLast(const Request& request) const {
  return !open_.empty() && open_.back().reported && !open_.back().handed &&
         robotlink::setTheSame(open_.back().request, request);
}

bool ProgramRequests::ask(const Request& request) {
  const std::lock_guard lock(mutex_);
  if (replacesLast(request)) open_.pop_back();
  if (open_.size() >= kMaxOpen) return false;
  open_.push_back({request});
  return true;
}

void ProgramRequests::hand(const std::function<bool(const Request&)>& give) {
  const std::lock_guard lock(mutex_);
  for (Open& open : open_) {
    if (open.handed) continue;
    if (!give(open.request)) break;
    open.handed = true;
    // Without an id no result will come.
    if (open.request.id() == 0) note(open.request);
  }
  std::erase_if(open_, [](const Open& open) { return open.handed && open.request.id() == 0; });
}

void ProgramRequests::answered(const robotlink::SharedDebugQueue& queue) {
  const std::lock_guard lock(mutex_);
  if (open_.empty()) return;
  for (const auto& message : queue.messages) {
    const auto* result = message.as<robotcontrol::RequestResult>();
    if (result == nullptr) continue;
    const auto found =
        std::ranges::find_if(open_, [&](const Open& open) { return open.request.id() == result->id(); });
    if (found == open_.end()) continue;
    if (result->accepted() && !found->reported && !robotlink::isRepeated(found->request))
      note(found->request);
    open_.erase(found);
  }
}

std::shared_ptr<const robotlink::SharedDebugQueue> ProgramRequests::answersToCome(HostedProgram& program,
                                                                                  robotlink::Instant now) {
  const std::lock_guard lock(mutex_);
  if (std::ranges::all_of(open_, [](const Open& open) { return open.reported; })) return nullptr;
  if (!preview_) {
    preview_ = program.preview();
    for (Open& open : open_) open.previewed = false;
  }
  for (Open& open : open_) {
    if (std::exchange(open.previewed, true)) continue;
    if (std::exchange(open.reported, true)) {
      preview_->add(open.request);
    } else if (preview_->answer(open.request) && !robotlink::isRepeated(open.request)) {
      note(open.request);
    }
  }
  return preview_->takeQueue(now);
}

ProgramOverrides ProgramRequests::overrides() const {
  const std::lock_guard lock(mutex_);
  return overrides_;
}

}  // namespace app
