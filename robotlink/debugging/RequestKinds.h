// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "robotcontrol/Requests.pb.h"

namespace robotlink {

/// The part of the workbench or of a robot's program that fulfills a request.
enum class RequestDoer : std::uint8_t {
  kNobody,        ///< a request that asks for nothing
  kTask,          ///< the process of the robot's program that has the task
  kDebugProcess,  ///< the debug process of the robot's program
  kPlatform,      ///< the robot's platform, whatever its program does
  kSimulation,
  kReplay,
  kRecording
};

/// The effect of a request on a robot's program.
enum class RequestEffect : std::uint8_t {
  kNone,        ///< its behavior and output stay as they are; the request is about other things, or only asks
  kPublishing,  ///< its publications for views
  kBehavior     ///< its behavior
};

/// The properties of all requests of one kind. The table of all kinds is the only place that defines them;
/// code that passes on, stores or describes requests looks them up.
struct RequestKind {
  using Text = std::string (*)(const robotcontrol::Request& request);

  robotcontrol::Request::WhatCase what;
  RequestDoer doer;
  const char* words;  ///< for users: "set debug key"
  RequestEffect effect = RequestEffect::kNone;
  /// Whether it overrides what the robot's layout and files say, and so holds for later programs of the
  /// robot, too, after a reset or in another layout.
  bool isOverride = false;
  /// Whether the next program of the same robot continues with it, such as with a goal, unless the robot was
  /// put back to its start. It does not hold for robots that are opened later.
  bool isContinued = false;
  /// The subject that it sets: of two requests of one kind with the same subject the later one counts, and
  /// holds until there is another. Null: it sets nothing, each request counts.
  Text subject = nullptr;
  /// Returns the problem with the request itself, for any robot; empty if it is valid. Null: always valid.
  Text wrong = nullptr;
  /// The user's choice, for a sentence about its loss: "solution red of task ball". Null or empty:
  /// nothing that would be missed.
  Text choice = nullptr;
  /// The task that it concerns, for RequestDoer::kTask; otherwise null.
  Text task = nullptr;
  /// The file or folder of this machine that it names; empty: none. Only a person here may name one: what
  /// others ask for is refused then. Null: it never names one.
  Text file = nullptr;
  /// Whether it removes what was chosen for its subject instead of choosing. Null: it never does.
  bool (*removes)(const robotcontrol::Request& request) = nullptr;
  /// Whether the program publishes its tables of keys, solutions and processes afterward.
  bool publishesTables = false;

  /// Whether the robot's program fulfills it.
  bool isOfProgram() const { return doer == RequestDoer::kTask || doer == RequestDoer::kDebugProcess; }
};

/// The rows of all kinds, in the order in which overrides are applied to a program.
std::span<const RequestKind> requestKinds();
const RequestKind& kindOf(const robotcontrol::Request& request);

/// Returns "set debug key of red1"; without "of" if the request is for no robot.
std::string inWords(const robotcontrol::Request& request);
/// Returns the problem with the request itself; empty if it is valid.
std::string wrongWith(const robotcontrol::Request& request);
/// Why the request may not come from a remote user, who must not reach files of this machine that no local
/// user has chosen; empty: it may come from anywhere.
std::string wrongFromElsewhere(const robotcontrol::Request& request);
/// Whether a request for STOP engages it; only one that says false releases it.
bool engagesStop(const robotcontrol::Request& request);
/// Whether a color table can be used; one without cells can. Empty: it can.
std::string wrongWith(const robotcontrol::ColorTable& table);
/// Whether both set the same thing, so that the later one replaces the earlier one.
bool setTheSame(const robotcontrol::Request& a, const robotcontrol::Request& b);

/// A row in a table of handlers: a kind of request and its handler, a pointer to a member
/// function. Each fulfiller has one such table; tests/app/RequestFulfillersTest.cpp compares them with the
/// table of kinds.
template <typename Handler>
struct RequestRow {
  robotcontrol::Request::WhatCase what;
  Handler handler;
};
/// The row of a kind of request in such a table; null if there is none.
template <typename Row, std::size_t kSize>
constexpr const Row* rowOf(const Row (&rows)[kSize], robotcontrol::Request::WhatCase what) {
  for (const Row& row : rows) {
    if (row.what == what) return &row;
  }
  return nullptr;
}

/// A range of speeds, times real time.
struct SpeedRange {
  double min, max;
};
/// The speeds at which logs are played, and those at which simulations run; 0 is as fast as possible.
inline constexpr SpeedRange kReplaySpeeds{0.05, 50}, kSimulationSpeeds{0, 100};
/// Says that a speed is not in its range: "the speed must be between 0.05 and 50 times real time". Empty if
/// it is.
std::string wrongSpeed(double speed, const SpeedRange& range);

/// The largest offset of a log on the timeline, s: 100 years. Clocks that begin in 1970 and in a simulation
/// differ by less, and sums of times stay within their range.
inline constexpr double kMaxLogOffset = 100 * 365.25 * 24 * 3600;

/// Ids with this bit are those of requests that repeat what a person chose, for a program that takes the
/// place of another one. Sessions count from 1.
inline constexpr std::uint64_t kRepeatedIds = std::uint64_t{1} << 63U;
inline bool isRepeated(const robotcontrol::Request& request) {
  return (request.id() & kRepeatedIds) != 0;
}

}  // namespace robotlink
