#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "source/result.h"

namespace texbrdf::window {

/// In pixels.
struct Size {
  uint32_t width = 0;
  uint32_t height = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

/// What happened to a window since it was asked last.
struct Events {
  std::set<std::string, std::less<>> held;  ///< keys that are down, called as GLFW calls them, without GLFW_KEY_
  std::vector<std::string> pressed;         ///< keys that went down, in this order
  double drag_right = 0;                    ///< of the pointer with a button down, in heights of the window
  double drag_down = 0;
  double wheel = 0;       ///< notches, away from the person
  double seconds = 0;     ///< since it was asked last
  bool is_stale = false;  ///< the window lost what was drawn, or has another size
  bool wants_to_close = false;
};

/// A window with an OpenGL 3.3 core context, current on the thread that opened it. GLFW is opened when the program
/// runs. One at a time.
class Window {
 public:
  /// Fails where there is no GLFW, no display, or no OpenGL 3.3.
  static Result<Window> open(const std::string& title, Size size);
  Window(Window&&) noexcept;
  Window& operator=(Window&&) noexcept;
  ~Window();

  using Function = void (*)();
  /// Of OpenGL; nullptr where it is not there.
  Function gl_function(const char* name) const;
  /// Of the picture in the window.
  Size size() const;
  void set_title(const std::string& title);
  /// Shows what was drawn.
  void swap();
  /// Waits at most so long where nothing happens; 0 does not wait.
  Events take_events(double most_seconds);

 private:
  struct State;
  explicit Window(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf::window
