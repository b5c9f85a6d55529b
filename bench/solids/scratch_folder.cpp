#include "bench/solids/scratch_folder.h"

#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace sightline::bench {
namespace {

constexpr std::array signals{SIGHUP, SIGINT, SIGTERM};

/// What a handler of signals may look at: paths of fixed size, and how many of them are whole.
struct Litter {
  std::array<std::array<char, 512>, 5> paths;  ///< The folder is the first.
  volatile sig_atomic_t count = 0;
  std::array<struct sigaction, signals.size()> before;
};
Litter litter;

void add(const std::filesystem::path& path) {
  const auto count = static_cast<std::size_t>(litter.count);
  const std::string text = path.string();
  if (count == litter.paths.size() || text.size() >= litter.paths[count].size())
    throw std::runtime_error("expected few files with short names for a while, found " + text);
  std::copy_n(text.c_str(), text.size() + 1, litter.paths[count].begin());
  litter.count = static_cast<sig_atomic_t>(count + 1);
}

/// Calls nothing but what POSIX allows in handlers.
void remove_all() {
  for (auto i = static_cast<std::size_t>(litter.count); i-- > 1;) unlink(litter.paths[i].data());
  if (litter.count > 0) rmdir(litter.paths[0].data());
  litter.count = 0;
}

void remove_all_and_end(int signal) {
  remove_all();
  ::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "sightline-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("expected to make a folder " + pattern + ", found none made");
  path_ = pattern;
  add(path_);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    struct sigaction action {};
    action.sa_handler = remove_all_and_end;
    sigaction(signals[i], &action, &litter.before[i]);
    // What the caller has the program ignore, as nohup does, stays so.
    if (litter.before[i].sa_handler == SIG_IGN) sigaction(signals[i], &litter.before[i], nullptr);
  }
}

ScratchFolder::~ScratchFolder() {
  remove_all();
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &litter.before[i], nullptr);
}

std::filesystem::path ScratchFolder::file(const char* name) {
  const std::filesystem::path path = path_ / name;
  add(path);
  return path;
}

}  // namespace sightline::bench
