#pragma once
/// The window of a construction: keys step through it.

#include <string>

#include "viz/build/build_picture.h"
#include "viz/interactive_window.h"

namespace sightline::viz {

class BuildWindow : public InteractiveWindow {
 public:
  BuildWindow(const BuildStory& story, std::size_t node, const BuildLook& look, std::ostream& commands,
              WindowFrame* frame = nullptr);

  std::size_t node() const { return step_.node; }
  const BuildStep& step() const { return step_; }
  std::string command() const override { return command_of(step_, look_); }
  std::vector<WindowKey> keys() const override;
  SharedView shared_view() const override { return {{}, look_.azimuth, look_.elevation, {}}; }
  void write_png(const std::filesystem::path& path) const override {
    BuildPicture{story_, step_, look_}.write_png(path);
  }

 private:
  void answer_key(const std::string& key) override;
  void go_to(std::size_t node);
  void press() override;
  void move() override;
  void release() override;
  void zoom(double factor) override;
  void fit() override;
  void show() override;

  const BuildStory& story_;
  BuildStep step_;
  BuildLook look_;
  bool is_turning_ = false;
  int hand_x_ = 0, hand_y_ = 0;
};

/// Where a key leads from a node; nothing where it leads nowhere. "Right" and "Left" are the next and previous step,
/// "Up" the parent, "Down" the first child, "Tab" the next sibling, "Home" the root.
std::optional<std::size_t> node_after(const BuildTree& tree, std::size_t node, const std::string& key);

}  // namespace sightline::viz
