// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/shapes/Footprint.h"

#include <ode/ode.h>

#include <cmath>

namespace simcore {

// Two rectangles are disjoint if they are separated along one of their edges' directions.
bool meet(const Footprint& a, const Footprint& b) {
  const robotlink::Vector2 way = b.center - a.center;
  const double cosine = std::abs(a.along.dot(b.along));
  const double sine = std::abs(a.along.x() * b.along.y() - a.along.y() * b.along.x());
  const auto across = [&](const robotlink::Vector2& axis) {
    return std::abs(axis.x() * way.y() - axis.y() * way.x());
  };
  return std::abs(a.along.dot(way)) <= a.halfLength + b.halfLength * cosine + b.halfWidth * sine &&
         across(a.along) <= a.halfWidth + b.halfLength * sine + b.halfWidth * cosine &&
         std::abs(b.along.dot(way)) <= b.halfLength + a.halfLength * cosine + a.halfWidth * sine &&
         across(b.along) <= b.halfWidth + a.halfLength * sine + a.halfWidth * cosine;
}

Footprint footprintOf(dGeomID geom) {
  Footprint result;
  if (dGeomGetClass(geom) == dBoxClass && dGeomGetRotation(geom)[10] > 1 - 1e-9) {
    const dReal *position = dGeomGetPosition(geom), *rotation = dGeomGetRotation(geom);
    dVector3 edges;
    dGeomBoxGetLengths(geom, edges);
    result.center = {position[0], position[1]};
    result.along = robotlink::Vector2(rotation[0], rotation[4]).normalized();
    result.halfLength = edges[0] / 2;
    result.halfWidth = edges[1] / 2;
    return result;
  }
  dReal b[6];
  dGeomGetAABB(geom, b);
  result.center = {(b[0] + b[1]) / 2, (b[2] + b[3]) / 2};
  result.halfLength = (b[1] - b[0]) / 2;
  result.halfWidth = (b[3] - b[2]) / 2;
  return result;
}

}  // namespace simcore
