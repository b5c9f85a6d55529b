#include "viz/virtual_screen.h"

#include <GL/glx.h>
#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdlib>

namespace sightline::viz {
namespace {

constexpr int exec_failed = 127;  // as shells report it

/// Reads the display number that Xvfb writes once it listens; empty when it ended or kept silent for too long.
std::string read_display_number(int pipe) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(20);
  std::string text;
  while (text.empty() || text.back() != '\n') {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd waiting{pipe, POLLIN, 0};
    if (left <= 0) return {};
    if (poll(&waiting, 1, static_cast<int>(left)) <= 0) {
      if (errno == EINTR) continue;
      return {};
    }
    char byte = 0;
    if (read(pipe, &byte, 1) != 1) return {};
    text += byte;
  }
  text.pop_back();
  return text;
}

[[noreturn]] void become_xvfb(int pipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(exec_failed);  // the parent died before prctl
  if (const int nothing = open("/dev/null", O_RDWR); nothing >= 0) {
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
  }
  char number[16] = {};
  std::to_chars(number, number + sizeof number - 1, pipe);
  execlp("Xvfb", "Xvfb", "-displayfd", number, "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset",
         static_cast<char*>(nullptr));
  _exit(exec_failed);
}

}  // namespace

bool has_display() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name) return false;
  // A server resets itself when its last client leaves, and may then refuse the window that comes next, at which VTK
  // crashes. So this client stays, and is not asked again.
  static std::string known;
  if (name == known) return true;
  Display* display = XOpenDisplay(nullptr);
  if (!display) return false;
  if (!glXQueryExtension(display, nullptr, nullptr)) {
    XCloseDisplay(display);
    return false;
  }
  known = name;
  return true;
}

VirtualScreen::VirtualScreen() {
  if (const char* former = std::getenv("DISPLAY")) former_ = former;
  int ends[2];
  if (pipe(ends) != 0) throw ScreenError("cannot start Xvfb: no pipe");
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const pid_t parent = getpid();
  server_ = fork();
  if (server_ == 0) become_xvfb(ends[1], parent);
  close(ends[1]);
  const std::string number = server_ > 0 ? read_display_number(ends[0]) : std::string();
  close(ends[0]);
  if (!number.empty()) {
    setenv("DISPLAY", (":" + number).c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // Xvfb has no graphics card, whatever drivers the machine has
    return;
  }
  int status = 0;
  if (server_ > 0) {
    kill(server_, SIGTERM);
    waitpid(server_, &status, 0);
  }
  const bool is_missing = WIFEXITED(status) && WEXITSTATUS(status) == exec_failed;
  throw ScreenError(is_missing ? "pictures need a display or Xvfb, and neither is here: install Debian's package xvfb, "
                                 "or write data instead, see --help"
                               : "Xvfb did not start; run `Xvfb :99` to see why");
}

VirtualScreen::~VirtualScreen() {
  kill(server_, SIGTERM);
  int status = 0;
  while (waitpid(server_, &status, 0) < 0 && errno == EINTR) {
  }
  former_ ? setenv("DISPLAY", former_->c_str(), 1) : unsetenv("DISPLAY");
}

PictureScreen::PictureScreen() {
  try {
    screen_.emplace();
  } catch (const ScreenError&) {
    if (!has_display()) throw;
  }
}

}  // namespace sightline::viz
