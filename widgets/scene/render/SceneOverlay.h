// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSizeF>
#include <vector>

class QPainter;

// Paints labels and axes over a picture of a scene. Pure functions.
namespace widgets {

struct SceneCamera;
struct SceneLabel;

/// Paints texts at their places; those behind the camera are left out.
void paintLabels(QPainter& painter, const QSizeF& widget, const SceneCamera& camera,
                 const std::vector<SceneLabel>& labels);
/// Paints the directions of the field's x, y and z in the lower left corner.
void paintAxes(QPainter& painter, const QSizeF& widget, const SceneCamera& camera);

}  // namespace widgets
