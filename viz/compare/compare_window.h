#pragma once

#include <iosfwd>

#include "viz/compare/compare_session.h"
#include "viz/interactive_window.h"

namespace sightline::viz {

/// The panels with one camera: dragging turns all, a click chooses the ray for all and prints its table. Keys as the
/// help says. Refers to the session and the stream.
class CompareWindow : public InteractiveWindow {
 public:
  CompareWindow(CompareSession& session, const CompareLook& look, int width, int height, std::ostream& out);

  /// What is shown.
  const CompareLook& look() const { return look_; }
  const CompareFindings& findings() const { return session_.picture(look_, width_, height_).findings; }
  bool has_help() const { return has_help_; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::string command() const { return command_line(session_.source(), look_, width_, height_); }

 private:
  void press() override;
  void move() override;
  void release() override;
  void zoom(double factor) override;
  void answer_key(const std::string& key) override;
  void fit() override;
  /// `is_turning`: coarse, since another picture will follow soon.
  void show(bool is_turning = false);

  CompareSession& session_;
  CompareLook look_, first_;
  int width_, height_;
  std::ostream& out_;
  bool has_help_ = false, is_held_ = false, has_turned_ = false;
  int from_[2] = {0, 0};
};

}  // namespace sightline::viz
