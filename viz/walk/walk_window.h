#pragma once

#include <iosfwd>

#include "viz/interactive_window.h"
#include "viz/walk/walk_view.h"

namespace sightline::viz {

/// A walk to go through step by step; the keys are those of draw_help(). Refers to the stream that commands are printed
/// to.
class WalkWindow : public InteractiveWindow {
 public:
  static constexpr std::size_t most_triangles = 24'000;  ///< Drawn of the mesh, so that it turns without delay.

  WalkWindow(const WalkModel& model, std::size_t step, const WalkLook& look, std::ostream& commands);

  const WalkModel& model() const { return model_; }
  std::size_t step() const { return step_; }
  const WalkLook& look() const { return look_; }
  bool has_help() const { return has_help_; }
  bool is_playing() const { return is_playing_; }

 private:
  enum class Hand { idle, holding, turning };

  void answer_key(const std::string& key) override;
  void press() override;
  void move() override;
  void release() override;
  void tick() override;
  void go_to(std::size_t step);
  void choose(const Ray<float>& ray);
  void zoom(double factor) override;
  void fit() override;
  void show();
  Canvas::Point hand_at() const;

  WalkModel model_, first_model_;
  std::size_t step_, first_step_;
  WalkLook look_, first_look_;
  std::ostream& commands_;
  bool has_help_ = false, is_playing_ = false;
  Hand hand_ = Hand::idle;
  Canvas::Point from_{0, 0};  ///< Where the hand was, in units.
  WalkView view_;
};

}  // namespace sightline::viz
