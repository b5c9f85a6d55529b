#include "sightline/io/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "sightline/io/file_error.h"

namespace sightline {
namespace {

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> count{0};
  const std::string mark = "." + std::to_string(getpid()) + "-" + std::to_string(count++);
  return path.parent_path() / ("." + path.stem().string() + mark + path.extension().string());
}

std::string why() { return std::strerror(errno); }

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)), temporary_(temporary_beside(path_)) {
  std::error_code absent, error;
  if (path_.filename().empty() || std::filesystem::is_directory(path_, absent)) {
    throw FileError(path_, 0, "a file to write", "a folder");
  }
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  if (error) throw FileError(path_.parent_path(), 0, "a folder that can be made", error.message());
  const int file = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) throw FileError(path_, 0, "a file that can be written", why());
  close(file);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!committed_) std::filesystem::remove(temporary_, ignored);
}

void OutputFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) throw FileError(path_, 0, "a file that can be written", error.message());
  committed_ = true;
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  OutputFile output(path);
  const int file = open(output.temporary().c_str(), O_WRONLY | O_CLOEXEC);
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
