// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/platforms/simulated/world/TrueClasses.h"
#include "robotlink/base/Image.h"
#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/Simulation.h"
#include "simcore/rendering/CameraOptics.h"
#include "simcore/rendering/CameraRenderer.h"

namespace app {

/// Makes the images of a simulation's cameras, those of one instant in several threads: when one is needed,
/// all that are due are made whose cameras were also requested the last time. Images that a
/// delay puts into the past are begun as soon as nothing can change them, by threads that have
/// nothing else to do while the simulation continues. An image does not depend on which others are made, in
/// which order, when, or by how many threads. One thread at a time.
class CameraWork {
 public:
  /// The requested properties of an image.
  struct Order {
    simcore::CameraModel model = {};
    simcore::ImageNoise noise = {};
    simcore::LightAdjustment lighting = {};
    bool blackout = false;
    bool operator==(const Order&) const = default;
  };
  /// Says what the present image of a camera is to be like.
  using Orders = std::function<Order(std::size_t camera)>;
  /// Whether a camera takes an image at a step of the simulation.
  using IsDue = std::function<bool(std::size_t camera, std::uint64_t step)>;

  /// The simulation must outlive it. The pool may be null.
  CameraWork(const simcore::Simulation& simulation, std::shared_ptr<robotlink::ThreadPool> pool,
             bool shadows);
  ~CameraWork();

  /// Call this when the simulation has another scene, or is reset.
  void restart();
  /// Call this when what images are to be like has changed.
  void forgetImages();
  /// Call this when the simulation has jumped to another instant.
  void forgetPast();

  /// Call this after each step of the simulation, and before something changes what images are to be like:
  /// has images be begun that will be asked for.
  void renderAhead(const Orders& orders, const IsDue& isDue);
  /// The number of requested images that had been begun before.
  std::uint64_t begunAhead() const { return begunAhead_; }
  /// Whether it is for the scene that the simulation has now; if not, restart() is due.
  bool isUpToDate() const { return scene_ == simulation_.renderScene(); }

  /// The present image of a camera; valid until the next call.
  const robotlink::Image& image(std::size_t camera, const Orders& orders, const IsDue& isDue);
  /// The same for a person: made alone.
  const robotlink::Image& preview(std::size_t camera, const Orders& orders);
  /// The true classes of the image that was last requested; valid until the next call.
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
  /// The state shared by threads that make images while the simulation continues; it outlives this object.
  struct Studio;
  /// An image that is made before it is requested.
  struct Ahead;
  /// The state of a camera.
  struct Camera {
    Shot shot = {};
    simcore::CameraOptics optics = {};
    /// Null unless one was begun; and the lens of those, which only one at a time uses.
    std::shared_ptr<Ahead> ahead = nullptr;
    std::shared_ptr<simcore::CameraOptics> aheadOptics = nullptr;
    /// The next step at which it takes an image, as far as it is known.
    std::uint64_t nextAt = 0;
    /// The step at which its image was last requested, and whether its true classes were.
    std::uint64_t askedAt = kNever;
    bool asksClasses = false;
  };
  /// The resources with which a thread renders.
  struct Lane {
    /// Shares the poses of the step with those of other lanes.
    std::unique_ptr<simcore::CameraRenderer> renderer = nullptr;
    /// For cameras that see other instants; made when it is needed.
    std::unique_ptr<simcore::CameraRenderer> other = nullptr;
  };
  /// Makes the image of a camera, and those of others that are expected to be asked for.
  void makeTogether(std::size_t camera, const Orders& orders, const IsDue& isDue);
  bool isExpected(std::size_t camera, const IsDue& isDue) const;
  /// Whether an image of a camera may be requested at a step.
  bool mayAskAt(std::size_t camera, std::uint64_t step) const;
  /// The next step at which a camera will be asked; unset if none is known.
  std::optional<std::uint64_t> nextAsk(std::size_t camera, const IsDue& isDue);
  /// Gives up what was begun.
  void forgetAhead(Camera& camera);
  /// Makes an image of what was begun for it; false if it is of no use.
  bool finishAhead(Shot& shot);
  /// Has the renderers draw the present poses.
  void pose();
  bool seesOtherInstants(std::size_t camera, const Order& order) const;
  /// Draws an image; in any thread.
  void draw(Shot& shot, Lane& lane);
  simcore::CameraRenderer& expose(Shot& shot, Lane& lane);

  const simcore::Simulation& simulation_;
  const std::shared_ptr<robotlink::ThreadPool> pool_;
  const bool shadows_;
  std::shared_ptr<const simcore::RenderScene> scene_;
  std::shared_ptr<Studio> studio_;
  std::atomic<std::uint64_t> begunAhead_{0};
  /// The lanes; at least one if there are cameras.
  std::vector<Lane> lanes_;
  std::vector<Camera> cameras_;
  Shot preview_;
  Shot* last_ = nullptr;
  /// Simulation::posesVersion() of the poses that the renderers have.
  std::uint64_t posed_ = kNever;
};

}  // namespace app
