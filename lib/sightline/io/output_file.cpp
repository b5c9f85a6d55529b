#include "sightline/io/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sightline/io/file_error.h"
#include "sightline/io/leftovers.h"

namespace sightline {
namespace {

std::string why(int error = errno) { return std::strerror(error); }

// ---- Names

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// Links in /proc name an open file, as those behind /dev/stdout do, and not the path that they show.
bool is_in_proc(const std::filesystem::path& path) {
  constexpr long proc_magic = 0x9fa0;  // of statfs(2)
  struct statfs system {};
  return statfs(folder_of(path).c_str(), &system) == 0 && system.f_type == proc_magic;
}

struct Target {
  std::filesystem::path path;
  bool is_replaceable = true;
  mode_t mode = 0666;
};

/// Where writing to `path` would end, by its links.
Target target_of(const std::filesystem::path& path) {
  constexpr int most_links = 40;  // as Linux follows
  Target target{path};
  for (int links = 0; links <= most_links; ++links) {
    struct stat status {};
    if (lstat(target.path.c_str(), &status) != 0) {
      if (errno != ENOENT) throw FileError(path, 0, "a file that can be written", why());
      return target;
    }
    if (!S_ISLNK(status.st_mode)) {
      target.is_replaceable = S_ISREG(status.st_mode);
      target.mode = status.st_mode & 0777;
      return target;
    }
    target.is_replaceable = !is_in_proc(target.path);
    if (!target.is_replaceable) return target;
    target.path = folder_of(target.path) / std::filesystem::read_symlink(target.path);
  }
  throw FileError(path, 0, "a file that can be written", why(ELOOP));
}

/// Never the name of another file, so that it may be removed before it is made.
std::filesystem::path temporary_beside(const std::filesystem::path& path, std::string extension) {
  std::random_device random;
  const std::string mark = "." + std::to_string(getpid()) + "-" + std::to_string(random());
  std::string stem = "." + path.stem().string();
  if (stem.size() + mark.size() + extension.size() > NAME_MAX) {
    if (1 + mark.size() + extension.size() > NAME_MAX) extension.clear();
    std::size_t size = std::min(stem.size(), NAME_MAX - mark.size() - extension.size());
    while (size > 1 && size < stem.size() && (stem[size] & 0xc0) == 0x80) --size;  // not inside a character of UTF-8
    stem.resize(size);
  }
  return path.parent_path() / (stem + mark + extension);
}

/// Folders above a file that are not there yet, the innermost first.
std::vector<std::filesystem::path> missing_folders(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> folders;
  std::error_code error;
  for (auto folder = file.parent_path(); !folder.empty() && !std::filesystem::exists(folder, error) && !error;
       folder = folder.parent_path()) {
    folders.push_back(folder);
  }
  return folders;
}

}  // namespace

// ---- The file

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code absent, error;
  if (path_.filename().empty() || std::filesystem::is_directory(path_, absent)) {
    throw FileError(path_, 0, "a file to write", "a folder");
  }
  Target target = target_of(path_);
  target_ = std::move(target.path);
  if (!target.is_replaceable) {
    temporary_ = target_;
    // Not opened here: a pipe would wait for its reader, and the reader take the closing for the end.
    if (access(target_.c_str(), W_OK) != 0) throw FileError(path_, 0, "a file that can be written", why());
    return;
  }
  temporary_ = temporary_beside(target_, path_.extension().string());
  leftovers_ = std::make_unique<Leftovers>(std::vector{temporary_}, missing_folders(temporary_));
  if (target_.has_parent_path()) std::filesystem::create_directories(target_.parent_path(), error);
  if (error) throw FileError(target_.parent_path(), 0, "a folder that can be made", error.message());
  const int file = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, target.mode | S_IRUSR | S_IWUSR);
  if (file < 0) throw FileError(path_, 0, "a file that can be written", why());
  close(file);
}

OutputFile::~OutputFile() = default;

void OutputFile::commit() {
  if (!leftovers_) return;
  struct stat replaced {};
  if (stat(target_.c_str(), &replaced) == 0) chmod(temporary_.c_str(), replaced.st_mode & 0777);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    throw FileError(path_, 0, "a file that can be written", why());
  }
  leftovers_.reset();  // removes nothing: the name is gone and the folder in use
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  OutputFile output(path);
  // Appending matters only where O3 holds: standard output may be a file that has something already.
  const int file = open(output.temporary().c_str(), O_WRONLY | O_APPEND | O_NOCTTY | O_CLOEXEC);
  bool good = file >= 0;
  while (good && !text.empty()) {
    const ssize_t count = write(file, text.data(), text.size());
    if (count >= 0) text.remove_prefix(static_cast<std::size_t>(count));
    good = count >= 0 || errno == EINTR;
  }
  const std::string reason = good ? "" : why();
  // A full disk may be reported as late as here.
  const bool closed = file >= 0 && close(file) == 0;
  if (!good || !closed) throw FileError(path, 0, "a file that can be written", good ? why() : reason);
  output.commit();
}

}  // namespace sightline
