#include "viz/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace sightline::viz {

std::filesystem::path program_folder() { return std::filesystem::read_symlink("/proc/self/exe").parent_path(); }

namespace {

/// Between fork and exec, where only what signal handlers may call is safe. Tells through `pipe` why it failed.
[[noreturn]] void become_program(char* const* words, int pipe, pid_t parent) {
  constexpr int exec_failed = 127;  // as shells report it
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(exec_failed);  // the parent died before prctl
  execv(words[0], words);
  const int error = errno;
  [[maybe_unused]] const ssize_t told = write(pipe, &error, sizeof error);
  _exit(exec_failed);
}

}  // namespace

RunningProgram::RunningProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const auto fail = [&](const std::string& what, int error) {
    throw std::runtime_error(program.string() + ": cannot be " + what + ": " + std::strerror(error));
  };
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail("started", errno);
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) become_program(pointers.data(), ends[1], parent);
  const int fork_error = child_ < 0 ? errno : 0;
  close(ends[1]);
  int error = 0;
  while (child_ > 0 && read(ends[0], &error, sizeof error) < 0 && errno == EINTR) {
  }
  close(ends[0]);
  if (child_ < 0) fail("started", fork_error);
  if (error == 0) return;  // exec has closed the pipe
  wait();
  fail("started", error);
}

int RunningProgram::wait() {
  int status = 0;
  while (waitpid(child_, &status, 0) < 0) {
    if (errno != EINTR)
      throw std::runtime_error(std::string("a program cannot be waited for: ") + std::strerror(errno));
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

RunningProgram::~RunningProgram() {
  if (child_ < 0) return;
  kill(child_, SIGTERM);
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  return RunningProgram(program, arguments).wait();
}

}  // namespace sightline::viz
