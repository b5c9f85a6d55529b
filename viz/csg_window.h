#pragma once

#include "viz/csg_picture.h"
#include "viz/interactive_window.h"

namespace sightline::viz {

/// Shows the picture in a window. A click on the solid chooses the ray through it and prints its table; R brings back
/// the first one, Q closes. Refers to the solid, and to the stream that tables go to.
class CsgWindow : public InteractiveWindow {
 public:
  /// `command` shows the first picture, but for --ray and --size.
  CsgWindow(const CsgPicture& first, std::string command, std::ostream& tables, WindowFrame* frame = nullptr);

  /// What is shown.
  const CsgPicture& picture() const { return picture_; }
  std::string command() const override;
  std::vector<WindowKey> keys() const override;
  void write_png(const std::filesystem::path& path) const override { picture_.write_png(path); }

 private:
  void press() override;
  void answer_key(const std::string& key) override;
  void choose(const Ray<double>& ray);
  void fit() override;
  void show() override;

  CsgPicture picture_;
  std::string command_;
  Ray<double> first_;
};

}  // namespace sightline::viz
