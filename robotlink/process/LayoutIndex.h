// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "robotlink/process/Layout.h"

namespace robotlink {

/// Who yields and who offers what in a layout; what checks, links and the graph are made from. Only for this
/// folder. What it is made from must outlive it. Unknown tasks are left out.
class LayoutIndex {
 public:
  /// A task in its place.
  struct Place {
    const Layout::Process* process = nullptr;
    const Layout::Task* entry = nullptr;
    const TaskCatalog::Task* task = nullptr;
    std::size_t position = 0;  ///< within its process
  };

  LayoutIndex(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

  const std::vector<Place>& places() const { return places_; }
  /// Null if the layout does not have it.
  const Place* placeOf(const std::string& task) const;
  /// The first task one of whose solutions yields it; null if none does.
  const Place* producer(const std::string& package) const;
  bool platformOffers(const std::string& package) const;
  bool debugOffers(const std::string& package) const;
  /// The debug process; null if there is none.
  const Layout::Process* debugProcess() const;

  /// Why a task in its place cannot have a package that it requires.
  struct Obstacle {
    std::string reason;            ///< "nobody offers oracle/world"; empty: there is no obstacle
    const Place* later = nullptr;  ///< the task of the same process that yields it too late
  };
  Obstacle obstacle(const Place& place, const std::string& package) const;
  /// Why a solution cannot run in its place: its first obstacle's reason.
  std::string obstacle(const Place& place, const TaskCatalog::Solution& solution) const;

  /// What other tasks get of it: without what the layout withholds.
  std::set<std::string> outputsOf(const TaskCatalog::Task& task) const;
  static bool reads(const TaskCatalog::Solution& solution, const std::string& package);
  static bool needs(const TaskCatalog::Solution& solution, const std::string& package);

 private:
  void findOffers();
  bool offered(const std::string& package) const;

  const Layout& layout_;
  const PlatformPackages& platform_;
  std::vector<Place> places_;
  std::map<std::string, std::size_t> producers_;  // by package, into places_
  std::set<std::string> yielded_;                 // packages of solutions that can run
};

}  // namespace robotlink
