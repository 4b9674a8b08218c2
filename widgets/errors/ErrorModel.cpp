// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/errors/ErrorModel.h"

#include <tuple>

#include "robotlink/base/Geometry.h"

namespace widgets {
namespace {

/// The way in which a unit of messages is shown: its name, factor, and number of decimals.
struct ShownUnit {
  QString name;
  double factor;
};

ShownUnit shownUnit(const std::string& unit) {
  if (unit == "m") return {QStringLiteral("mm"), 1000};
  if (unit == "rad") return {QStringLiteral("°"), 180 / robotlink::kPi};
  if (unit == "s") return {QStringLiteral("ms"), 1000};
  if (unit == robotlink::kShareOfTime) return {ErrorModel::tr("% of the time"), 100};
  return {QStringLiteral("%"), 100};
}

std::optional<double> percentOf(std::size_t part, std::size_t all) {
  if (all == 0) return std::nullopt;
  return 100 * static_cast<double>(part) / static_cast<double>(all);
}

void countIn(ErrorRow& row, const robotlink::ErrorCounts& counts) {
  row.missed = percentOf(counts.missed, counts.there);
  row.invented = percentOf(counts.invented, counts.reported);
}

/// The row of a stream, without a quantity.
ErrorRow rowOf(const robotlink::ErrorSource& source, const robotlink::PackageErrors& errors) {
  ErrorRow row;
  row.source = source;
  row.package = robotlink::TruthErrors::comparedPackage(source.path);
  countIn(row, errors);
  row.latency = 1000 * errors.latency.mean();
  return row;
}

void fillIn(ErrorRow& row, const std::string& quantity, const robotlink::ErrorQuantity& error) {
  const ShownUnit unit = shownUnit(error.unit);
  row.quantity = quantity;
  row.unit = unit.name;
  row.samples = error.amounts.count();
  row.last = unit.factor * error.amounts.last();
  row.mean = unit.factor * error.amounts.mean();
  if (error.unit == robotlink::kShareOfTime) return;
  row.median = unit.factor * error.amounts.quantile(0.5);
  row.ninetyFive = unit.factor * error.amounts.quantile(0.95);
  row.maximum = unit.factor * error.amounts.maximum();
}

/// The number of a cell; unset: there is none.
std::optional<double> statisticOf(const ErrorRow& row, int column) {
  if (column == ErrorModel::kMissed) return row.missed;
  if (column == ErrorModel::kFalse) return row.invented;
  if (column == ErrorModel::kLatency) return row.latency;
  if (column == ErrorModel::kSamples) return static_cast<double>(row.samples);
  if (row.samples == 0) return std::nullopt;
  switch (column) {
    case ErrorModel::kLast:
      return row.last;
    case ErrorModel::kMean:
      return row.mean;
    case ErrorModel::kMedian:
      return row.median;
    case ErrorModel::kNinetyFive:
      return row.ninetyFive;
    case ErrorModel::kMax:
      return row.maximum;
    default:
      return std::nullopt;
  }
}

bool isTextColumn(int column) {
  return column <= ErrorModel::kUnit;
}

}  // namespace

ErrorModel::ErrorModel(QObject* parent)
    : RowModel({tr("Stream"), tr("Solution"), tr("Error"), tr("Unit"), tr("Now"), tr("Mean"), tr("Median"),
                tr("95 %"), tr("Max"), tr("Samples"), tr("Missed %"), tr("False %"), tr("Latency ms")},
               parent) {}

void ErrorModel::setErrors(const robotlink::TruthErrors::Packages& errors) {
  std::vector<ErrorRow> rows;
  for (const auto& [source, package] : errors) {
    const ErrorRow whole = rowOf(source, package);
    if (package.quantities.empty() && package.there + package.reported > 0) rows.push_back(whole);
    for (const auto& [name, quantity] : package.quantities) {
      rows.push_back(whole);
      fillIn(rows.back(), name, quantity);
      countIn(rows.back(), package.countsOf(quantity));
    }
  }
  const auto identity = [](const ErrorRow& row) { return std::tie(row.source, row.quantity); };
  replaceRows(std::move(rows),
              [&](const ErrorRow& a, const ErrorRow& b) { return identity(a) == identity(b); });
}

QVariant ErrorModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ErrorRow& one = row(index.row());
  const int column = index.column();
  if (!isTextColumn(column)) {
    if (role == Qt::TextAlignmentRole) return kNumberAlignment;
    const std::optional<double> number = statisticOf(one, column);
    if (role == kNumberRole) return number.value_or(-1);
    if (role != Qt::DisplayRole) return {};
    return number ? QString::number(*number, 'f', column == kSamples ? 0 : 1) : QString();
  }
  if (role == Qt::ToolTipRole && column == kStream) return QString::fromStdString(one.source.path);
  if (role != Qt::DisplayRole && role != kNumberRole) return {};
  switch (column) {
    case kStream:
      return QString::fromStdString(one.package);
    case kSolution: {
      const QString solution = QString::fromStdString(one.source.solution);
      return one.isShadow() ? tr("%1 (shadow)").arg(solution) : solution;
    }
    case kError:
      return QString::fromStdString(one.quantity);
    default:
      return one.unit;
  }
}

QVariant ErrorModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::ToolTipRole)
    return RowModel::headerData(section, orientation, role);
  switch (section) {
    case kSolution:
      return tr("The solution that published it, or one that runs in its shadow");
    case kError:
      return tr(
          "What is compared; relative errors are fractions of the distance, delays the time until an event "
          "is reported");
    case kLast:
      return tr("The newest error");
    case kMedian:
      return tr("Median error");
    case kNinetyFive:
      return tr("95th percentile of the errors");
    case kMissed:
      return tr("Share of the real objects and events that were not reported");
    case kFalse:
      return tr("Share of the reports that did not match a real object or event");
    case kLatency:
      return tr(
          "Mean time from a sensor reading until a result based on it was published, on the robot's clock");
    default:
      return {};
  }
}

}  // namespace widgets
