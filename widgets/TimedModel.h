// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

#include "robotlink/base/Clock.h"
#include "widgets/TitledModel.h"

namespace widgets {

/// A table with fixed titles whose rows are things that happened, each with a `time`, in the order of their
/// times; the first column shows the time. Memory is bounded: beyond `capacity` rows the oldest are removed,
/// a hundredth of the capacity at a time, so that a full table costs no more than an empty one. GUI thread.
template <typename Entry>
class TimedModel : public TitledModel {
 public:
  /// Appends entries that are not earlier than those in the table, as one insertion.
  void append(std::vector<Entry> entries) {
    if (entries.size() > capacity_)
      entries.erase(entries.begin(), entries.end() - static_cast<std::ptrdiff_t>(capacity_));
    if (entries.empty()) return;
    const std::size_t wanted = entries_.size() + entries.size();
    if (wanted > capacity_)
      removeFirst(std::min(entries_.size(), std::max(wanted - capacity_, capacity_ / 100)));
    const int first = rowCount();
    beginInsertRows({}, first, first + static_cast<int>(entries.size()) - 1);
    for (Entry& entry : entries) {
      count(entry);
      entries_.push_back(std::move(entry));
    }
    endInsertRows();
  }
  virtual void clear() {
    beginResetModel();
    entries_.clear();
    endResetModel();
  }
  const Entry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  /// The last row not later than `time`; -1 if there is none.
  int rowAt(robotlink::Instant time) const {
    const auto later =
        std::upper_bound(entries_.begin(), entries_.end(), time,
                         [](robotlink::Instant instant, const Entry& entry) { return instant < entry.time; });
    return static_cast<int>(later - entries_.begin()) - 1;
  }
  /// Sets the instant that the first column shows as 0 s.
  void setOrigin(robotlink::Instant time) {
    if (std::exchange(origin_, time) == time || entries_.empty()) return;
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, 0));
  }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(entries_.size());
  }

 protected:
  TimedModel(QStringList titles, std::size_t capacity, QObject* parent)
      : TitledModel(std::move(titles), parent), capacity_(capacity) {}
  /// Called with each entry before it is appended by append(), and with each that removeFirst() removes.
  virtual void count(Entry&) {}
  virtual void discount(const Entry&) {}
  void removeFirst(std::size_t number) {
    if (number == 0) return;
    beginRemoveRows({}, 0, static_cast<int>(number) - 1);
    const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(number);
    for (auto entry = entries_.begin(); entry != end; ++entry) discount(*entry);
    entries_.erase(entries_.begin(), end);
    endRemoveRows();
  }

  const std::size_t capacity_;
  std::deque<Entry> entries_;
  robotlink::Instant origin_;
};

}  // namespace widgets
