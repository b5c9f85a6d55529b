#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "viz/graph/graph_picture.h"
#include "viz/interactive_window.h"

namespace sightline::viz {

/// A scene graph to take hold of. A click on a thing or on a row of the tree chooses a node; dragging a thing moves the
/// node that is chosen, where the thing belongs to it, in the picture's plane, and shows the event's way up; when the
/// hand lets go, the way is shown step by step, and the nodes that it passed are printed. Dragging beside things turns
/// the view. Refers to the scene, the controller and the stream.
class GraphWindow : public InteractiveWindow {
 public:
  GraphWindow(LiveScene& scene, const Controller* controller, double duration, const std::string& title,
              const GraphLook& look, int width, int height, std::ostream& tables);

  /// What is shown.
  const GraphPicture& picture() const { return picture_; }
  /// The last one; `by` counts from where the hand took hold.
  const std::optional<Change>& change() const { return change_; }
  SpaceCamera camera() const { return camera_; }

 private:
  enum class Hand { idle, moving, turning };

  void press() override;
  void move() override;
  void release() override;
  void answer_key(const std::string& key) override;
  void tick() override;
  void choose(NodeId node);
  void go_back();
  void turn(double right, double up);
  void zoom(double factor) override;
  void fit() override;
  void let_rest();
  void show();

  Canvas::Point hand_at() const;
  std::optional<std::pair<NodeId, Vec3d>> thing_at_hand() const;
  bool is_chosen(NodeId node) const;

  LiveScene& scene_;
  const Controller* controller_;
  double duration_;
  std::ostream& tables_;
  DrawnScene drawn_;
  std::vector<Transform> first_places_;
  GraphPicture picture_;
  GraphLook first_look_;
  SpaceCamera camera_;
  std::vector<GraphSpace> spaces_;
  Hand hand_ = Hand::idle;
  Canvas::Point from_{0, 0};  ///< Where the hand was, in units.
  Vec3d anchor_{0};           ///< What it took hold of.
  std::optional<Change> change_;
  std::vector<GraphFrame> steps_;  ///< Still to be shown, one a tick.
  bool is_playing_ = false;
  double time_ = 0;
  int ticks_ = 0;
};

}  // namespace sightline::viz
