#pragma once
/// The window of a construction: keys step through it.

#include <string>

#include "viz/build/build_picture.h"
#include "viz/interactive_window.h"

namespace sightline::viz {

class BuildWindow : public InteractiveWindow {
 public:
  BuildWindow(const BuildStory& story, std::size_t node, const BuildLook& look);

  std::size_t node() const { return step_.node; }
  const BuildStep& step() const { return step_; }

 private:
  void answer_key(const std::string& key) override;
  void go_to(std::size_t node);
  void press() override;
  void move() override;
  void release() override;
  void zoom(double factor) override;
  void fit() override;
  void show();

  const BuildStory& story_;
  BuildStep step_;
  BuildLook look_;
  bool is_turning_ = false;
  int hand_x_ = 0, hand_y_ = 0;
};

/// Where a key leads from a node; nothing where it leads nowhere. "Right" and "Left" are the next and previous step,
/// "Up" the parent, "Down" the first child, "Tab" the next sibling, "Home" the root.
std::optional<std::size_t> node_after(const BuildTree& tree, std::size_t node, const std::string& key);

/// What the window's S writes: build-kd-tree-17.png.
std::string picture_name(const BuildStory& story, const BuildStep& step);

}  // namespace sightline::viz
