#pragma once
/// From a student's files to a program that can be asked.

#include <filesystem>
#include <string>

#include "labs/runner/workshop.h"

namespace sightline::labs {

/// What compiling came to.
struct Compiled {
  bool is_built = false;
  std::filesystem::path program;
  std::string messages;  ///< The compiler's.
};

/// Compiles the lab's subject with the headers in `source`; what is written goes into `build`. What is there and newer
/// than all that it was made of is not made again.
Compiled compile_subject(const Workshop& workshop, const Lab& lab, const std::filesystem::path& source,
                         const std::filesystem::path& build);

/// The words of the command lines that do so, for whoever runs them elsewhere.
std::vector<std::vector<std::string>> compile_commands(const Workshop& workshop, const Lab& lab,
                                                       const std::filesystem::path& source,
                                                       const std::filesystem::path& build);

}  // namespace sightline::labs
