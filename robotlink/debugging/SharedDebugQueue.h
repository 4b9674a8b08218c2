// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace robotcontrol {
class DebugQueue;
}

namespace robotlink {

/// A message of a debug queue inside a program: what robotcontrol.DebugMessage is in a file or on a wire, but
/// its content is shared by all owners, so that nothing is copied or serialized.
struct SharedDebugMessage {
  std::string path;  ///< below the robot's name, see Streams.h
  /// The time of the message; unset if it came over a link and had no valid time.
  std::optional<Instant> time;
  /// A text, drawing, image, table, ..., or any package. Null: it came over a link and had none.
  PackagePtr content;
  /// Published because of a RecordPackages request; no one asked to see it.
  bool onlyRecorded = false;

  /// The content, if it is of type T, else null.
  template <typename T>
  const T* as() const {
    return dynamic_cast<const T*>(content.get());
  }
};

/// A debug queue inside a program: the messages of one or several whole frames of a process, in order, each
/// frame with its robotcontrol.FrameInfo last. It is filled by one thread, then handed on and never changed.
///
/// Only what leaves the program becomes bytes: toWire() gives the robotcontrol.DebugQueue of the same
/// contents, fromWire() is the way back.
struct SharedDebugQueue {
  std::string process;
  std::uint64_t dropped = 0;       ///< messages, since the process started
  std::uint64_t number = 0;        ///< of the queues of this process, from 1
  std::uint64_t requestsDone = 0;  ///< the number of the last request that took effect
  std::uint64_t requestDone = 0;   ///< the id of this request
  std::vector<SharedDebugMessage> messages;

  /// Adds a message with an empty content, which the caller fills in before the queue is handed on.
  template <typename T>
  T& add(std::string path, std::optional<Instant> time = {}) {
    auto content = std::make_shared<T>();
    T& result = *content;
    messages.push_back({std::move(path), time, std::move(content)});
    return result;
  }
};

/// The form in which a queue leaves the program. A content that DebugMessage has a field for is in that
/// field, any other is a PackageCopy.
robotcontrol::DebugQueue toWire(const SharedDebugQueue& queue);
/// The contents are moved, not copied. A PackageCopy is parsed into its type; it stays a PackageCopy if the
/// program does not know the type or the bytes do not fit. Any queue is accepted: times that are out of range
/// and contents that are missing are left out.
std::shared_ptr<const SharedDebugQueue> fromWire(robotcontrol::DebugQueue queue);

// A debug queue on its way from process to process ("debug/queue/<process>") is an ordinary package of the
// type robotcontrol.DebugQueue. Inside a program the package has the queue with it; its own fields but the
// messages are filled in.
PackagePtr packageOf(std::shared_ptr<const SharedDebugQueue> queue);
/// The queue of such a package, or of one that came over a link.
std::shared_ptr<const SharedDebugQueue> queueIn(const PackagePtr& package);
/// Returns what a link writes for a package: a package that owns its contents is replaced by its wire form.
PackagePtr wireForm(const PackagePtr& package);

}  // namespace robotlink
