// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/PropertyRule.h"

#include <Eigen/Eigenvalues>
#include <QCoreApplication>
#include <QStringList>
#include <array>
#include <cmath>
#include <string_view>

#include "robotlink/base/Geometry.h"

namespace widgets {
namespace {

constexpr double kMaxAnyNumber = 1e6;

struct NamedRule {
  std::string_view name;
  PropertyRule rule;
};
constexpr std::array kPropertyRules{
    NamedRule{"mass", {0, 1e5, true}},
    NamedRule{"size", {0, 1000, true}},
    NamedRule{"radius", {0, 1000, true}},
    NamedRule{"length", {0, 1000, true}},
    NamedRule{"friction", {0, 1000}},
    NamedRule{"restitution", {0, 1}},
    NamedRule{"noise", {0, 1e5}},
    NamedRule{"delay", {0, 1}},
    NamedRule{"dropout", {0, 1}},
    NamedRule{"rate", {0, 10000}},
    NamedRule{"intensity", {0, 100}},
    NamedRule{"attenuation", {0, 1000}},
    NamedRule{"diffuse", {0, 1}},
    NamedRule{"damping", {0, 1e6}},
    NamedRule{"linear_damping", {0, 100}},
    NamedRule{"angular_damping", {0, 100}},
    NamedRule{"maximum_speed", {0, 1000, true}},
    NamedRule{"maximum_torque", {0, 1000, true}},
    NamedRule{"maximum_force", {0, 1e6, true}},
    NamedRule{"pixels", {2, 8192}},
    NamedRule{"opening_angles", {0.01, 3}},
    NamedRule{"angles", {-2 * robotlink::kPi, 4 * robotlink::kPi}},
    NamedRule{"range", {0, 1000}},
};

struct PropertyTexts {
  Q_DECLARE_TR_FUNCTIONS(PropertyRule)
};

tl::unexpected<robotlink::Error> refuse(const QString& text) {
  return robotlink::failure("scene.property", text.toStdString());
}

/// Whether a body can have these moments of inertia: xx, yy, zz, xy, xz, yz. Those about its principal axes
/// are positive, and none exceeds the sum of the other two, but for rounding.
bool arePossibleMoments(const std::vector<double>& moments) {
  constexpr double kRounding = 1.001;
  Eigen::Matrix3d matrix;
  matrix << moments[0], moments[3], moments[4], moments[3], moments[1], moments[5], moments[4], moments[5],
      moments[2];
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  return principal[0] > 0 && principal[2] <= kRounding * (principal[0] + principal[1]);
}

}  // namespace

PropertyRule propertyRule(const std::string& name) {
  for (const NamedRule& one : kPropertyRules) {
    if (one.name == name) return one.rule;
  }
  return {-kMaxAnyNumber, kMaxAnyNumber};
}

robotlink::Result<std::vector<double>> propertyNumbers(const QString& typed, const std::string& name,
                                                       int count, const QString& title, const QString& unit) {
  const QStringList words = typed.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  if (words.size() != count)
    return refuse((count == 1 ? PropertyTexts::tr("%1 takes %2 number; %3 were typed")
                              : PropertyTexts::tr("%1 takes %2 numbers, separated by blanks; %3 were typed"))
                      .arg(title)
                      .arg(count)
                      .arg(words.size()));
  const PropertyRule rule = propertyRule(name);
  std::vector<double> numbers;
  for (const QString& word : words) {
    bool isNumber = false;
    const double number = word.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(number))
      return refuse(PropertyTexts::tr("%1 is not a number; use a point as the decimal separator").arg(word));
    const bool isTooSmall = rule.isAbove ? number <= rule.minimum : number < rule.minimum;
    if (isTooSmall || number > rule.maximum)
      return refuse((rule.isAbove ? PropertyTexts::tr("%1 must be above %2 and at most %3 %4")
                                  : PropertyTexts::tr("%1 must be from %2 to %3 %4"))
                        .arg(title)
                        .arg(rule.minimum)
                        .arg(rule.maximum)
                        .arg(unit)
                        .trimmed());
    numbers.push_back(number);
  }
  if (name == "inertia" && numbers.size() == 6 && !arePossibleMoments(numbers))
    return refuse(PropertyTexts::tr(
        "These moments of inertia are impossible: about the principal axes they must be positive, and none "
        "may exceed the sum of the other two"));
  return numbers;
}

}  // namespace widgets
