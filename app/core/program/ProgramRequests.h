// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/core/program/HostedProgram.h"
#include "app/core/program/ProgramOverrides.h"
#include "robotlink/base/Clock.h"

namespace robotlink {
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

/// The requests to one robot's program, across all programs that are made for the robot: a queue of requests
/// that have no answer yet, the overrides that follow from the accepted ones and are applied to the next
/// program, too, and what a program was about to do that the next one continues with: its goal.
///
/// ask(), takeBack(), hand(), answered() and overrides() may be called from any thread. begin() and
/// answersToCome() may be called only while no process of the program runs; ran() only by the thread that
/// calls these.
class ProgramRequests {
 public:
  /// Called with each request that became an override; it must not call this object.
  using OverrideListener = std::function<void(const robotcontrol::Request&)>;

  /// `overrides` are those of earlier programs of this robot. The listener may be empty.
  explicit ProgramRequests(std::string robot, ProgramOverrides overrides = {}, OverrideListener listener = {})
      : robot_(std::move(robot)), overridden_(std::move(listener)), overrides_(std::move(overrides)) {}

  /// Call this with each new program before it runs. Enqueues requests for the overrides so far and for
  /// what it continues with, followed by the requests that the previous program did not answer; hand() passes
  /// them on. Returns a sentence for each of the former that this program cannot fulfill.
  std::vector<std::string> begin(HostedProgram& program);
  /// The same for a program that was made with the overrides in it: only the requests that the previous
  /// program did not answer are enqueued again.
  void beginOverridden();
  /// Keeps overrides as if the user had made them before; those that were made win. Before begin().
  void choose(const std::vector<robotcontrol::Request>& overrides);
  /// The same, but the overrides replace what was chosen before.
  void replaceChoices(const std::vector<robotcontrol::Request>& overrides);
  /// Enqueues a request of the user. Returns false if too many are waiting already. In a pause, a request
  /// replaces the previous one if both set the same thing.
  bool ask(const robotcontrol::Request& request);
  /// Call this with each request that the user makes, also if nobody can be asked now: the next program
  /// does not continue with what it takes back. Returns whether it takes something back.
  bool takeBack(const robotcontrol::Request& request);
  /// Call this when the robot is put back to its start: the next program continues with nothing.
  void startOver();
  /// The same; what the user chose is replaced by these overrides, and what is not answered is dropped.
  void startOverWith(ProgramOverrides overrides);
  /// Passes the requests that the program has not got yet to `give`, in order, until that returns false; the
  /// others wait for the next call. `give` must not call this object.
  void hand(const std::function<bool(const robotcontrol::Request&)>& give);
  /// Looks for results in a debug queue of the program: these requests are done, and what was accepted
  /// becomes an override.
  void answered(const robotlink::SharedDebugQueue& queue);
  /// Call this when the program has run, since its state no longer is that of the preview.
  void ran() { preview_.reset(); }
  /// Returns the results that the program will give in its next frames, each only once over all calls; null
  /// if there are none. Lets a robot answer at once in a pause.
  std::shared_ptr<const robotlink::SharedDebugQueue> answersToCome(HostedProgram& program,
                                                                   robotlink::Instant now);

  /// A copy of the overrides so far.
  ProgramOverrides overrides() const;

 private:
  /// A request that the program has not answered.
  struct Open {
    robotcontrol::Request request;
    /// The program has got it.
    bool handed = false;
    /// answersToCome() has returned the result of the request.
    bool reported = false;
    /// The request is part of the current preview.
    bool previewed = false;
  };
  /// Whether a request makes the last one in the queue pointless, so that dragging a slider in a pause does
  /// not fill the queue.
  bool replacesLast(const robotcontrol::Request& request) const;
  /// Enqueues a request on behalf of the user, with an id that no session uses.
  void addOwn(robotcontrol::Request request);
  /// Keeps an accepted request if it is an override, or something to continue with.
  void note(const robotcontrol::Request& request);

  const std::string robot_;
  const OverrideListener overridden_;
  /// Used only while no process runs; null if the program has run since.
  std::unique_ptr<ProgramPreview> preview_;
  /// Protects the members below.
  mutable std::mutex mutex_;
  /// In the order of ask().
  std::deque<Open> open_;
  /// Counts the ids that addOwn() assigned.
  std::uint64_t ownRequests_ = 0;
  ProgramOverrides overrides_;
  /// The requests with which the next program continues.
  std::vector<robotcontrol::Request> continued_;
};

}  // namespace app
