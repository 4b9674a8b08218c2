// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/PropertyRule.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>
#include <cmath>
#include <string_view>

namespace widgets {
namespace {

constexpr double kMaxAnyNumber = 1e6;

struct NamedRule {
  std::string_view name;
  PropertyRule rule;
};
constexpr std::array kPropertyRules{
    NamedRule{"mass", {0, 1e5, true}},    NamedRule{"size", {0, 1000, true}},
    NamedRule{"radius", {0, 1000, true}}, NamedRule{"length", {0, 1000, true}},
    NamedRule{"friction", {0, 1000}},     NamedRule{"restitution", {0, 1}},
    NamedRule{"noise", {0, 1e5}},         NamedRule{"delay", {0, 1}},
    NamedRule{"dropout", {0, 1}},         NamedRule{"rate", {0, 10000}},
    NamedRule{"intensity", {0, 100}},     NamedRule{"attenuation", {0, 1000}},
    NamedRule{"diffuse", {0, 1}},
};

struct PropertyTexts {
  Q_DECLARE_TR_FUNCTIONS(PropertyRule)
};

tl::unexpected<robotlink::Error> refuse(const QString& text) {
  return robotlink::failure("scene.property", text.toStdString());
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
    return refuse(PropertyTexts::tr("%1 takes %2 numbers, separated by blanks; %3 were typed")
                      .arg(title)
                      .arg(count)
                      .arg(words.size()));
  const PropertyRule rule = propertyRule(name);
  std::vector<double> numbers;
  for (const QString& word : words) {
    bool isNumber = false;
    const double number = word.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(number))
      return refuse(PropertyTexts::tr("%1 is no number; the decimal point is a point").arg(word));
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
  return numbers;
}

}  // namespace widgets
