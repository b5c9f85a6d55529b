#pragma once

#include <iosfwd>

#include "viz/csg_picture.h"
#include "viz/interactive_window.h"

namespace sightline::viz {

/// Shows the picture in a window. A click on the solid chooses the ray through it and prints its table; R brings back
/// the first one, Q closes. Refers to the solid, and to the stream that tables go to.
class CsgWindow : public InteractiveWindow {
 public:
  CsgWindow(const CsgPicture& first, std::ostream& tables);

  /// What is shown.
  const CsgPicture& picture() const { return picture_; }

 private:
  void press() override;
  void answer_key(const std::string& key) override;
  void choose(const Ray<double>& ray);
  void fit() override;
  void show();

  CsgPicture picture_;
  Ray<double> first_;
  std::ostream& tables_;
};

}  // namespace sightline::viz
