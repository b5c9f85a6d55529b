#pragma once
/// The window of a construction: keys step through it.

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <string>

#include "viz/build/build_picture.h"

namespace sightline::viz {

class BuildWindow {
 public:
  /// `flags`: of the command line, besides the node's.
  BuildWindow(const BuildStory& story, std::size_t node, const BuildLook& look);

  /// Until it is closed.
  void run();

  std::size_t node() const { return step_.node; }
  const BuildStep& step() const { return step_; }
  vtkRenderWindowInteractor& interactor() { return *interactor_; }

 private:
  class Events;

  void answer(unsigned long event);
  void answer_key(const std::string& key);
  void go_to(std::size_t node);
  void turn();
  void show();

  const BuildStory& story_;
  BuildStep step_;
  BuildLook look_;
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor_;
  bool is_turning_ = false;
  int hand_x_ = 0, hand_y_ = 0;
};

/// Where a key leads from a node; nothing where it leads nowhere. "Right" and "Left" are the next and previous step,
/// "Up" the parent, "Down" the first child, "Tab" the next sibling, "Home" the root.
std::optional<std::size_t> node_after(const BuildTree& tree, std::size_t node, const std::string& key);

/// What the window's S writes: build-kd-tree-17.png.
std::string picture_name(const BuildStory& story, const BuildStep& step);

}  // namespace sightline::viz
