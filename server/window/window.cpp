#include "window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace texbrdf::window {
namespace {

struct Glfw {
#define GLFW_FUNCTION(name) decltype(&::name) name = nullptr;
#include "window/glfw_functions.def"
#undef GLFW_FUNCTION
};

constexpr const char* kLibrary = "libglfw.so.3";

/// Seconds that a key counts as held which was not when it was asked last.
constexpr double kTap = 1.0 / 60;

struct Key {
  int code;
  std::string_view name;
};

constexpr std::array kKeys{
#define SCENE_KEY(name) Key{GLFW_KEY_##name, #name},
#include "scene/keys.def"
#undef SCENE_KEY
};

/// Empty for a key without a name.
std::string_view name_of(int code) {
  const auto found = std::ranges::find(kKeys, code, &Key::code);
  return found == kKeys.end() ? std::string_view() : found->name;
}

Result<Glfw> open_library() {
  // Never closed: what it uses leaves threads and handlers behind.
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return Failure{"there is no GLFW library (libglfw.so.3) on this machine"};
  Glfw glfw;
#define GLFW_FUNCTION(name)                                               \
  glfw.name = reinterpret_cast<decltype(&::name)>(dlsym(library, #name)); \
  if (glfw.name == nullptr) return Failure{"libglfw.so.3 has no function " #name};
#include "window/glfw_functions.def"
#undef GLFW_FUNCTION
  return glfw;
}

std::string last_error(const Glfw& glfw) {
  const char* text = nullptr;
  glfw.glfwGetError(&text);
  return text == nullptr ? "GLFW does not say why" : text;
}

struct Pointer {
  double x = 0;
  double y = 0;
};

}  // namespace

struct Window::State {
  Glfw glfw;
  GLFWwindow* window = nullptr;
  Events events;
  int buttons = 0;                 ///< that are down
  std::optional<Pointer> pointer;  ///< nothing before it was there
  double last_asked = 0;
  bool held_before = false;  ///< when it was asked last

  explicit State(const Glfw& library) : glfw(library) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (window != nullptr) glfw.glfwDestroyWindow(window);
    glfw.glfwTerminate();
  }

  static State& of(GLFWwindow* window);
  void listen();
  void on_key(int code, int action);
  void on_button(int action);
  void on_pointer(Pointer there);
};

void Window::State::on_key(int code, int action) {
  const std::string name(name_of(code));
  if (name.empty()) return;
  if (action == GLFW_PRESS) {
    events.held.insert(name);
    events.pressed.push_back(name);
  } else if (action == GLFW_RELEASE) {
    events.held.erase(name);
  }
}

void Window::State::on_button(int action) {
  buttons = std::max(0, buttons + (action == GLFW_PRESS ? 1 : -1));
}

void Window::State::on_pointer(Pointer there) {
  int width = 0;
  int height = 0;
  glfw.glfwGetWindowSize(window, &width, &height);
  if (buttons > 0 && height > 0 && pointer) {
    events.drag_right += (there.x - pointer->x) / height;
    events.drag_down += (there.y - pointer->y) / height;
  }
  pointer = there;
}

namespace {

/// GLFW hands its callbacks nothing but the window: what else they need they look up in the library.
void* user_pointer(GLFWwindow* window) {
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  const auto get = reinterpret_cast<decltype(&::glfwGetWindowUserPointer)>(dlsym(library, "glfwGetWindowUserPointer"));
  void* pointer = get(window);
  dlclose(library);
  return pointer;
}

}  // namespace

Window::State& Window::State::of(GLFWwindow* window) {
  return *static_cast<State*>(user_pointer(window));
}

void Window::State::listen() {
  glfw.glfwSetWindowUserPointer(window, this);
  glfw.glfwSetKeyCallback(
      window, [](GLFWwindow* of_window, int code, int, int action, int) { of(of_window).on_key(code, action); });
  glfw.glfwSetMouseButtonCallback(window,
                                  [](GLFWwindow* of_window, int, int action, int) { of(of_window).on_button(action); });
  glfw.glfwSetCursorPosCallback(window,
                                [](GLFWwindow* of_window, double x, double y) { of(of_window).on_pointer({x, y}); });
  glfw.glfwSetScrollCallback(window, [](GLFWwindow* of_window, double, double y) { of(of_window).events.wheel += y; });
  glfw.glfwSetFramebufferSizeCallback(window,
                                      [](GLFWwindow* of_window, int, int) { of(of_window).events.is_stale = true; });
  glfw.glfwSetWindowRefreshCallback(window, [](GLFWwindow* of_window) { of(of_window).events.is_stale = true; });
}

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(const std::string& title, Size size) {
  const Result<Glfw> glfw = open_library();
  if (!glfw) return Failure{glfw.error()};
  if (!glfw->glfwInit()) return Failure{fmt::format("there is no display for a window ({})", last_error(*glfw))};
  auto state = std::make_unique<State>(*glfw);
  glfw->glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfw->glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfw->glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfw->glfwWindowHint(GLFW_ALPHA_BITS, 0);
  glfw->glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfw->glfwWindowHint(GLFW_STENCIL_BITS, 0);
  state->window = glfw->glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), title.c_str(),
                                         nullptr, nullptr);
  if (state->window == nullptr) {
    return Failure{fmt::format("no window with OpenGL 3.3 can be opened ({})", last_error(*glfw))};
  }
  glfw->glfwMakeContextCurrent(state->window);
  glfw->glfwSwapInterval(1);
  state->last_asked = glfw->glfwGetTime();
  state->listen();
  return Window(std::move(state));
}

Window::Function Window::gl_function(const char* name) const {
  return state_->glfw.glfwGetProcAddress(name);
}

Size Window::size() const {
  int width = 0;
  int height = 0;
  state_->glfw.glfwGetFramebufferSize(state_->window, &width, &height);
  return {static_cast<uint32_t>(std::max(width, 0)), static_cast<uint32_t>(std::max(height, 0))};
}

void Window::set_title(const std::string& title) {
  state_->glfw.glfwSetWindowTitle(state_->window, title.c_str());
}

void Window::swap() {
  state_->glfw.glfwSwapBuffers(state_->window);
}

Events Window::take_events(double most_seconds) {
  if (most_seconds > 0) {
    state_->glfw.glfwWaitEventsTimeout(most_seconds);
  } else {
    state_->glfw.glfwPollEvents();
  }
  Events taken = std::exchange(state_->events, {});
  state_->events.held = taken.held;
  const double now = state_->glfw.glfwGetTime();
  taken.seconds = now - std::exchange(state_->last_asked, now);
  // What went down while nothing was held did so a moment ago, and may be up again.
  if (std::exchange(state_->held_before, !taken.held.empty()) == false) taken.seconds = std::min(taken.seconds, kTap);
  taken.held.insert(taken.pressed.begin(), taken.pressed.end());
  taken.wants_to_close = state_->glfw.glfwWindowShouldClose(state_->window) != 0;
  return taken;
}

}  // namespace texbrdf::window
