#pragma once
/// A student's program, as the checks see it: functions by name, asked through pipes.
///
/// A process of its own, because what is being written crashes, loops and eats memory; the checks are told so and go
/// on.

#include <functional>
#include <map>
#include <string>
#include <tuple>

#include "labs/kit/hole.h"
#include "labs/kit/wire.h"

namespace sightline::labs {

class Service {
 public:
  /// Answers the question `name` with what f makes of the arguments asked with. Arguments and result are values of
  /// types that a wire takes.
  template <class F>
  void on(const std::string& name, F f) {
    add(name, std::function(std::move(f)));
  }

  /// Questions come in frames through the descriptor `in`, each answered through `out`, until `in` ends.
  /// Returns the status to exit with.
  int serve(int in, int out);

 private:
  template <class R, class... Args>
  void add(const std::string& name, std::function<R(Args...)> f) {
    answers_[name] = [f = std::move(f)](Reader& question, Writer& answer) {
      std::tuple<std::remove_cvref_t<Args>...> arguments{question.get<std::remove_cvref_t<Args>>()...};  // in order
      question.finish();
      answer.put(std::apply(f, std::move(arguments)));
    };
  }

  std::map<std::string, std::function<void(Reader&, Writer&)>, std::less<>> answers_;
};

/// Each lab's subject.cpp offers what the student has written.
void offer(Service& service);

}  // namespace sightline::labs
