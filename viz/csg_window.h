#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <iosfwd>

#include "viz/csg_picture.h"

namespace sightline::viz {

/// Shows the picture in a window. A click on the solid chooses the ray through it and prints its table; R brings back
/// the first one, Q closes. Refers to the solid, and to the stream that tables go to. Needs a display (see has_display)
/// as long as it lives.
class CsgWindow {
 public:
  CsgWindow(const CsgPicture& first, std::ostream& tables);

  /// Until it is closed.
  void run();

  vtkRenderWindowInteractor& interactor() { return *interactor_; }
  /// What is shown.
  const CsgPicture& picture() const { return picture_; }

 private:
  class Events;

  void press();
  void choose(const Ray<double>& ray);
  void fit();
  void show();

  CsgPicture picture_;
  Ray<double> first_;
  std::ostream& tables_;
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor_;
};

}  // namespace sightline::viz
