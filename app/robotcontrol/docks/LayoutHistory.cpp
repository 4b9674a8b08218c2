// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/LayoutHistory.h"

#include <QRegularExpression>

#include "app/robotcontrol/docks/ViewDocks.h"

namespace app {
namespace {

constexpr std::size_t kMaxSteps = 50;

/// The parts of a layout that make a step: without sizes, window geometry, and the current tabs.
QString structureOf(const QJsonObject& state) {
  static const QRegularExpression volatileParts(
      QStringLiteral("<Sizes>[^<]*</Sizes>|<Geometry>[^<]*</Geometry>| Current=\"[^\"]*\""));
  return state.value(QStringLiteral("docks")).toString().remove(volatileParts);
}

}  // namespace

LayoutHistory::LayoutHistory(ViewDocks& docks, QObject* parent) : QObject(parent), docks_(docks) {}

QJsonObject LayoutHistory::layout() const {
  return {{QStringLiteral("docks"), docks_.layout()}};
}

void LayoutHistory::look() {
  QJsonObject now = layout();
  if (now == present_) return;
  if (!present_.isEmpty() && structureOf(now) != structureOf(present_)) {
    done_.push_back(present_);
    if (done_.size() > kMaxSteps) done_.erase(done_.begin());
    undone_.clear();
  }
  present_ = std::move(now);
}

void LayoutHistory::forget() {
  done_.clear();
  undone_.clear();
  present_ = layout();
}

void LayoutHistory::keepAll() {
  look();
  done_.push_back(docks_.save());
  undone_.clear();
  present_ = {};
}

void LayoutHistory::step(Steps& from, Steps& to) {
  look();
  while (!from.empty()) {
    const QJsonObject wanted = std::move(from.back());
    from.pop_back();
    QJsonObject before = docks_.save();
    const bool all = wanted.contains(QStringLiteral("views"));
    if (all ? !docks_.restore(wanted) : !docks_.rearrange(wanted.value(QStringLiteral("docks")).toString()))
      continue;
    to.push_back(all ? std::move(before)
                     : QJsonObject{{QStringLiteral("docks"), before.value(QStringLiteral("docks"))}});
    break;
  }
  present_ = layout();
}

}  // namespace app
