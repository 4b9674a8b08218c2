// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "robotlink/process/Layout.h"

namespace robotlink {

/// An index of a layout: which task produces and which source offers a package. The checks, the links and the
/// graph are derived from it; it is internal to this folder. The constructor's arguments must outlive it.
/// Unknown and repeated tasks are left out.
class LayoutIndex {
 public:
  /// A task at its position in the layout.
  struct Place {
    const Layout::Process* process = nullptr;
    const Layout::Task* entry = nullptr;
    const TaskCatalog::Task* task = nullptr;
    /// Index within its process.
    std::size_t position = 0;
  };

  LayoutIndex(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

  const std::vector<Place>& places() const { return places_; }
  /// Null if the layout does not have the task.
  const Place* placeOf(const std::string& task) const;
  /// The first task with a solution that yields the package; null if there is none.
  const Place* producer(const std::string& package) const;
  bool platformOffers(const std::string& package) const;
  bool debugOffers(const std::string& package) const;
  /// Null if the layout has none.
  const Layout::Process* debugProcess() const;

  /// The reason why a task at its place cannot get a package that it requires.
  struct Obstacle {
    /// A text such as "nobody offers oracle/world"; empty if there is no obstacle.
    std::string reason;
    /// The task of the same process that yields the package too late; null if that is not the reason.
    const Place* later = nullptr;
  };
  Obstacle obstacle(const Place& place, const std::string& package) const;
  /// The reason why a solution cannot run at its place: that of its first obstacle. Empty if it can.
  std::string obstacle(const Place& place, const TaskCatalog::Solution& solution) const;

  /// The packages that other tasks can get from any solution of the task, without those that the layout
  /// withholds.
  std::set<std::string> outputsOf(const TaskCatalog::Task& task) const;
  /// Whether a solution requires or uses a package.
  static bool reads(const TaskCatalog::Solution& solution, const std::string& package);
  /// Whether a solution requires a package.
  static bool needs(const TaskCatalog::Solution& solution, const std::string& package);

 private:
  /// Fills yielded_.
  void findOffers();
  bool offered(const std::string& package) const;

  const Layout& layout_;
  const PlatformPackages& platform_;
  std::vector<Place> places_;
  /// Package to index into places_.
  std::map<std::string, std::size_t> producers_;
  /// Packages of those solutions that can run.
  std::set<std::string> yielded_;
};

}  // namespace robotlink
