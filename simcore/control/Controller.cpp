// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/Controller.h"

#include <algorithm>
#include <stdexcept>

namespace simcore {
namespace {

std::size_t valuesOfShape(const std::vector<int>& shape) {
  std::size_t count = 1;
  for (const int size : shape) count *= static_cast<std::size_t>(size);
  return count;
}

std::string problemOfShape(const DrawnShape& shape) {
  using Kind = DrawnShape::Kind;
  const std::size_t needed = shape.kind == Kind::kLine ? 2 : 1;
  if (shape.points.size() < needed) return "a shape has too few points";
  if (shape.points.size() > ControllerOutput::kMaxPoints) return "a line has more than 10000 points";
  if (shape.text.size() > ControllerOutput::kMaxText) return "a text is longer than 1000 bytes";
  const bool finite = shape.size.allFinite() &&
                      std::ranges::all_of(shape.points, [](const auto& point) { return point.allFinite(); });
  return finite ? "" : "the position of a shape is not finite";
}

}  // namespace

std::string ControllerOutput::problem() const {
  switch (kind) {
    case Kind::kValues:
      if (values.size() != valuesOfShape(info.shape))
        return "it has " + std::to_string(values.size()) + " values instead of " +
               std::to_string(valuesOfShape(info.shape));
      return {};
    case Kind::kImage: {
      const bool isSame = info.shape.size() == 3 && image.height == info.shape[0] &&
                          image.width == info.shape[1] &&
                          robotlink::bytesPerPixel(image.format) == info.shape[2] &&
                          image.data.size() == valuesOfShape(info.shape);
      return isSame ? "" : "its image has a different size or format";
    }
    case Kind::kDrawing:
      if (shapes.size() > kMaxShapes) return "it draws more than 1000 shapes";
      for (const DrawnShape& shape : shapes) {
        if (const std::string wrong = problemOfShape(shape); !wrong.empty()) return wrong;
      }
      return {};
  }
  return {};
}

double ControlledWorld::number(const std::string& path) {
  const auto values = read(path);
  if (!values) throw std::runtime_error(values.error().text);
  if (values->empty()) throw std::runtime_error("'" + path + "' has no value");
  return values->front();
}

void ControlledWorld::command(const std::string& path, std::initializer_list<double> values) {
  const auto done = write(path, std::span(values.begin(), values.size()));
  if (!done) throw std::runtime_error(done.error().text);
}

}  // namespace simcore
