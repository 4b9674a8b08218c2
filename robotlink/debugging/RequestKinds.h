// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "robotcontrol/Requests.pb.h"

namespace robotlink {

/// Who fulfills a request.
enum class RequestDoer : std::uint8_t {
  kNobody,        ///< a request that asks for nothing
  kTask,          ///< the process of the robot's program that has the task
  kDebugProcess,  ///< that of the robot's program
  kPlatform,      ///< the robot's platform, whatever its program does
  kSimulation,
  kReplay,
  kRecording
};

/// What holds for all requests of one kind. The table of all kinds is the one place that says so; whoever
/// passes requests on, keeps them or talks of them looks it up.
struct RequestKind {
  using Text = std::string (*)(const robotcontrol::Request& request);

  robotcontrol::Request::WhatCase what;
  RequestDoer doer;
  const char* words;  ///< for people: "set debug key"
  /// Whether it overrides what the robot's layout and files say, and so holds for later programs of the
  /// robot, too, after a reset or in another layout.
  bool isOverride = false;
  /// What it sets: of two requests of one kind with the same subject the later one counts, and holds until
  /// there is another. Null: it sets nothing, each request counts.
  Text subject = nullptr;
  /// What is wrong with the request itself, whoever is asked; empty: nothing. Null: nothing can be wrong.
  Text wrong = nullptr;
  /// What a person chose by it, for a sentence about the choice being lost: "solution red of task ball". Null
  /// or empty: nothing that would be missed.
  Text choice = nullptr;
};

/// One row for each kind.
std::span<const RequestKind> requestKinds();
const RequestKind& kindOf(const robotcontrol::Request& request);

/// "set debug key of red1"; what is asked of no robot has no "of".
std::string inWords(const robotcontrol::Request& request);
/// What is wrong with the request itself; empty: nothing.
std::string wrongWith(const robotcontrol::Request& request);
/// Whether a color table can be used; one without cells can. Empty: it can.
std::string wrongWith(const robotcontrol::ColorTable& table);
/// Whether both set the same thing, so that the later one takes the place of the one before.
bool setTheSame(const robotcontrol::Request& a, const robotcontrol::Request& b);

/// Ids with this bit are those of requests that repeat what a person chose, for a program that takes the
/// place of another one. Sessions count from 1.
inline constexpr std::uint64_t kRepeatedIds = std::uint64_t{1} << 63U;
inline bool isRepeated(const robotcontrol::Request& request) {
  return (request.id() & kRepeatedIds) != 0;
}

}  // namespace robotlink
