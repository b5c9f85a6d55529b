#pragma once
/// What stands in a starter where a function is to be written.

#include <stdexcept>
#include <string>

namespace sightline::labs {

/// "not yet implemented: <function>, see <section>".
class NotYet : public std::runtime_error {
 public:
  NotYet(std::string function, std::string section)
      : std::runtime_error("not yet implemented: " + function + ", see " + section),
        function_(std::move(function)),
        section_(std::move(section)) {}

  const std::string& function() const { return function_; }
  const std::string& section() const { return section_; }

 private:
  std::string function_, section_;
};

/// Takes the place of a function's body until that is written.
[[noreturn]] inline void not_yet_implemented(const char* function, const char* section) {
  throw NotYet(function, section);
}

}  // namespace sightline::labs
