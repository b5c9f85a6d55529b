#include "sightline/io/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

namespace sightline {
namespace {

constexpr char answered = 'A', refused = 'R';

void write_all(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(pipe, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) _exit(1);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// Never returns: nothing of the parent's, such as its files, is to be cleaned up twice.
[[noreturn]] void be_child(int pipe, pid_t parent, const std::function<std::string()>& work,
                           const ChildLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_UNBLOCK, &all, nullptr);
  const int nowhere = open("/dev/null", O_RDWR);
  for (int stream = 0; stream < 3 && nowhere >= 0; ++stream) dup2(nowhere, stream);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const auto seconds = static_cast<rlim_t>(limits.time.count());
  const rlimit processor_time{seconds, seconds};
  setrlimit(RLIMIT_CPU, &processor_time);
  try {
    const std::string answer = work();
    write_all(pipe, std::string(1, answered));
    write_all(pipe, answer);
  } catch (const std::exception& error) {
    write_all(pipe, std::string(1, refused) + error.what());
  } catch (...) {
    write_all(pipe, std::string(1, refused) + "an exception");
  }
  _exit(0);
}

/// Bytes of memory that a process has for itself; 0 where that is not known.
std::uint64_t memory_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::uint64_t size = 0, resident = 0, shared = 0;
  file >> size >> resident >> shared;
  return file ? (resident - std::min(resident, shared)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Kills and waits for it, however the parent's work ends.
class Child {
 public:
  explicit Child(pid_t process) : process_(process), own_memory_(memory_of(getpid())) {}
  ~Child() {
    if (process_ > 0) end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Beyond the pages that it shares with its parent since the fork, as far as can be told.
  std::uint64_t memory() const {
    const std::uint64_t all = memory_of(process_);
    return all - std::min(all, own_memory_);
  }
  /// What waitpid() tells.
  int end() {
    kill(process_, SIGKILL);
    return wait();
  }
  int wait() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = 0;
    return status;
  }

 private:
  pid_t process_;
  std::uint64_t own_memory_;
};

std::string said(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

}  // namespace

std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw ChildFailure(std::string("no pipe: ") + std::strerror(errno));
  const pid_t parent = getpid(), process = fork();
  if (process == 0) {
    close(ends[0]);
    be_child(ends[1], parent, work, limits);
  }
  close(ends[1]);
  struct Closer {
    int file;
    ~Closer() { close(file); }
  } closer{ends[0]};
  if (process < 0) throw ChildFailure(std::string("no process: ") + std::strerror(errno));
  Child child(process);

  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + limits.time;
  std::string answer;
  while (true) {
    constexpr int milliseconds = 10;
    pollfd ready{ends[0], POLLIN, 0};
    const int count = poll(&ready, 1, milliseconds);
    if (count > 0) {
      char block[1 << 16];
      const ssize_t size = read(ends[0], block, sizeof block);
      if (size == 0) break;
      if (size > 0) answer.append(block, static_cast<std::size_t>(size));
    }
    if (answer.size() > limits.memory) throw ChildFailure("an answer of more than " + said(limits.memory));
    if (count == 0 && child.memory() > limits.memory) throw ChildFailure("a need of more than " + said(limits.memory));
    if (Clock::now() > deadline) throw ChildFailure("no end within " + std::to_string(limits.time.count()) + " s");
  }
  const int status = child.wait();
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL) throw ChildFailure("no end within its time or memory");
    throw ChildFailure("a crash (signal " + std::to_string(signal) + ")");
  }
  if (answer.empty() || WEXITSTATUS(status) != 0) throw ChildFailure("a crash");
  if (answer.front() == refused) throw ChildFailure(answer.substr(1));
  return answer.substr(1);
}

}  // namespace sightline
