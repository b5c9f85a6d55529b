#include "labs/runner/compile.h"

#include <fstream>
#include <sstream>

#include "bench/run_program.h"
#include "sightline/io/file_error.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

/// What is compiled includes no more than these: the student's files, the lab's, the kit. The library is the build's.
bool is_up_to_date(const Workshop& workshop, const Lab& lab, const fs::path& source, const fs::path& program) {
  std::error_code none;
  const auto made = fs::last_write_time(program, none);
  if (none) return false;
  const auto is_older = [&](const fs::path& file) {
    const auto time = fs::last_write_time(file, none);
    return !none && time < made;
  };
  for (const std::string& word : workshop.toolchain().libraries) {
    if (word.starts_with("/") && !is_older(word)) return false;
  }
  for (const fs::path& folder : {source, workshop.folder_of(lab)}) {
    for (const auto& entry : fs::directory_iterator(folder, none)) {
      if (entry.is_regular_file() && !is_older(entry.path())) return false;
    }
    if (none) return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<std::string>> compile_commands(const Workshop& workshop, const Lab& lab, const fs::path& source,
                                                       const fs::path& build) {
  const Toolchain& tools = workshop.toolchain();
  const std::string object = build / "subject.o", program = build / "subject";
  std::vector<std::string> compile{tools.compiler};
  compile.insert(compile.end(), tools.flags.begin(), tools.flags.end());
  const std::string subject = workshop.folder_of(lab) / "subject.cpp";
  compile.insert(compile.end(),
                 {"-include", tools.prelude.string(), "-I" + source.string(), "-c", subject, "-o", object});
  std::vector<std::string> link{tools.compiler, object, "-o", program};
  link.insert(link.end(), tools.libraries.begin(), tools.libraries.end());
  return {compile, link};
}

Compiled compile_subject(const Workshop& workshop, const Lab& lab, const fs::path& source, const fs::path& build) {
  const fs::path program = build / "subject";
  if (is_up_to_date(workshop, lab, source, program)) return {true, program, {}};
  std::error_code error;
  fs::create_directories(build, error);
  if (error) throw FileError(build, 0, "a folder to build in", error.message());
  fs::remove(program, error);
  Compiled compiled{true, program, {}};
  const fs::path log = build / "messages";
  for (const auto& command : compile_commands(workshop, lab, source, build)) {
    compiled.is_built = bench::run_program(command, log) == 0;
    compiled.messages += bench::text_in(log);
    if (!compiled.is_built) break;
  }
  return compiled;
}

}  // namespace sightline::labs
