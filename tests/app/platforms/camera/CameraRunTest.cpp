// SPDX-License-Identifier: GPL-3.0-or-later
// A camera with the program that sees its images.
#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "app/core/platform/PlatformAdapter.h"
#include "app/platforms/camera/CameraOptions.h"
#include "app/platforms/real/RealRun.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/session/QueueMessages.h"
#include "tests/Eventually.h"
#include "tests/app/platforms/camera/FakeCamera.h"

namespace app {
namespace {

class CameraRunTest : public testing::Test {
 protected:
  CameraRunTest() {
    camera_.width = 64, camera_.height = 48;
    camera_.formats = {V4L2_PIX_FMT_YUYV};
  }
  void open(const std::string& url = "camera:///dev/video0") {
    RealRun::Listeners listeners;
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      const std::lock_guard lock(mutex_);
      for (const auto& message : robotlink::messagesOf(robot, *queue, {}).messages) {
        paths_.insert(message.path);
        if (message.path == "camera/camera/settings")
          settings_ = std::dynamic_pointer_cast<const robotcontrol::CameraSettings>(message.value);
      }
    };
    listeners.platform = [this](const std::string&, robotlink::Instant, const std::string& text) {
      const std::lock_guard lock(mutex_);
      reports_ += text + "\n";
    };
    listeners.problem = [this](const std::string&, robotlink::Instant, const std::string& text) {
      const std::lock_guard lock(mutex_);
      problems_ += text + "\n";
    };
    auto run = RealRun::create(cameraOptions(url, camera_), listeners);
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
    for (const char* key : {"package/camera/image", "package/camera/settings", "package/camera/pose",
                            "package/percepts/regions"}) {
      robotcontrol::Request request;
      request.set_robot("camera");
      request.mutable_set_key()->set_name(key);
      request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
      EXPECT_TRUE(run_->request(request));
    }
  }
  void giveImage() { camera_.give(std::string(64 * 48 * 2, '\x60')); }
  bool playUntil(const std::function<bool()>& happens) {
    return eventually([&] {
      if (camera_.waiting() == 0) giveImage();
      run_->step();
      return happens();
    });
  }
  static robotcontrol::Request setting(const std::string& name, double value) {
    robotcontrol::Request request;
    request.set_robot("camera");
    request.mutable_set_camera()->set_setting(name);
    request.mutable_set_camera()->set_value(value);
    return request;
  }
  /// The newest value that was published; -1: none.
  double brightnessSeen() {
    const std::lock_guard lock(mutex_);
    if (!settings_) return -1;
    for (const auto& setting : settings_->settings())
      if (setting.name() == "brightness") return setting.value();
    return -1;
  }
  bool has(const std::string& path) {
    const std::lock_guard lock(mutex_);
    return paths_.contains(path);
  }
  bool reported(const std::string& text) {
    const std::lock_guard lock(mutex_);
    return reports_.find(text) != std::string::npos;
  }
  bool reportedProblem(const std::string& text) {
    const std::lock_guard lock(mutex_);
    return problems_.find(text) != std::string::npos;
  }

  test::FakeCamera camera_;
  std::mutex mutex_;  // protects paths_, settings_, reports_ and problems_
  std::set<std::string> paths_;
  std::shared_ptr<const robotcontrol::CameraSettings> settings_;
  std::string reports_, problems_;
  std::unique_ptr<RealRun> run_;
};

TEST_F(CameraRunTest, itsImagesAreSeenByPerceptionWithTheCamerasPose) {
  open();
  EXPECT_TRUE(playUntil([&] { return has("camera/camera/image") && has("camera/camera/pose"); }));
  EXPECT_TRUE(run_->platform().isConnected());
  EXPECT_TRUE(reported("Fake camera takes images of 64x48 (YUYV), 30 a second."));
}

TEST_F(CameraRunTest, aCameraThatWasUnpluggedIsOpenedAgain) {
  open();
  EXPECT_TRUE(playUntil([&] { return run_->platform().isConnected(); }));
  camera_.unplug(true);
  EXPECT_TRUE(playUntil([&] { return !run_->platform().isConnected() && reportedProblem("trying again"); }));
  EXPECT_EQ(camera_.opened(), 0);
  camera_.unplug(false);
  run_->connectNow();
  EXPECT_TRUE(playUntil([&] { return run_->platform().isConnected(); }));
}

TEST_F(CameraRunTest, itIsOpenedWhenItIsPluggedIn) {
  camera_.unplug(true);
  open();
  EXPECT_TRUE(playUntil([&] { return reportedProblem("is the camera plugged in?"); }));
  camera_.unplug(false);
  run_->connectNow();
  EXPECT_TRUE(playUntil([&] { return has("camera/camera/image"); }));
  EXPECT_TRUE(reported("Fake camera takes images of"));
  EXPECT_FALSE(reported("is the camera plugged in?"));
}

TEST_F(CameraRunTest, itsSettingsAreChangedWhileItTakesImages) {
  open();
  EXPECT_TRUE(playUntil([&] { return run_->platform().isConnected() && brightnessSeen() == 10; }));
  EXPECT_TRUE(run_->request(setting("brightness", 40)));
  EXPECT_TRUE(playUntil([&] { return brightnessSeen() == 40; }));
  // What the camera changes by itself is seen, too.
  camera_.setValue(test::FakeCamera::kBrightness, 41);
  EXPECT_TRUE(playUntil([&] { return brightnessSeen() == 41; }));
}

TEST_F(CameraRunTest, itsSettingsAreKeptWhenItIsOpenedAgain) {
  open();
  EXPECT_TRUE(playUntil([&] { return run_->platform().isConnected(); }));
  EXPECT_TRUE(run_->request(setting("brightness", 40)));
  EXPECT_TRUE(playUntil([&] { return camera_.value(test::FakeCamera::kBrightness) == 40; }));
  camera_.unplug(true);
  EXPECT_TRUE(playUntil([&] { return !run_->platform().isConnected(); }));
  camera_.setValue(test::FakeCamera::kBrightness, 10);
  camera_.unplug(false);
  run_->connectNow();
  EXPECT_TRUE(playUntil([&] { return camera_.value(test::FakeCamera::kBrightness) == 40; }));
}

TEST_F(CameraRunTest, settingsThatItHasNotAreRefused) {
  open();
  EXPECT_TRUE(playUntil([&] { return run_->platform().isConnected(); }));
  const auto unknown = run_->request(setting("zoom", 1));
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().text.rfind("the camera has no setting 'zoom'; it has brightness, ", 0), 0U)
      << unknown.error().text;
  const auto high = run_->request(setting("brightness", 1e9));
  ASSERT_FALSE(high);
  EXPECT_EQ(high.error().text, "brightness is 0 to 255, not 1e+09");
}

TEST_F(CameraRunTest, anAddressThatIsNoneIsRefused) {
  const auto run = RealRun::create(cameraOptions("camera:///dev/video0?size=1", camera_), {});
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().front().id, "camera.address");
}

TEST(CameraAdapter, opensCamerasBeforeSerialLines) {
  for (const char* source : {"camera:///dev/video0", "/dev/video0", "camera:///dev/video0?size=1"}) {
    const PlatformAdapter* adapter = adapterFor(source);
    ASSERT_NE(adapter, nullptr) << source;
    EXPECT_EQ(adapter->name, std::string(kCameraAdapter)) << source;
  }
  EXPECT_NE(adapterFor("/dev/ttyUSB0")->name, std::string(kCameraAdapter));
}

}  // namespace
}  // namespace app
