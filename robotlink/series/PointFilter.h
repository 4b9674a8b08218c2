// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/series/Series.h"

namespace robotlink {

/// Computes one series from another, point by point, in order of time: some steps, one after the other, as
/// text "derivative | average 0.5". Values that are no numbers pass and are ignored otherwise. One thread.
class PointFilter {
 public:
  using Point = Series::Point;
  /// A kind of step, for menus and help.
  struct Kind {
    /// "average"
    const char* name;
    /// The meaning of its number; null: it has none.
    const char* number;
    /// The number for users who do not choose one.
    double usual = 0;
  };

  /// No steps: all points pass as they are.
  PointFilter() = default;
  /// Fails with the nearest name if there is no such step, or if its number is missing or makes no sense.
  static Result<PointFilter> parse(std::string_view text);
  static const std::vector<Kind>& kinds();

  bool isEmpty() const { return steps_.empty(); }
  /// The point that follows from the next one; empty if none does (yet).
  std::optional<Point> next(Point point);
  /// Forgets the points before.
  void restart();
  /// The unit of the result; `unit` is that of the points.
  std::string unit(std::string unit) const;

 private:
  /// Value times a factor plus an offset.
  struct Linear {
    double factor = 1, offset = 0;
  };
  struct Derivative {
    std::optional<Point> before = {};
  };
  /// Integrates by trapezoids; 0 at the first point.
  struct Integral {
    std::optional<Point> before = {};
    double sum = 0;
  };
  /// The mean, or the median, of the last `length` seconds.
  struct Window {
    double length = 0;  ///< s
    bool isMedian = false;
    std::deque<Point> points = {};
    /// The values in order, for the median.
    std::vector<double> sorted = {};
    double sum = 0;
  };
  /// A low pass of first order.
  struct LowPass {
    double timeConstant = 0;  ///< s
    std::optional<Point> before = {};
  };
  using Step = std::variant<Linear, Derivative, Integral, Window, LowPass>;

  static Result<Step> parseStep(std::string_view text);
  static std::optional<Point> apply(Linear& step, Point point);
  static std::optional<Point> apply(Derivative& step, Point point);
  static std::optional<Point> apply(Integral& step, Point point);
  static std::optional<Point> apply(Window& step, Point point);
  static std::optional<Point> apply(LowPass& step, Point point);

  std::vector<Step> steps_;
};

}  // namespace robotlink
