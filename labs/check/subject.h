#pragma once
/// A student's program, run beside this one and asked through pipes.

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "labs/kit/wire.h"

namespace sightline::labs {

struct SubjectLimits {
  std::chrono::milliseconds answer{5000};         ///< For each question.
  std::uint64_t memory = std::uint64_t{4} << 30;  ///< Bytes of address space.
  std::chrono::seconds all{0};                    ///< For all questions together; 0 where that does not matter.
};

/// No answer, or none that can be read; what() tells why in words that begin a line: "a crash (signal 11, ...)".
class SubjectTrouble : public std::runtime_error {
 public:
  enum class Kind {
    hole,     ///< Not yet implemented.
    refusal,  ///< An exception.
    crash,    ///< It ended.
    silence,  ///< It did not answer in time.
    nonsense  ///< Bytes that are no answer.
  };
  SubjectTrouble(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

class Subject {
 public:
  /// `command` is the program and its arguments. It starts when it is asked first, and again after it has ended.
  explicit Subject(std::vector<std::string> command, const SubjectLimits& limits = {});
  ~Subject();
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  /// The answer to a question of this name. \throws SubjectTrouble
  template <class R, class... Args>
  R ask(const std::string& question, const Args&... arguments) {
    Writer message;
    message.put(question);
    (message.put(arguments), ...);
    const std::string answer = exchange(message.bytes());
    try {
      Reader reader(answer);
      R value = reader.get<R>();
      reader.finish();
      return value;
    } catch (const WireError& error) {
      stop();
      throw SubjectTrouble(SubjectTrouble::Kind::nonsense,
                           std::string("an answer that cannot be read: ") + error.what());
    }
  }

  /// What it has printed since it was asked first, the end of it where that is much.
  std::string printed() const;

 private:
  /// The answer's bytes, without those that say that it is one.
  std::string exchange(const std::string& message);
  void start();
  /// Returns how it ended, in words.
  std::string stop();

  using Clock = std::chrono::steady_clock;
  void write_all(const char* bytes, std::size_t size, Clock::time_point deadline);
  void read_all(char* bytes, std::size_t size, Clock::time_point deadline);
  void wait_for(int descriptor, short events, Clock::time_point deadline);

  std::vector<std::string> command_;
  SubjectLimits limits_;
  std::chrono::steady_clock::duration spent_{};  ///< Waiting for answers.
  pid_t child_ = -1;
  int questions_ = -1, answers_ = -1;
  int printed_ = -1;  ///< A file without a name that takes its standard output and error.
};

}  // namespace sightline::labs
