#include "labs/runner/handout.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>

#include "bench/run_program.h"
#include "labs/runner/starter.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The repository's own files, as git knows them. \throws FileError where it is none
std::vector<fs::path> files_of_repository(const fs::path& root) {
  const fs::path log = fs::temp_directory_path() / ("sightline-files-" + std::to_string(::getpid()));
  const bool is_done = bench::run_program({"git", "-C", root, "ls-files", "-z"}, log) == 0;
  const std::string names = bench::text_in(log);
  fs::remove(log);
  if (!is_done) throw FileError(root, 0, "a git repository", names.substr(0, names.find('\n')));
  std::vector<fs::path> files;
  std::size_t at = 0;
  for (std::size_t end; (end = names.find('\0', at)) != std::string::npos; at = end + 1) {
    files.emplace_back(names.substr(at, end - at));
  }
  return files;
}

/// "labs/10-kd-tree/solution/kd_tree.h".
bool is_secret(const fs::path& file) {
  const std::string name = file.generic_string();
  if (!name.starts_with("labs/")) return false;
  return name.find("/solution/") != std::string::npos || file.filename() == "mutants.txt";
}

/// Three lines of a solution, one after the other, or all where there are fewer, are found nowhere by chance.
constexpr std::size_t telling = 3;

std::vector<std::string> trimmed_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string::npos) lines.push_back(line.substr(first));
  }
  return lines;
}

/// Runs of lines that only a solution has.
std::set<std::string> secrets_of(const Workshop& workshop) {
  std::set<std::string> secrets;
  for (const Lab& lab : all_labs()) {
    for (const std::string& name : lab.files) {
      const fs::path path = workshop.folder_of(lab) / "solution" / name;
      const auto lines = secret_lines(path, text_of(path));
      for (std::size_t i = 0; i + telling <= lines.size(); ++i) {
        secrets.insert(lines[i] + "\n" + lines[i + 1] + "\n" + lines[i + 2]);
      }
    }
  }
  return secrets;
}

bool leaks(const std::string& text, const std::set<std::string>& secrets) {
  const auto lines = trimmed_lines(text);
  for (std::size_t i = 0; i + telling <= lines.size(); ++i) {
    if (secrets.contains(lines[i] + "\n" + lines[i + 1] + "\n" + lines[i + 2])) return true;
  }
  return false;
}

}  // namespace

int write_handout(const Workshop& workshop, const fs::path& folder) {
  if (fs::exists(folder)) throw FileError(folder, 0, "a folder that is not there yet", "one that is");
  const fs::path root = workshop.labs().parent_path();
  const auto secrets = secrets_of(workshop);
  const fs::path made = folder.string() + ".partial";
  fs::remove_all(made);
  std::size_t count = 0;
  for (const fs::path& file : files_of_repository(root)) {
    if (is_secret(file) || !fs::exists(root / file)) continue;
    fs::create_directories((made / file).parent_path());
    fs::copy_file(root / file, made / file);
    ++count;
  }
  for (const Lab& lab : all_labs()) {
    for (const std::string& name : lab.files) {
      const fs::path solution = workshop.folder_of(lab) / "solution" / name;
      write_text(made / "labs" / lab.folder() / "starter" / name, starter_of(solution, text_of(solution)));
      ++count;
    }
  }
  for (const auto& entry : fs::recursive_directory_iterator(made)) {
    if (!entry.is_regular_file() || !leaks(text_of(entry.path()), secrets)) continue;
    const fs::path leak = entry.path().lexically_relative(made);
    fs::remove_all(made);
    throw FileError(leak, 0, "no lines of a solution", "some");
  }
  fs::rename(made, folder);
  std::printf("%s: %zu files, none with a solution in it\n", folder.c_str(), count);
  return 0;
}

}  // namespace sightline::labs
