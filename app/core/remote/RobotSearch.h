// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/threads/PacedThread.h"
#include "robotlink/dds/RobotDiscovery.h"

namespace app {

/// Looks for robots that announce themselves on the networks of this machine, but only while a user wants
/// to see them, and in a thread of its own, since DDS takes time to begin and to end. One thread uses it,
/// which is never blocked, except by the destructor.
class RobotSearch {
 public:
  /// The listener. Made, used and destroyed in the thread.
  class Source {
   public:
    virtual ~Source() = default;
    /// Returns the robots that are being announced now.
    virtual std::vector<robotlink::dds::AnnouncedRobots> robots() = 0;
    /// The reason why nothing can be heard: a sentence that says what to do. Empty: something can.
    virtual std::string problem() const { return {}; }
  };
  using Open = std::function<std::unique_ptr<Source>()>;
  /// The nodes for an address, as announcementNodes().
  using Nodes = std::function<std::vector<std::shared_ptr<robotlink::dds::Node>>(const std::string& address)>;
  /// Listens on all networks but the loopback interface, also on those that come later.
  static Open onNetworks(Nodes nodes = robotlink::dds::announcementNodes);

  /// A program with its robots, and for how long it has been heard.
  struct Found {
    robotlink::dds::AnnouncedRobots robots;
    robotlink::Duration age{0};
  };
  /// The result of the search so far. A plain value.
  struct State {
    /// Whether it has begun, and for how long it has listened.
    bool isListening = false;
    robotlink::Duration age{0};
    /// Sorted by the names of the robots.
    std::vector<Found> found = {};
    /// The problem of the source.
    std::string problem = {};
  };

  explicit RobotSearch(Open open = onNetworks(), std::shared_ptr<const robotlink::Clock> clock =
                                                     std::make_shared<const robotlink::SteadyClock>());
  /// Waits for the source to end.
  ~RobotSearch() = default;
  RobotSearch(const RobotSearch&) = delete;
  RobotSearch& operator=(const RobotSearch&) = delete;

  /// Listens by another source from the next time on.
  void listenBy(Open open);
  /// Sets whether a user wants to see the robots; initially not.
  void setWanted(bool wanted);
  State state() const;

 private:
  /// When step() is called next: nothing while no user wants to see robots and no source is open.
  std::optional<robotlink::PacedThread::Clock::time_point> due();
  /// Looks for robots, or closes the source if no user wants to see them.
  void step();
  /// Notes what the source hears, unless the search is over meanwhile.
  void note(std::vector<robotlink::dds::AnnouncedRobots> robots, std::string problem);

  const std::shared_ptr<const robotlink::Clock> clock_;
  /// Only the thread's, as is the next.
  std::unique_ptr<Source> source_;
  /// When the source is asked next.
  robotlink::PacedThread::Clock::time_point lookAt_;
  /// Protects all following members but the thread.
  mutable std::mutex mutex_;
  Open open_;
  bool isWanted_ = false, isListening_ = false;
  robotlink::Instant since_;
  /// The programs that are heard, and since when, by URL.
  struct Heard {
    robotlink::dds::AnnouncedRobots robots;
    robotlink::Instant since;
  };
  std::map<std::string, Heard> heard_;
  std::string problem_;
  /// Begun when the search is wanted for the first time. The last member, since it uses the others.
  std::optional<robotlink::PacedThread> thread_;
};

}  // namespace app
