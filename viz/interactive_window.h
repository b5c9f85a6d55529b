#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "sightline/math/ray.h"
#include "viz/window_frame.h"

namespace sightline::viz {

struct WindowKey {
  std::string key, meaning;
};

/// What one window can hand on to another; what it has not is not there.
struct SharedView {
  std::optional<Ray<float>> ray;
  std::optional<double> azimuth, elevation, zoom;
};

/// A window that answers the mouse, keys, its size and a clock, as those who derive from it say. S writes the picture
/// and prints the command line that does, H shows the keys, Q closes. Whoever derives shows itself when it is made.
/// Needs a display (see has_display) as long as it lives.
class InteractiveWindow {
 public:
  virtual ~InteractiveWindow();
  InteractiveWindow(const InteractiveWindow&) = delete;
  InteractiveWindow& operator=(const InteractiveWindow&) = delete;

  /// Until it is closed.
  void run() { frame_.run(); }

  vtkRenderWindowInteractor& interactor() const { return frame_.interactor(); }
  bool has_help() const { return has_help_; }

  /// The command line that gives this picture.
  virtual std::string command() const = 0;
  virtual std::vector<WindowKey> keys() const = 0;
  virtual SharedView shared_view() const { return {}; }
  /// What is shown, without help.
  virtual void write_png(const std::filesystem::path& path) const = 0;
  /// Where S writes pictures; where nobody says, the folder that the program was started from.
  void set_picture_folder(const std::filesystem::path& folder) { folder_ = folder; }

 protected:
  struct Place {
    std::string name;           ///< One word: pictures are called so.
    std::string title;          ///< The window's.
    int width, height;          ///< The picture's.
    bool tells_command = true;  ///< Whether the picture itself does.
    int samples = 8;            ///< A pixel, 0 for none but its middle.
  };
  /// In a frame of its own where none is given. Refers to the frame and the stream, which commands are printed to.
  InteractiveWindow(const Place& place, WindowFrame* frame, std::ostream& out);

  vtkRenderWindow& window() const { return frame_.window(); }
  WindowFrame& frame() const { return frame_; }
  /// What a picture has room in.
  std::array<int, 2> area() const;
  /// The same, but no smaller than can be read.
  template <class Picture>
  std::array<int, 2> area_for() const {
    const auto [width, height] = area();
    return {width < Picture::lowest_width ? Picture::lowest_width : width,
            height < Picture::lowest_height ? Picture::lowest_height : height};
  }
  /// Where the mouse is, from the lower left pixel of that.
  std::array<int, 2> hand() const;
  void render() { frame_.render(); }
  /// Calls tick() ever so often, from the first call on.
  void start_clock(unsigned long milliseconds) { frame_.start_clock(milliseconds); }
  std::ostream& out() const { return out_; }

 private:
  friend class WindowFrame;

  virtual void press() {}  ///< Of the left button.
  virtual void move() {}
  virtual void release() {}
  virtual void zoom(double /*factor*/) {}  ///< By the wheel.
  virtual void fit() {}                    ///< To the window's size, which may be the former one.
  virtual void tick() {}
  virtual void answer_key(const std::string& /*key*/) {}  ///< By X's name of it; not those of all windows.
  virtual void show() = 0;

  void answer_common_key(const std::string& key);
  void save();
  int foot() const { return tells_command_ ? 0 : WindowFrame::foot_height; }

  std::unique_ptr<WindowFrame> own_;
  WindowFrame& frame_;
  std::ostream& out_;
  std::string name_;
  std::filesystem::path folder_;
  bool tells_command_, has_help_ = false;
};

/// As numbers that a command line tells in few digits: a whole number of so many parts of one.
inline double rounded(double number, double parts) { return std::round(number * parts) / parts; }

/// Shows a window until it is closed, or as one of several in a frame, for which `held` lives on. The exit status.
template <class Window, class Held, class... Arguments>
int open_window(WindowFrame* frame, const std::shared_ptr<Held>& held, Arguments&&... arguments) {
  if (frame) {
    frame->keep({held, std::make_unique<Window>(std::forward<Arguments>(arguments)..., frame)});
  } else {
    Window(std::forward<Arguments>(arguments)...).run();
  }
  return 0;
}

}  // namespace sightline::viz
