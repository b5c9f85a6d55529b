#pragma once
/// What a student hands in.

#include <filesystem>
#include <map>
#include <string>

#include "labs/runner/workshop.h"

namespace sightline::labs {

/// The files of one lab, by name.
using LabFiles = std::map<std::string, std::string>;

/// Packs the student's files of a lab into labs/mine/submissions/NN-name.tar.gz. The archive's path.
/// \throws FileError
std::filesystem::path pack_submission(const Workshop& workshop, const Lab& lab);

/// A folder to read submissions from: `path` itself, or where its archive was unpacked to, under `scratch`. Archives
/// are unpacked by tar, without their owners, modes or links. \throws FileError where it is neither
std::filesystem::path open_submission(const std::filesystem::path& path, const std::filesystem::path& scratch);

/// The lab's files in a submission: in its folder NN-name, or at the top where that holds them. Empty where none is
/// there. Only what is a regular file of at most a megabyte is taken, and never through a link.
/// \throws FileError where some are there and others missing, or one is not of that kind
LabFiles files_of(const std::filesystem::path& submission, const Lab& lab);

}  // namespace sightline::labs
