#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <string>

namespace sightline::viz {

/// A window that answers the mouse, keys, its size and a clock, as those who derive from it say; Q closes it. Whoever
/// derives shows itself when it is made. Needs a display (see has_display) as long as it lives.
class InteractiveWindow {
 public:
  virtual ~InteractiveWindow() = default;
  InteractiveWindow(const InteractiveWindow&) = delete;
  InteractiveWindow& operator=(const InteractiveWindow&) = delete;

  /// Until it is closed.
  void run();

  vtkRenderWindowInteractor& interactor() const { return *interactor_; }

 protected:
  /// `samples` a pixel, 0 for none but its middle.
  InteractiveWindow(const std::string& title, int width, int height, int samples = 8);

  vtkRenderWindow& window() const { return *window_; }
  /// Calls tick() ever so often, from the first call on.
  void start_clock(unsigned long milliseconds);

 private:
  class Events;

  virtual void press() {}  ///< Of the left button.
  virtual void move() {}
  virtual void release() {}
  virtual void zoom(double /*factor*/) {}  ///< By the wheel.
  virtual void fit() {}                    ///< To the window's size, which may be the former one.
  virtual void tick() {}
  virtual void answer_key(const std::string& /*key*/) {}  ///< By X's name of it; not Q.

  void answer(unsigned long event);

  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor_;
  bool has_clock_ = false;
};

}  // namespace sightline::viz
