#include "labs/runner/sandbox.h"

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "bench/run_program.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

/// A program's bytes of /tmp.
constexpr const char* most_scratch = "67108864";

/// System calls that make processes fail as they do where there are too many; those that make threads do not.
int write_filter() {
  const int file = ::memfd_create("filter", 0);
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (file < 0 || filter == nullptr) throw std::runtime_error("seccomp: cannot make a filter of system calls");
  int error = 0;
  for (const int call : {SCMP_SYS(fork), SCMP_SYS(vfork)}) {
    error |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EAGAIN), call, 0);
  }
  error |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EAGAIN), SCMP_SYS(clone), 1,
                            SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
  // Its flags lie in memory, which a filter does not see; without it the C library takes clone.
  error |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
  error |= seccomp_export_bpf(filter, file);
  seccomp_release(filter);
  if (error != 0) throw std::runtime_error("seccomp: cannot make a filter of system calls");
  return file;
}

void add(std::vector<std::string>& words, std::initializer_list<std::string> more) { words.insert(words.end(), more); }

std::vector<std::string> begin() {
  std::vector<std::string> words{"/usr/bin/bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--clearenv"};
  add(words, {"--setenv", "PATH", "/usr/bin:/bin", "--setenv", "HOME", "/tmp", "--setenv", "LC_ALL", "C.UTF-8"});
  add(words, {"--ro-bind", "/usr", "/usr", "--symlink", "usr/bin", "/bin", "--symlink", "usr/lib", "/lib"});
  add(words, {"--symlink", "usr/lib64", "/lib64", "--ro-bind-try", "/etc/ld.so.cache", "/etc/ld.so.cache"});
  add(words, {"--ro-bind-try", "/etc/alternatives", "/etc/alternatives", "--proc", "/proc", "--dev", "/dev"});
  add(words, {"--size", most_scratch, "--tmpfs", "/tmp", "--chdir", "/tmp"});
  return words;
}

void add_folders(std::vector<std::string>& words, const std::vector<fs::path>& readable,
                 const std::vector<fs::path>& writable) {
  for (const fs::path& path : readable) add(words, {"--ro-bind", path, path});
  for (const fs::path& path : writable) add(words, {"--bind", path, path});
}

}  // namespace

Sandbox::Sandbox() {
  if (!fs::exists("/usr/bin/bwrap")) {
    throw std::runtime_error("no sandbox to run submissions in: install bubblewrap (apt-get install bubblewrap)");
  }
  filter_ = write_filter();
  const fs::path log = fs::temp_directory_path() / ("sightline-sandbox-" + std::to_string(::getpid()));
  const bool works = bench::run_program(wrap_alone({"/usr/bin/true"}, {}), log) == 0;
  std::string said = bench::text_in(log);
  fs::remove(log);
  if (!works) {
    ::close(filter_);
    said = said.substr(0, said.find('\n'));
    throw std::runtime_error("no sandbox to run submissions in: " + (said.empty() ? "bwrap fails" : said) +
                             " (does this system allow user namespaces?)");
  }
}

Sandbox::~Sandbox() { ::close(filter_); }

std::vector<std::string> Sandbox::wrap(const std::vector<std::string>& command, const std::vector<fs::path>& readable,
                                       const std::vector<fs::path>& writable) const {
  std::vector<std::string> words = begin();
  add_folders(words, readable, writable);
  words.push_back("--");
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

std::vector<std::string> Sandbox::wrap_alone(const std::vector<std::string>& command,
                                             const std::vector<fs::path>& readable) const {
  std::vector<std::string> words = begin();
  add_folders(words, readable, {});
  // Each reader begins at the file's start: /proc opens it anew.
  const std::string filter = "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(filter_);
  std::vector<std::string> shell{"/bin/sh", "-c", "exec 9<\"$0\"; exec \"$@\"", filter};
  add(words, {"--seccomp", "9", "--"});
  shell.insert(shell.end(), words.begin(), words.end());
  shell.insert(shell.end(), command.begin(), command.end());
  return shell;
}

}  // namespace sightline::labs
