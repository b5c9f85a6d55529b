#pragma once

#include "viz/interactive_window.h"
#include "viz/walk/walk_view.h"

namespace sightline::viz {

/// A walk to go through step by step. Refers to the stream that commands are printed to.
class WalkWindow : public InteractiveWindow {
 public:
  static constexpr std::size_t most_triangles = 24'000;  ///< Drawn of the mesh, so that it turns without delay.

  WalkWindow(const WalkModel& model, std::size_t step, const WalkLook& look, std::ostream& commands,
             WindowFrame* frame = nullptr);

  const WalkModel& model() const { return model_; }
  std::size_t step() const { return step_; }
  const WalkLook& look() const { return look_; }
  bool is_playing() const { return is_playing_; }
  std::string command() const override { return command_of(model_, step_, look_); }
  std::vector<WindowKey> keys() const override;
  SharedView shared_view() const override { return {model_.walk.ray, look_.azimuth, look_.elevation, look_.zoom}; }
  void write_png(const std::filesystem::path& path) const override;

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
  void show() override;
  Canvas::Point hand_at() const;

  WalkModel model_, first_model_;
  std::size_t step_, first_step_;
  WalkLook look_, first_look_;
  bool is_playing_ = false;
  Hand hand_ = Hand::idle;
  Canvas::Point from_{0, 0};  ///< Where the hand was, in units.
  WalkView view_;
};

}  // namespace sightline::viz
