#include "labs/runner/watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "sightline/io/file_error.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

/// Keys as they are pressed, not line by line; as it was again at the end.
class KeyInput {
 public:
  KeyInput() : is_terminal_(::isatty(STDIN_FILENO) == 1 && ::tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!is_terminal_) return;
    termios now = before_;
    now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // Ctrl-C still ends the program
    ::tcsetattr(STDIN_FILENO, TCSANOW, &now);
  }
  ~KeyInput() {
    if (is_terminal_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }
  KeyInput(const KeyInput&) = delete;
  KeyInput& operator=(const KeyInput&) = delete;

 private:
  termios before_{};
  bool is_terminal_;
};

/// Tells of files in a folder that are written or replaced: editors do either.
class FolderWatch {
 public:
  explicit FolderWatch(const fs::path& folder) : inotify_(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
    if (inotify_ < 0 || ::inotify_add_watch(inotify_, folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO) < 0) {
      const std::string why = std::strerror(errno);
      if (inotify_ >= 0) ::close(inotify_);
      throw FileError(folder, 0, "a folder that can be watched", why);
    }
  }
  ~FolderWatch() { ::close(inotify_); }
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;

  int descriptor() const { return inotify_; }

  /// Whether one of the lab's files is among what has changed; forgets all changes.
  bool has_changed(const Lab& lab) const {
    alignas(inotify_event) std::array<char, 4096> bytes;
    bool is_ours = false;
    for (ssize_t size; (size = ::read(inotify_, bytes.data(), bytes.size())) > 0;) {
      for (ssize_t at = 0; at < size;) {
        const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
        const std::string name = event->len > 0 ? event->name : "";
        for (const std::string& file : lab.files) is_ours |= name == file;
        at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
      }
    }
    return is_ours;
  }

 private:
  int inotify_;
};

void show_keys() {
  std::printf("\nSave a file to check again.  n next lab  h hint  l list  c check  q quit\n");
  std::fflush(stdout);
}

void check(const Workshop& workshop, const Request& request) {
  if (::isatty(STDOUT_FILENO) == 1) std::printf("\033[2J\033[3J\033[H");
  try {
    check_lab(workshop, request);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());  // the student goes on writing
  }
  show_keys();
}

/// The lab after this one; the same where it is the last.
const Lab& next_after(const Lab& lab) {
  const auto& all = all_labs();
  const auto index = static_cast<std::size_t>(&lab - all.data());
  return index + 1 < all.size() ? all[index + 1] : lab;
}

}  // namespace

int watch_lab(const Workshop& workshop, const Request& asked) {
  const KeyInput keys;
  Request request = asked;
  const Lab* lab = &lab_called(request.lab);
  for (;;) {  // once a lab
    if (!fs::exists(workshop.work_of(*lab))) start_lab(workshop, request);
    const FolderWatch folder(workshop.work_of(*lab));
    check(workshop, request);
    for (bool stays = true; stays;) {
      std::array<pollfd, 2> ready{{{folder.descriptor(), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
      if (::poll(ready.data(), ready.size(), -1) < 0 && errno != EINTR) return 1;
      if (ready[0].revents != 0) {
        ::usleep(50'000);  // editors write several times
        if (folder.has_changed(*lab)) check(workshop, request);
      }
      if (ready[1].revents == 0) continue;
      char key = 'q';
      if (::read(STDIN_FILENO, &key, 1) != 1) key = 'q';
      switch (key) {
        case 'n':
          lab = &next_after(*lab);
          request.lab = lab->number;
          stays = false;
          break;
        case 'h':
          hint_lab(workshop, request);
          show_keys();
          break;
        case 'l':
          list_labs(workshop);
          show_keys();
          break;
        case 'c':
          check(workshop, request);
          break;
        case 'q':
          return 0;
        default:
          break;
      }
    }
  }
}

}  // namespace sightline::labs
