#include "viz/build/build_window.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace sightline::viz {

std::optional<std::size_t> node_after(const BuildTree& tree, std::size_t node, const std::string& key) {
  const BuildNode& here = tree[node];
  if (key == "Home") return 0;
  if (key == "Up") return here.parent;
  if (key == "Down") return here.children.empty() ? std::nullopt : std::optional(here.children.front());
  if (key == "Tab") {
    if (!here.parent) return std::nullopt;
    const std::vector<std::size_t>& siblings = tree[*here.parent].children;
    const auto at = std::find(siblings.begin(), siblings.end(), node) - siblings.begin();
    return siblings[static_cast<std::size_t>(at + 1) % siblings.size()];
  }
  if (key != "Right" && key != "Left") return std::nullopt;
  const auto step = tree.step_of(node);
  if (!step) return here.parent;  // a leaf is beside the steps: back to the division that made it
  if (key == "Left") return *step == 0 ? std::nullopt : std::optional(tree.steps()[*step - 1]);
  return *step + 1 == tree.steps().size() ? std::nullopt : std::optional(tree.steps()[*step + 1]);
}

std::string picture_name(const BuildStory& story, const BuildStep& step) {
  return "build-" + story.structure().accelerator + '-' + std::to_string(story.tree()[step.node].cell.node) + ".png";
}

BuildWindow::BuildWindow(const BuildStory& story, std::size_t node, const BuildLook& look)
    : InteractiveWindow("build " + story.structure().accelerator + " on " + story.scene(), look.width, look.height),
      story_(story),
      step_(story.step_at(node)),
      look_(look) {
  show();
}

void BuildWindow::press() {
  is_turning_ = true;
  hand_x_ = interactor().GetEventPosition()[0], hand_y_ = interactor().GetEventPosition()[1];
}

void BuildWindow::release() { is_turning_ = false; }

void BuildWindow::zoom(double factor) {
  look_.zoom = std::clamp(look_.zoom * factor, 0.1, 100.0);
  show();
}

void BuildWindow::fit() {
  const int width = std::max(window().GetSize()[0], BuildPicture::lowest_width);
  const int height = std::max(window().GetSize()[1], BuildPicture::lowest_height);
  if (width == look_.width && height == look_.height) return;
  look_.width = width, look_.height = height;
  show();
}

void BuildWindow::move() {
  if (!is_turning_) return;
  const int x = interactor().GetEventPosition()[0], y = interactor().GetEventPosition()[1];
  look_.azimuth = std::fmod(look_.azimuth - 0.4 * (x - hand_x_), 360);
  look_.elevation = std::clamp(look_.elevation - 0.4 * (y - hand_y_), -90.0, 90.0);
  hand_x_ = x, hand_y_ = y;
  show();
}

void BuildWindow::answer_key(const std::string& key) {
  if (key == "h" || key == "H") {
    look_.has_help = !look_.has_help;
    return show();
  }
  if (key == "s" || key == "S") {
    BuildLook look = look_;
    look.has_help = false;
    const std::string name = picture_name(story_, step_);
    BuildPicture{story_, step_, look}.write_png(name);
    std::cerr << name << '\n';
    return;
  }
  if (const auto node = node_after(story_.tree(), step_.node, key)) go_to(*node);
}

/// Stays where it is, and says why, where a node cannot be weighed again.
void BuildWindow::go_to(std::size_t node) try {
  step_ = story_.step_at(node);
  show();
} catch (const std::invalid_argument& error) {
  std::cerr << error.what() << '\n';
}

void BuildWindow::show() {
  BuildPicture{story_, step_, look_}.show_in(window(), 1);
  window().Render();
}

}  // namespace sightline::viz
