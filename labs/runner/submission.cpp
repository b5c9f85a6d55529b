#include "labs/runner/submission.h"

#include <fstream>

#include "bench/run_program.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 1 << 20, most_unpacked = 64 << 20;

/// Runs tar. \throws FileError with the first thing that it says
void run_tar(const fs::path& about, const std::vector<std::string>& words, const fs::path& log) {
  const bool is_done = bench::run_program(words, log) == 0;
  const std::string said = bench::text_in(log);
  fs::remove(log);
  if (!is_done) throw FileError(about, 0, "an archive that tar reads and writes", said.substr(0, said.find('\n')));
}

}  // namespace

fs::path pack_submission(const Workshop& workshop, const Lab& lab) {
  const fs::path folder = workshop.mine() / "submissions", work = workshop.work_of(lab);
  const fs::path log = folder / ".log";
  OutputFile archive(folder / (lab.folder() + ".tar.gz"));
  std::vector<std::string> words{"tar", "-C", workshop.mine(), "-czf", archive.temporary()};
  for (const std::string& name : lab.files) {
    if (!fs::is_regular_file(work / name)) throw FileError(work / name, 0, "a file of the lab", "none");
    words.push_back(lab.folder() + "/" + name);
  }
  run_tar(archive.path(), words, log);
  archive.commit();
  return archive.path();
}

fs::path open_submission(const fs::path& path, const fs::path& scratch) {
  if (fs::is_directory(path)) return path;
  const std::string name = path.filename();
  if (!fs::is_regular_file(path) || !(name.ends_with(".tar.gz") || name.ends_with(".tgz"))) {
    throw FileError(path, 0, "a submission: a folder, or a .tar.gz as `submit` makes it", "neither");
  }
  const fs::path folder = scratch / "unpacked";
  fs::create_directories(folder);
  // What is larger than it may be unpacked ends with an error, and not with a full disk.
  run_tar(path,
          {"prlimit", "--fsize=" + std::to_string(most_unpacked), "timeout", "20", "tar", "-C", folder, "-xzf", path,
           "--no-same-owner", "--no-same-permissions", "--no-overwrite-dir"},
          scratch / "log");
  return folder;
}

LabFiles files_of(const fs::path& submission, const Lab& lab) {
  LabFiles files;
  const fs::path below = submission / lab.folder();
  const fs::path folder = fs::is_directory(fs::symlink_status(below)) ? below : submission;
  for (const std::string& name : lab.files) {
    const fs::path file = folder / name;
    const auto status = fs::symlink_status(file);
    if (!fs::exists(status)) continue;
    if (!fs::is_regular_file(status)) throw FileError(file, 0, "a regular file", "another kind");
    if (fs::file_size(file) > most_bytes)
      throw FileError(file, 0, "at most a megabyte", std::to_string(fs::file_size(file)) + " bytes");
    std::ifstream in(file, std::ios::binary);
    files[name] = {std::istreambuf_iterator<char>(in), {}};
  }
  if (files.empty() || files.size() == lab.files.size()) return files;
  for (const std::string& name : lab.files) {
    if (!files.contains(name)) throw FileError(folder / name, 0, "a file of lab " + lab.folder(), "none");
  }
  return files;
}

}  // namespace sightline::labs
