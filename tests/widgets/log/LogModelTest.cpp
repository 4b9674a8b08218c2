// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogModel.h"

#include <gtest/gtest.h>

#include <QObject>
#include <optional>
#include <utility>

namespace widgets {
namespace {

using Rows = std::pair<int, int>;

robotlink::Instant second(int count) {
  return robotlink::Instant(std::chrono::seconds(count));
}

/// The first and the last row that are redrawn when another instant is shown.
std::optional<Rows> changedRows(LogModel& model, robotlink::Instant time) {
  std::optional<Rows> rows;
  const auto connection =
      QObject::connect(&model, &LogModel::dataChanged, [&](const QModelIndex& from, const QModelIndex& to) {
        rows = Rows{from.row(), to.row()};
      });
  model.setShown(time);
  QObject::disconnect(connection);
  return rows;
}

TEST(LogModel, textsBetweenTheInstantsAreDrawnAnewWhenAnotherOneIsShown) {
  LogModel model;
  std::vector<LogEntry> entries;
  for (int i = 1; i <= 5; ++i)
    entries.push_back(
        {second(i), LogEntry::Level::kInfo, QStringLiteral("red1"), {}, QStringLiteral("text")});
  model.append(std::move(entries));
  EXPECT_EQ(changedRows(model, second(2)), (Rows{2, 4})) << "the end was shown";
  EXPECT_EQ(changedRows(model, second(4)), (Rows{2, 3}));
  EXPECT_EQ(changedRows(model, second(1)), (Rows{1, 3}));
  EXPECT_EQ(changedRows(model, second(1)), std::nullopt);
}

}  // namespace
}  // namespace widgets
