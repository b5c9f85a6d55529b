#include "labs/check/subject.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "labs/kit/frame.h"

namespace sightline::labs {
namespace {

using Kind = SubjectTrouble::Kind;

/// Of what a program prints, so much is kept.
constexpr rlim_t most_printed = 1 << 20;
constexpr std::size_t most_shown = 2000;

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(resource, &both);
}

/// Descriptors end where they are wanted, whichever they had before.
void place(int from, int to) {
  if (from == to) {
    ::fcntl(from, F_SETFD, 0);
  } else {
    ::dup2(from, to);
  }
}

std::string seconds(std::chrono::milliseconds time) {
  const auto tenths = time.count() / 100;
  return std::to_string(tenths / 10) + (tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "") + " s";
}

}  // namespace

Subject::Subject(std::vector<std::string> command, const SubjectLimits& limits)
    : command_(std::move(command)), limits_(limits) {
  ::signal(SIGPIPE, SIG_IGN);  // writing to one that has ended is an error that is looked at
  printed_ = ::memfd_create("printed", MFD_CLOEXEC);
}

Subject::~Subject() {
  stop();
  ::close(printed_);
}

void Subject::start() {
  int to_child[2], from_child[2];
  if (::pipe2(to_child, O_CLOEXEC) != 0 || ::pipe2(from_child, O_CLOEXEC) != 0) {
    throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  }
  std::vector<char*> words;
  for (std::string& word : command_) words.push_back(word.data());
  words.push_back(nullptr);
  child_ = ::fork();
  if (child_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::setpgid(0, 0);
    const int nothing = ::open("/dev/null", O_RDONLY);
    // Out of the way of the numbers that they are to have.
    const int questions = ::fcntl(to_child[0], F_DUPFD, 10), answers = ::fcntl(from_child[1], F_DUPFD, 10);
    const int printed = ::fcntl(printed_, F_DUPFD, 10);
    place(nothing, STDIN_FILENO);
    place(printed, STDOUT_FILENO);
    place(printed, STDERR_FILENO);
    place(questions, questions_descriptor);
    place(answers, answers_descriptor);
    ::close_range(answers_descriptor + 1, ~0u, 0);
    limit(RLIMIT_AS, limits_.memory);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, most_printed);
    ::signal(SIGPIPE, SIG_DFL);
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  ::close(to_child[0]);
  ::close(from_child[1]);
  questions_ = to_child[1];
  answers_ = from_child[0];
  ::fcntl(questions_, F_SETFL, O_NONBLOCK);
  ::fcntl(answers_, F_SETFL, O_NONBLOCK);
  if (child_ < 0) {
    stop();
    throw std::runtime_error(std::string("fork: ") + std::strerror(errno));
  }
}

std::string Subject::stop() {
  if (questions_ >= 0) ::close(questions_);
  if (answers_ >= 0) ::close(answers_);
  questions_ = answers_ = -1;
  if (child_ < 0) return {};
  int status = 0;
  // One that has ended tells how; one that has not is ended, with all that it has started in its group.
  for (int i = 0; i < 20 && ::waitpid(child_, &status, WNOHANG) == 0; ++i) {
    if (i == 19) {
      ::kill(-child_, SIGKILL);
      ::kill(child_, SIGKILL);
      ::waitpid(child_, &status, 0);
      break;
    }
    ::usleep(1000);
  }
  ::kill(-child_, SIGKILL);
  child_ = -1;
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return "a crash (signal " + std::to_string(number) + ", " + ::strsignal(number) + ")";
  }
  if (WEXITSTATUS(status) == 127) return "a program that cannot be started: " + command_[0];
  return "an end of the program (exit " + std::to_string(WEXITSTATUS(status)) + ")";
}

void Subject::wait_for(int descriptor, short events, Clock::time_point deadline) {
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd wanted{descriptor, events, 0};
    const int ready = left <= 0 ? 0 : ::poll(&wanted, 1, static_cast<int>(left));
    if (ready > 0) return;
    if (ready < 0 && errno == EINTR) continue;
    ::kill(-child_, SIGKILL);
    stop();
    throw SubjectTrouble(Kind::silence, "no answer within " + seconds(limits_.answer) + ": a loop that does not end?");
  }
}

void Subject::write_all(const char* bytes, std::size_t size, Clock::time_point deadline) {
  while (size > 0) {
    const ssize_t count = ::write(questions_, bytes, size);
    if (count > 0) {
      bytes += count;
      size -= static_cast<std::size_t>(count);
    } else if (count < 0 && errno == EAGAIN) {
      wait_for(questions_, POLLOUT, deadline);
    } else if (!(count < 0 && errno == EINTR)) {
      throw SubjectTrouble(Kind::crash, stop());
    }
  }
}

void Subject::read_all(char* bytes, std::size_t size, Clock::time_point deadline) {
  while (size > 0) {
    const ssize_t count = ::read(answers_, bytes, size);
    if (count > 0) {
      bytes += count;
      size -= static_cast<std::size_t>(count);
    } else if (count < 0 && errno == EAGAIN) {
      wait_for(answers_, POLLIN, deadline);
    } else if (!(count < 0 && errno == EINTR)) {
      throw SubjectTrouble(Kind::crash, stop());
    }
  }
}

std::string Subject::exchange(const std::string& message) {
  if (limits_.all.count() > 0 && spent_ > limits_.all) {
    stop();
    throw SubjectTrouble(Kind::silence, "no answer: the program has had all of its " + seconds(limits_.all));
  }
  struct Stopwatch {
    Clock::duration& spent;
    Clock::time_point start = Clock::now();
    ~Stopwatch() { spent += Clock::now() - start; }
  } stopwatch{spent_};
  if (child_ < 0) start();
  const auto deadline = stopwatch.start + limits_.answer;
  std::uint64_t size = message.size();
  write_all(reinterpret_cast<const char*>(&size), sizeof size, deadline);
  write_all(message.data(), message.size(), deadline);
  read_all(reinterpret_cast<char*>(&size), sizeof size, deadline);
  if (size == 0 || size > longest_message) {
    stop();
    throw SubjectTrouble(Kind::nonsense, "an answer of " + std::to_string(size) + " bytes");
  }
  std::string reply(size, '\0');
  read_all(reply.data(), size, deadline);
  const auto kind = static_cast<Reply>(reply[0]);
  reply.erase(0, 1);
  if (kind == Reply::answer) return reply;
  try {
    Reader reader(reply);
    if (kind == Reply::hole) {
      const auto function = reader.get<std::string>(), section = reader.get<std::string>();
      throw SubjectTrouble(Kind::hole, "not yet implemented: " + function + ", see " + section);
    }
    throw SubjectTrouble(Kind::refusal, "an exception: " + reader.get<std::string>());
  } catch (const WireError& error) {
    stop();
    throw SubjectTrouble(Kind::nonsense, std::string("an answer that cannot be read: ") + error.what());
  }
}

std::string Subject::printed() const {
  const off_t size = ::lseek(printed_, 0, SEEK_END);
  const auto shown = std::min<std::size_t>(size > 0 ? static_cast<std::size_t>(size) : 0, most_shown);
  std::string text(shown, '\0');
  const ssize_t count = ::pread(printed_, text.data(), shown, size - static_cast<off_t>(shown));
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return text;
}

}  // namespace sightline::labs
