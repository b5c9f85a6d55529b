#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "viz/canvas.h"

namespace sightline::viz {

class InteractiveWindow;

/// A strip above what a window shows, which answers before it.
class WindowBar {
 public:
  static constexpr int height = 42;  ///< Pixels.

  virtual ~WindowBar() = default;
  /// In pixels of the strip.
  virtual void draw(Canvas& canvas, int width) const = 0;
  virtual void press(double x) = 0;
  /// Whether the key is the bar's.
  virtual bool answer_key(const std::string& key) = 0;
  /// For another page.
  virtual void ask(const std::string& page) = 0;
  /// What a press or a key asked for, once nobody is amid answering it.
  virtual void settle() = 0;
};

/// What somebody shows, and what it refers to.
struct OpenWindow {
  std::shared_ptr<const void> held;
  std::unique_ptr<InteractiveWindow> window;
};

/// X's window with its mouse, keys and clock, in which one InteractiveWindow at a time is seen. It leaves to that all
/// but a bar at the top and, where the picture itself does not tell its command line, a strip below with it.
///   F1  Every renderer's viewport is squeezed into what is left, once, however often it is rendered.
class WindowFrame {
 public:
  static constexpr int foot_height = 34;  ///< Pixels.

  WindowFrame(const std::string& title, int width, int height, int samples);
  ~WindowFrame();
  WindowFrame(const WindowFrame&) = delete;
  WindowFrame& operator=(const WindowFrame&) = delete;

  vtkRenderWindow& window() const { return *window_; }
  vtkRenderWindowInteractor& interactor() const { return *interactor_; }

  /// The bar outlives the frame.
  void set_bar(WindowBar& bar) { bar_ = &bar; }
  bool has_bar() const { return bar_ != nullptr; }
  /// For another page, where there are pages.
  void ask(const std::string& page) const {
    if (bar_) bar_->ask(page);
  }
  /// Shows another window, with nothing left of the former one, which need not live longer.
  void enter(InteractiveWindow& window);
  void leave(const InteractiveWindow& window);
  /// The last one that was given stays.
  void keep(OpenWindow open);
  const OpenWindow& kept() const { return kept_; }

  void start_clock(unsigned long milliseconds);
  void render();
  void run();

 private:
  class Events;
  using Viewport = std::array<double, 4>;

  void answer(unsigned long event);
  void answer_key();
  void squeeze(int foot, int top);
  void draw_strips(int foot, int top);
  void draw_help(int layer);

  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor_;
  vtkSmartPointer<vtkRenderer> top_, foot_, help_;
  std::map<vtkRenderer*, std::pair<Viewport, Viewport>> viewports_;  ///< As asked for, and squeezed.
  WindowBar* bar_ = nullptr;
  InteractiveWindow* shown_ = nullptr;
  OpenWindow kept_;
  int clock_ = 0;
};

}  // namespace sightline::viz
