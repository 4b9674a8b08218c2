// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

#include "widgets/View.h"

namespace app {

/// Takes the place of a view that has thrown an exception, states that, and keeps the view's state for the
/// next start. GUI thread.
class FailedView final : public widgets::View {
  Q_OBJECT
 public:
  FailedView(widgets::ViewContext& context, const QString& reason, QJsonObject state, QWidget* parent);
  void tick() override {}
  QJsonObject saveState() const override { return state_; }
  void restoreState(const QJsonObject& state) override { state_ = state; }
  void followNames(const Renamed& renamed) override { state_ = renamed(QJsonValue(state_)).toObject(); }

 private:
  QJsonObject state_;
};

}  // namespace app
