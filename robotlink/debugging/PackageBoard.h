// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/debugging/ModeCounter.h"
#include "robotlink/process/Process.h"

namespace robotcontrol {
class StopwatchTimes;
}

namespace robotlink {

class DebugContext;

/// The packages that the tasks of one process read and yield: those received from other processes, those its
/// tasks sent, and which of them are to be published. Used by the process's thread; internal to this folder.
class PackageBoard {
 public:
  /// A package with its ends, as far as the process has them.
  struct Entry {
    std::string name;
    /// The newest package; null before the first.
    PackagePtr value;
    /// The number of packages so far; a change means that value is new.
    std::uint64_t arrivals = 0;
    /// Null unless another process or the platform sends the package.
    std::unique_ptr<AnyReceiver> receiver;
    /// Null unless a task of this process yields the package.
    std::unique_ptr<AnySender> sender;
    /// Whether the platform sends the package, or receives it.
    bool ofPlatform = false;
    /// Whether this process publishes the package on request.
    bool shown = false;
    /// When it is published on request.
    ModeCounter mode;
    /// Whether its key was switched on and it has not been published since.
    bool isAwaited = false;
    /// Published for the recorder in every frame, whatever the mode.
    bool recorded = false;
    /// Whether a user's value can replace the package in this process: it has the sender, or the
    /// receiver of a package that no task sends.
    bool settable = false;
    /// The user's value that replaces all packages, and the one that replaces the next; null:
    /// none.
    PackagePtr held, once;
    /// The newest package of the task while another one was held.
    PackagePtr offered;
    /// The package to be sent again at the end of the frame in which another one was released; null: none.
    PackagePtr restored;
  };

  /// While it exists, notes in `times` the packages that the process had and those that it sends, each with
  /// its own timestamp; packages without one are left out. Made when the first task begins; both arguments
  /// must outlive it. Without one, nothing is noted and nothing is computed.
  class Watch {
   public:
    Watch(PackageBoard& board, robotcontrol::StopwatchTimes& times);
    ~Watch() { board_.watch_ = nullptr; }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    friend class PackageBoard;
    void noteSent(const Entry& entry, const PackagePtr& package);

    PackageBoard& board_;
    robotcontrol::StopwatchTimes& times_;
    std::chrono::steady_clock::time_point begin_;
  };

  PackageBoard(Process& process, DebugContext& debug) : process_(process), debug_(debug) {}

  /// The entry of a package, created if there is none; its address never changes.
  Entry& entry(const std::string& package);
  /// Before the process runs.
  void addReceiver(const std::string& package, Blocking blocking);
  void addSender(const std::string& package, Blocking blocking);

  /// Copies the packages that the receivers took for this frame to the board.
  void beginFrame();
  /// Sends values of the user in whose place no task has sent a package in this frame, and publishes those
  /// packages of earlier frames whose keys were switched on in this one: some are sent rarely.
  void endFrame();
  /// Puts a package of a task on the board, publishes it if requested, and sends it to other processes.
  void send(Entry& entry, const PackagePtr& package);

  /// Sets when a package is published; returns false if this process does not publish it.
  bool show(const std::string& package, const robotcontrol::KeyMode& mode);
  /// From now on publishes exactly these packages for the recorder, if this process is responsible for them.
  void record(const std::set<std::string>& packages);
  /// Whether setOnce(), hold() and release() have an effect here.
  bool isSettable(const std::string& package) const;
  /// Puts a value of the user in place of the next package. It must be of the package's type. Ignored unless
  /// the package is settable here, as are the next two.
  void setOnce(const std::string& package, PackagePtr value);
  /// The same for all packages, until release(). Its timestamp, if that is not set, is that of the frame.
  void hold(const std::string& package, PackagePtr value);
  /// The packages of the task, or of the platform, take their place again.
  void release(const std::string& package);
  /// The packages that this process publishes on request, sorted by name.
  std::vector<const Entry*> shown() const;
  /// Returns whether a package's mode has run out since the last call.
  bool takeModeChange();

 private:
  void put(Entry& entry, PackagePtr package);
  void publish(Entry& entry);
  /// Puts it on the board, and sends it to other processes.
  void pass(Entry& entry, const PackagePtr& package);
  void receive(Entry& entry);
  /// The package, or what a user has put in its place.
  PackagePtr replaced(Entry& entry, const PackagePtr& package);
  PackagePtr stamped(PackagePtr value) const;
  Entry* settable(const std::string& package);
  /// Whether the package is to be published in this frame; counts a use of its mode.
  bool askedFor(Entry& entry);

  Process& process_;
  DebugContext& debug_;
  std::map<std::string, Entry> entries_;
  bool modeChanged_ = false;
  /// Null unless the frame is measured.
  Watch* watch_ = nullptr;
};

}  // namespace robotlink
