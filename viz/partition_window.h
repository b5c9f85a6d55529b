#pragma once

#include "viz/interactive_window.h"
#include "viz/partition_picture.h"

namespace sightline::viz {

/// The picture in a window, to turn and to dive into. Refers to the tracer and the stream.
class PartitionWindow : public InteractiveWindow {
 public:
  /// `command` shows the first picture, but for depths, slice and camera. Some cell matches the filter.
  PartitionWindow(const Tracer& tracer, const CellFilter& filter, const Caption& caption, const View& view,
                  std::string command, std::ostream& commands, WindowFrame* frame = nullptr);

  /// What is shown.
  const CellFilter& filter() const { return filter_; }
  const View& view() const { return view_; }
  const Partition& partition() const { return partition_; }
  std::string command() const override;
  std::vector<WindowKey> keys() const override;
  SharedView shared_view() const override;
  void write_png(const std::filesystem::path& path) const override { picture().write_png(path); }

 private:
  PartitionPicture picture() const { return {tracer_.mesh(), partition_, filter_.slice, caption_, view_}; }
  void answer_key(const std::string& key) override;
  void press() override;
  void move() override;
  void release() override;
  void zoom(double factor) override;
  void fit() override;
  void show() override;
  void choose(const CellFilter& filter);

  const Tracer& tracer_;
  CellFilter filter_, first_filter_;
  Caption caption_;
  View view_, first_view_;
  Partition partition_;
  std::string command_;
  bool is_held_ = false, has_turned_ = false;
  std::array<int, 2> from_{0, 0};
};

}  // namespace sightline::viz
