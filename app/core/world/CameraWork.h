// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "app/core/world/TrueClasses.h"
#include "robotlink/base/Image.h"
#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/Simulation.h"
#include "simcore/rendering/CameraOptics.h"
#include "simcore/rendering/CameraRenderer.h"

namespace app {

/// Makes the images of a simulation's cameras, those of one instant in several threads: when one is asked
/// for, all that are due are made, as far as their cameras were asked at the last time, too. An image does
/// not depend on which others are made, in which order, or by how many threads. One thread at a time.
class CameraWork {
 public:
  /// What an image is to be like.
  struct Order {
    simcore::CameraModel model = {};
    simcore::ImageNoise noise = {};
    simcore::LightAdjustment lighting = {};
    bool blackout = false;
  };
  /// Says what the present image of a camera is to be like.
  using Orders = std::function<Order(std::size_t camera)>;
  /// Whether a camera takes an image at this step.
  using IsDue = std::function<bool(std::size_t camera)>;

  /// The simulation must outlive it. The pool may be null.
  CameraWork(const simcore::Simulation& simulation, std::shared_ptr<robotlink::ThreadPool> pool,
             bool shadows);

  /// To be called when the simulation has another scene, or is reset.
  void restart();
  /// To be called when what images are to be like has changed, or the simulation has gone back to an instant.
  void forgetImages();

  /// The present image of a camera; valid until the next call.
  const robotlink::Image& image(std::size_t camera, const Orders& orders, const IsDue& isDue);
  /// The same for a person: made alone.
  const robotlink::Image& preview(std::size_t camera, const Orders& orders);
  /// The true classes of the image that was asked for last; valid until the next call.
  const robotlink::Image& trueClasses();

 private:
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  /// An image of a camera.
  struct Shot {
    std::size_t camera = 0;
    Order order = {};
    robotlink::Image image = {}, classes = {};
    /// The step at which it was made and not yet asked for.
    std::uint64_t step = kNever;
    bool hasClasses = false;
  };
  /// What is known of a camera.
  struct Camera {
    Shot shot = {};
    simcore::CameraOptics optics = {};
    /// When its image was asked for last, and whether its true classes were.
    std::uint64_t askedAt = kNever;
    bool asksClasses = false;
  };
  /// What a thread renders with.
  struct Lane {
    /// Shares the poses of the step with those of other lanes.
    std::unique_ptr<simcore::CameraRenderer> renderer = nullptr;
    /// For cameras that see other instants; made when it is needed.
    std::unique_ptr<simcore::CameraRenderer> other = nullptr;
  };
  /// Makes the image of a camera, and those of others that are expected to be asked for.
  void makeTogether(std::size_t camera, const Orders& orders, const IsDue& isDue);
  bool isExpected(std::size_t camera, const IsDue& isDue) const;
  /// Has the renderers draw the present poses.
  void pose();
  bool seesOtherInstants(std::size_t camera, const Order& order) const;
  /// Draws an image; in any thread.
  void draw(Shot& shot, Lane& lane);
  simcore::CameraRenderer& expose(Shot& shot, Lane& lane);

  const simcore::Simulation& simulation_;
  const std::shared_ptr<robotlink::ThreadPool> pool_;
  const bool shadows_;
  TrueClasses classes_;
  /// At least one if there are cameras.
  std::vector<Lane> lanes_;
  std::vector<Camera> cameras_;
  Shot preview_;
  Shot* last_ = nullptr;
  /// The step whose poses the renderers have.
  std::uint64_t posed_ = kNever;
};

}  // namespace app
