#pragma once
/// Structures that are compiled apart from the library, such as a student's, and loaded while a program runs.
///
/// The file is a shared object with one symbol, `sightline_structure`, made by structure_plugin_of.h with the compiler
/// and the headers that the program was made with. What it needs of the library it takes from the program, which is
/// therefore linked so that it offers its symbols.

#include <filesystem>
#include <memory>
#include <string>

#include "sightline/query/tracer.h"

namespace sightline {

struct StructurePlugin {
  std::string (*build)();  ///< plugin_build() of where it was compiled.
  AcceleratorInfo (*info)();
  std::unique_ptr<Tracer> (*make)(std::shared_ptr<const TriangleMesh>, const TracerSettings&);
};

/// What has to be the same on both sides: compiler, precision of what is exchanged, layout.
inline std::string plugin_build() {
  return std::string(__VERSION__) + ", " + std::to_string(sizeof(AcceleratorInfo)) + " " +
         std::to_string(sizeof(TracerSettings)) + " " + std::to_string(sizeof(TriangleMesh)) + " " +
         std::to_string(sizeof(TraversalStats));
}

/// Adds the structure in the file to those that make_tracer() knows, and returns its name. A file that was loaded
/// before is not loaded again. Not thread-safe: command lines are read first.
/// \throws std::runtime_error where there is no such file, it is no structure, or was compiled for another program;
/// std::invalid_argument where its name is taken
std::string load_structure(const std::filesystem::path& file);

namespace detail {

/// Those that were loaded; of an unknown name null.
const StructurePlugin* loaded_structure(std::string_view name);

/// Everything about a structure that is in the registry or was loaded.
void add_info(AcceleratorInfo info);

}  // namespace detail
}  // namespace sightline
