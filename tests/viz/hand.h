#pragma once
/// A hand on a window's mouse and keys: its events come from the X server as a user's would.

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

// It defines words that others use; so last.
#include <X11/Xlib.h>
#include <X11/keysym.h>

namespace sightline::viz {

/// Sends events to a window, and lets the window answer them. Places count as a picture's, from the top left corner.
class Hand {
 public:
  explicit Hand(vtkRenderWindowInteractor& interactor) : interactor_(interactor), display_(XOpenDisplay(nullptr)) {
    interactor.Initialize();
    interactor.ProcessEvents();
  }
  ~Hand() { XCloseDisplay(display_); }
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;

  void click(int x, int y) {
    hold(x, y);
    let_go(x, y);
  }
  void hold(int x, int y) {
    move(x, y);
    button(ButtonPress, ButtonPressMask, x, y);
  }
  void let_go(int x, int y) { button(ButtonRelease, ButtonReleaseMask, x, y); }
  void move(int x, int y) {
    XWarpPointer(display_, None, id(), 0, 0, 0, 0, x, y);
    answer();
  }
  void press(KeySym key) {
    for (const int type : {KeyPress, KeyRelease}) {
      XEvent event{};
      event.xkey.type = type;
      event.xkey.keycode = XKeysymToKeycode(display_, key);
      send(event, type == KeyPress ? KeyPressMask : KeyReleaseMask);
    }
  }
  void resize(unsigned new_width, unsigned new_height) {
    XResizeWindow(display_, id(), new_width, new_height);
    answer();
  }
  /// Lets the window answer what has come.
  void answer() {
    XSync(display_, False);
    interactor_.ProcessEvents();
  }

 private:
  void button(int type, long mask, int x, int y) {
    XEvent event{};
    event.xbutton.type = type;
    event.xbutton.button = Button1;
    event.xbutton.x = x, event.xbutton.y = y;
    send(event, mask);
  }
  Window id() const { return reinterpret_cast<Window>(interactor_.GetRenderWindow()->GetGenericWindowId()); }
  void send(XEvent& event, long mask) {
    event.xany.display = display_;
    event.xany.window = id();
    XSendEvent(display_, id(), True, mask, &event);
    answer();
  }

  vtkRenderWindowInteractor& interactor_;
  Display* display_;
};

}  // namespace sightline::viz
