#include "render/egl_context.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace texbrdf::render {

namespace {

struct Egl {
#define EGL_FUNCTION(name) decltype(&::name) name = nullptr;
#include "render/egl_functions.def"
#undef EGL_FUNCTION
  PFNEGLGETPLATFORMDISPLAYEXTPROC eglGetPlatformDisplay = nullptr;
  PFNEGLQUERYDEVICESEXTPROC eglQueryDevices = nullptr;  ///< absent where there is no device platform
};

struct Platform {
  EGLenum platform;
  void* native_display;
  std::string name;
};

struct Opened {
  EGLDisplay display;
  EGLContext context;
};

constexpr EGLint kMaxDevices = 16;
constexpr const char* kChoice = "TEXBRDF_EGL";

std::string_view chosen_platform() {
  const char* value = std::getenv(kChoice);
  return value == nullptr ? "" : value;
}

template <typename Function>
bool load(Function& function, void* address) {
  function = reinterpret_cast<Function>(address);
  return function != nullptr;
}

Result<Egl> open_library() {
  // Never closed: drivers leave threads and handlers behind.
  void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return Failure{"there is no EGL library (libEGL.so.1) on this machine"};
  Egl egl;
#define EGL_FUNCTION(name) \
  if (!load(egl.name, dlsym(library, #name))) return Failure{"libEGL.so.1 has no function " #name};
#include "render/egl_functions.def"
#undef EGL_FUNCTION
  const auto extension = [&](const char* name) { return reinterpret_cast<void*>(egl.eglGetProcAddress(name)); };
  if (!load(egl.eglGetPlatformDisplay, extension("eglGetPlatformDisplayEXT"))) {
    return Failure{"this EGL knows no platforms"};
  }
  load(egl.eglQueryDevices, extension("eglQueryDevicesEXT"));
  return egl;
}

/// Whether a list of names separated by spaces holds one; the list may be absent.
bool lists(const char* names, std::string_view name) {
  std::string_view rest = names == nullptr ? "" : names;
  while (!rest.empty()) {
    const std::string_view first = rest.substr(0, rest.find(' '));
    if (first == name) return true;
    rest.remove_prefix(std::min(rest.size(), first.size() + 1));
  }
  return false;
}

std::vector<Platform> candidate_platforms(const Egl& egl) {
  const char* extensions = egl.eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const std::string_view choice = chosen_platform();
  std::vector<Platform> platforms;
  if (lists(extensions, "EGL_MESA_platform_surfaceless") && (choice.empty() || choice == "surfaceless")) {
    platforms.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "surfaceless"});
  }
  if (egl.eglQueryDevices != nullptr && (choice.empty() || choice == "device")) {
    std::array<EGLDeviceEXT, kMaxDevices> devices{};
    EGLint count = 0;
    if (!egl.eglQueryDevices(kMaxDevices, devices.data(), &count)) count = 0;
    for (EGLint i = 0; i < count; ++i) {
      platforms.push_back({EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], fmt::format("device {}", i)});
    }
  }
  return platforms;
}

EGLContext create_context(const Egl& egl, EGLDisplay display) {
  constexpr std::array kContextAttributes{
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  constexpr std::array kConfigAttributes{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                         EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  if (!lists(egl.eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) {
    EGLint count = 0;
    if (!egl.eglChooseConfig(display, kConfigAttributes.data(), &config, 1, &count) || count == 0) {
      return EGL_NO_CONTEXT;
    }
  }
  return egl.eglCreateContext(display, config, EGL_NO_CONTEXT, kContextAttributes.data());
}

/// Makes a context current on the platform; nothing where that does not work.
std::optional<Opened> open_platform(const Egl& egl, const Platform& platform) {
  EGLDisplay display = egl.eglGetPlatformDisplay(platform.platform, platform.native_display, nullptr);
  if (display == EGL_NO_DISPLAY || !egl.eglInitialize(display, nullptr, nullptr)) return std::nullopt;
  if (egl.eglBindAPI(EGL_OPENGL_API)) {
    EGLContext context = create_context(egl, display);
    if (context != EGL_NO_CONTEXT) {
      if (egl.eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return Opened{display, context};
      egl.eglDestroyContext(display, context);
    }
  }
  egl.eglTerminate(display);
  return std::nullopt;
}

std::string text_of(const Gl& gl, GLenum name) {
  const GLubyte* text = gl.glGetString(name);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

}  // namespace

struct EglContext::State {
  Egl egl;
  Opened opened;
  Gl gl;
  std::string description;

  ~State() {
    egl.eglMakeCurrent(opened.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl.eglDestroyContext(opened.display, opened.context);
    egl.eglTerminate(opened.display);
  }
};

EglContext::EglContext(std::unique_ptr<State> state) : state_(std::move(state)) {}
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;
EglContext::~EglContext() = default;

Result<EglContext> EglContext::create() {
  if (chosen_platform() == "none") return Failure{fmt::format("the renderer is switched off by {}=none", kChoice)};
  const Result<Egl> egl = open_library();
  if (!egl) return Failure{egl.error()};
  std::string tried;
  for (const Platform& platform : candidate_platforms(*egl)) {
    tried += (tried.empty() ? "" : ", ") + platform.name;
    const std::optional<Opened> opened = open_platform(*egl, platform);
    if (!opened) continue;
    const Result<Gl> gl = load_gl(egl->eglGetProcAddress);
    std::unique_ptr<State> state(new State{*egl, *opened, gl ? *gl : Gl{}, {}});
    if (!gl) {
      tried += fmt::format(" ({})", gl.error());
      continue;
    }
    state->description =
        fmt::format("{}, OpenGL {}, EGL {}", text_of(*gl, GL_RENDERER), text_of(*gl, GL_VERSION), platform.name);
    return EglContext(std::move(state));
  }
  return Failure{
      fmt::format("no OpenGL 3.3 through EGL on this machine (tried: {})", tried.empty() ? "nothing" : tried)};
}

const Gl& EglContext::gl() const {
  return state_->gl;
}

const std::string& EglContext::description() const {
  return state_->description;
}

}  // namespace texbrdf::render
