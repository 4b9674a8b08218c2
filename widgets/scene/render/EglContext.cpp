// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/EglContext.h"

#include <epoxy/egl.h>
// epoxy/egl.h must come first.
#include <epoxy/gl.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace widgets {
namespace {

// Set before main(), while there is only one thread: Mesa's software renderer has to draw in the calling
// thread, so that the other cores remain for the simulation and the cost of a picture can be measured. A
// value set by the user is respected.
[[maybe_unused]] const int kSoftwareThreads = setenv("LP_NUM_THREADS", "0", 0);

std::string eglErrorText(const char* what) {
  char code[16];
  std::snprintf(code, sizeof(code), "0x%x", static_cast<unsigned>(eglGetError()));
  return std::string(what) + " (EGL error " + code + ")";
}

bool hasClientExtension(const char* name) {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

bool initialized(EGLDisplay display) {
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE &&
         eglBindAPI(EGL_OPENGL_API) == EGL_TRUE;
}

EGLDisplay openDisplay() {
  if (!hasClientExtension("EGL_EXT_platform_base")) return EGL_NO_DISPLAY;
  if (hasClientExtension("EGL_MESA_platform_surfaceless")) {
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (initialized(display)) return display;
  }
  if (!hasClientExtension("EGL_EXT_device_enumeration") || !hasClientExtension("EGL_EXT_platform_device"))
    return EGL_NO_DISPLAY;
  EGLDeviceEXT device = nullptr;
  EGLint devices = 0;
  if (eglQueryDevicesEXT(1, &device, &devices) != EGL_TRUE || devices == 0) return EGL_NO_DISPLAY;
  EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  return initialized(display) ? display : EGL_NO_DISPLAY;
}

EGLContext createContext(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, wanted, &config, 1, &count) != EGL_TRUE || count == 0) return EGL_NO_CONTEXT;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            3,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

}  // namespace

robotlink::Result<EglContext> EglContext::create() {
  EGLDisplay display = openDisplay();
  if (display == EGL_NO_DISPLAY) {
    return robotlink::failure(
        "scene.no-egl", eglErrorText("EGL offers no display without a screen; install libgl1-mesa-dri"));
  }
  EGLContext context = createContext(display);
  if (context == EGL_NO_CONTEXT) {
    return robotlink::failure("scene.no-context",
                              eglErrorText("the graphics driver offers no OpenGL 3.3 core context"));
  }
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
    auto failed = robotlink::failure("scene.not-current",
                                     eglErrorText("the OpenGL context does not work without a surface"));
    eglDestroyContext(display, context);
    return failed;
  }
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return EglContext(display, context, renderer != nullptr ? renderer : "");
}

EglContext::EglContext(void* display, void* context, std::string renderer)
    : display_(display), context_(context), renderer_(std::move(renderer)) {}

EglContext::EglContext(EglContext&& other) noexcept
    : display_(other.display_),
      context_(std::exchange(other.context_, nullptr)),
      renderer_(std::move(other.renderer_)) {}

bool EglContext::software() const {
  return renderer_.find("llvmpipe") != std::string::npos || renderer_.find("softpipe") != std::string::npos;
}

EglContext::~EglContext() {
  if (context_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace widgets
