#pragma once

#include "viz/interactive_window.h"
#include "viz/noise/noise_picture.h"

namespace sightline::viz {

/// The picture, and others as keys ask for them. Refers to the stream.
class NoiseWindow : public InteractiveWindow {
 public:
  NoiseWindow(const NoisePicture& first, std::ostream& commands, WindowFrame* frame = nullptr);

  /// What is shown.
  const NoisePicture& picture() const { return picture_; }
  std::string command() const override;
  std::vector<WindowKey> keys() const override;
  void write_png(const std::filesystem::path& path) const override { picture_.write_png(path); }

 private:
  void answer_key(const std::string& key) override;
  void press() override;
  void move() override;
  void release() override { is_held_ = false; }
  void zoom(double factor) override;
  void fit() override;
  void show() override;

  NoisePicture picture_, first_;
  bool is_held_ = false;
  std::array<int, 2> from_{0, 0};
};

}  // namespace sightline::viz
