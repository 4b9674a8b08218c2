// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/ClassEdits.h"

#include <algorithm>
#include <vector>

namespace colortool {
namespace {

using robotlink::failure;
using robotlink::Result;

std::vector<NamedColor> named(const ColorClasses& classes) {
  std::vector<NamedColor> result;
  for (int i = 1; i < classes.size(); ++i) result.push_back({classes.name(i), classes.shownColor(i)});
  return result;
}

/// Replaces names or colors; the class numbers stay the same.
Samples withFaces(Samples samples, std::vector<NamedColor> faces) {
  samples.classes = ColorClasses(std::move(faces));
  return samples;
}

/// Replaces the classes; strokes keep the class of the same name.
Samples mappedByName(Samples samples, ColorClasses classes) {
  const auto numbers = classNumbers(samples.classes, classes);
  changeClasses(samples, std::move(classes), numbers);
  return samples;
}

Result<void> checkName(const ColorClasses& classes, const std::string& name) {
  std::string problem = classNameProblem(name);
  if (problem.empty() && classes.index(name) != ColorClasses::kNone)
    problem = "there is a class '" + name + "' already; choose another name";
  if (!problem.empty()) return failure("color.class-name", std::move(problem), {}, {name});
  return {};
}

}  // namespace

std::size_t strokesOf(const Samples& samples, int colorClass) {
  return static_cast<std::size_t>(std::ranges::count_if(
      samples.strokes, [colorClass](const StrokePtr& stroke) { return stroke->colorClass == colorClass; }));
}

std::string freeClassName(const ColorClasses& classes) {
  for (int number = classes.size();; ++number) {
    std::string name = "class " + std::to_string(number);
    if (classes.index(name) == ColorClasses::kNone) return name;
  }
}

Result<Samples> withNewClass(Samples samples, NamedColor added) {
  if (const auto good = checkName(samples.classes, added.name); !good) return tl::unexpected(good.error());
  if (samples.classes.size() > ColorClasses::kMax)
    return failure("color.classes", "there are 255 classes already, and no room for more");
  std::vector<NamedColor> classes = named(samples.classes);
  classes.push_back(std::move(added));
  return withFaces(std::move(samples), std::move(classes));
}

Result<Samples> withRenamedClass(Samples samples, int colorClass, const std::string& name) {
  if (samples.classes.name(colorClass) == name) return samples;
  if (const auto good = checkName(samples.classes, name); !good) return tl::unexpected(good.error());
  std::vector<NamedColor> classes = named(samples.classes);
  classes[static_cast<std::size_t>(colorClass - 1)].name = name;
  return withFaces(std::move(samples), std::move(classes));
}

Samples withRecoloredClass(Samples samples, int colorClass, robotlink::Rgb color) {
  std::vector<NamedColor> classes = named(samples.classes);
  classes[static_cast<std::size_t>(colorClass - 1)].rgb = color;
  return withFaces(std::move(samples), std::move(classes));
}

Samples withoutClass(Samples samples, int colorClass) {
  std::vector<NamedColor> classes = named(samples.classes);
  classes.erase(classes.begin() + colorClass - 1);
  return mappedByName(std::move(samples), ColorClasses(std::move(classes)));
}

Samples withMovedClass(Samples samples, int colorClass, int to) {
  std::vector<NamedColor> classes = named(samples.classes);
  const auto at = [&classes](int number) { return classes.begin() + number - 1; };
  if (colorClass < to)
    std::rotate(at(colorClass), at(colorClass + 1), at(to + 1));
  else
    std::rotate(at(to), at(colorClass), at(colorClass + 1));
  return mappedByName(std::move(samples), ColorClasses(std::move(classes)));
}

Samples withClasses(Samples samples, const ColorClasses& classes) {
  std::vector<NamedColor> used;
  for (int i = 1; i < samples.classes.size(); ++i) {
    if (strokesOf(samples, i) > 0) used.push_back({samples.classes.name(i), samples.classes.shownColor(i)});
  }
  return mappedByName(std::move(samples), unite(classes, ColorClasses(std::move(used))));
}

}  // namespace colortool
