#pragma once

#include "viz/compare/compare_session.h"
#include "viz/interactive_window.h"

namespace sightline::viz {

/// The panels with one camera: dragging turns all, a click chooses the ray for all and prints its table. Keys as the
/// help says. Refers to the session and the stream.
class CompareWindow : public InteractiveWindow {
 public:
  CompareWindow(CompareSession& session, const CompareLook& look, int width, int height, std::ostream& out,
                WindowFrame* frame = nullptr);

  /// What is shown.
  const CompareLook& look() const { return look_; }
  const CompareFindings& findings() const { return session_.picture(look_, width_, height_).findings; }
  ComparePicture picture() const { return session_.picture(look_, width_, height_); }
  int width() const { return width_; }
  int height() const { return height_; }
  std::string command() const override { return command_line(session_.source(), look_, width_, height_); }
  std::vector<WindowKey> keys() const override;
  SharedView shared_view() const override { return {look_.ray, look_.azimuth, look_.elevation, look_.zoom}; }
  void write_png(const std::filesystem::path& path) const override;

 private:
  void press() override;
  void move() override;
  void release() override;
  void zoom(double factor) override;
  void answer_key(const std::string& key) override;
  void fit() override;
  void show() override { show(false); }
  /// `is_turning`: coarse, since another picture will follow soon.
  void show(bool is_turning);

  CompareSession& session_;
  CompareLook look_, first_;
  int width_, height_;
  bool is_held_ = false, has_turned_ = false;
  int from_[2] = {0, 0};
};

}  // namespace sightline::viz
