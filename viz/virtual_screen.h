#pragma once

#include <sys/types.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace sightline::viz {

/// Nowhere to draw.
class ScreenError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether DISPLAY names an X server that answers and speaks OpenGL (GLX). VTK aborts the program where it does not, so
/// this is asked before any window is made. Stays connected to one that has it.
bool has_display();

/// A screen in memory (Xvfb) for pictures without a display. While it lives, DISPLAY names it; then what it named
/// before.
///   S1  Xvfb chooses a free display number itself, so any number of screens live beside each other.
///   S2  Xvfb ends with this process however that ends: the kernel signals it when its parent dies.
class VirtualScreen {
 public:
  /// \throws ScreenError in one line when Xvfb is not installed or does not start.
  VirtualScreen();
  ~VirtualScreen();
  VirtualScreen(const VirtualScreen&) = delete;
  VirtualScreen& operator=(const VirtualScreen&) = delete;

 private:
  pid_t server_ = -1;
  std::optional<std::string> former_;
};

/// Where pictures are drawn off screen: a VirtualScreen, so that they look the same on every machine, or the user's
/// display where Xvfb is missing.
class PictureScreen {
 public:
  /// \throws ScreenError when there is neither.
  PictureScreen();

 private:
  std::optional<VirtualScreen> screen_;
};

}  // namespace sightline::viz
