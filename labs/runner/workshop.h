#pragma once
/// Where things are: the labs, a student's folders, and how this machine compiles.

#include <filesystem>
#include <string>
#include <vector>

#include "labs/check/check.h"

namespace sightline::labs {

/// What the build has left for compiling students' programs: build.json beside the programs.
struct Toolchain {
  std::string compiler;
  std::vector<std::string> flags;      ///< Of all compilation, with the folders of headers.
  std::filesystem::path prelude;       ///< A header that is compiled beforehand; includes come first.
  std::vector<std::string> libraries;  ///< Of linking, in order.
};

class Workshop {
 public:
  /// `mine` is the student's folder; where it is empty, labs/mine. \throws FileError where the build's file is missing.
  explicit Workshop(std::filesystem::path mine = {});

  const Toolchain& toolchain() const { return toolchain_; }
  /// A lab's own folder: handout, starter, solution.
  std::filesystem::path folder_of(const Lab& lab) const { return labs_ / lab.folder(); }
  /// A file of the lab as it is to be completed: in a handout its starter, else the solution with holes.
  /// \throws FileError where there is neither
  std::string starter_text(const Lab& lab, const std::string& name) const;
  /// The student's folder of a lab.
  std::filesystem::path work_of(const Lab& lab) const { return mine_ / lab.folder(); }
  const std::filesystem::path& mine() const { return mine_; }
  const std::filesystem::path& labs() const { return labs_; }
  /// What compiling a student's program reads: sources, the prelude, the libraries.
  std::vector<std::filesystem::path> sources() const;
  /// Another program of this build.
  std::filesystem::path program(const std::string& name) const { return programs_ / name; }
  /// A path as a person in this folder would type it.
  static std::string shown(const std::filesystem::path& path);

 private:
  std::filesystem::path labs_, mine_, programs_;
  Toolchain toolchain_;
};

/// Every lab, in order.
const std::vector<Lab>& all_labs();

/// The lab with this number or name: "10", "kd-tree", "10-kd-tree". \throws std::invalid_argument, which lists them.
const Lab& lab_called(const std::string& text);

}  // namespace sightline::labs
