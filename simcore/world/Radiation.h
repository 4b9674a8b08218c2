// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace simcore {

/// A kind of radiation that image sensors sense: light of a color, heat, or anything that surfaces reflect
/// and emit. Any number of classes can be declared. Y, Cb, Cr, R, G and B are always there: where nothing
/// else is said, they are derived from the colors of the materials and from the light that cameras see; in
/// units of gray values, 0 to 255.
///
/// What a sensor sees of a surface is emits + reflects * (ambient + sum over emitters of visibility *
/// intensity / (1 + d^2 * attenuation) * max(0, cos(angle))).
struct RadiationClass {
  std::string name;
  double ambient = 0;
};

/// How much an emitter, or a lamp, emits of a class.
struct ClassIntensity {
  std::string name;
  double intensity = 0;
};

/// The reflection (a factor) and the emission of a surface for a class.
struct SurfaceRadiation {
  std::string name;
  double reflects = 0, emits = 0;
};

/// A point on a link that emits radiation of classes, in all directions. It casts shadows as lamps do.
struct Emitter {
  Eigen::Vector3d positionInLink = Eigen::Vector3d::Zero();
  /// Per square meter.
  double attenuation = 0;
  std::vector<ClassIntensity> classes;
};

/// An emitter in a scene that is drawn.
struct PlacedEmitter {
  /// Index in RenderScene::bodies.
  int body = 0;
  Eigen::Vector3d positionInBody = Eigen::Vector3d::Zero();
  double attenuation = 0;
  /// Keyed by class.
  std::vector<float> intensities;
  /// Index in RenderScene::lamps, whose cone and direction it has; -1 if it emits in all directions.
  int lamp = -1;
};

/// The radiation classes of a scene that is drawn, with the built-in ones that are declared there.
struct SceneRadiation {
  /// The names of declared classes.
  std::vector<std::string> classes;
  /// Keyed by class.
  std::vector<float> ambient;
  /// Lamps (body 0) and emitters.
  std::vector<PlacedEmitter> emitters;
  /// Keyed by instance, then by class.
  struct Surface {
    float reflects = 0, emits = 0;
    /// Whether the surface says what it reflects, so that a built-in class is not derived from its color.
    bool stated = false;
  };
  std::vector<std::vector<Surface>> surfaces;
};

}  // namespace simcore
