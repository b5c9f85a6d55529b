#pragma once
/// One step of a construction: a node of the real structure beside what its builder weighed there.

#include <filesystem>
#include <memory>
#include <string>

#include "sightline/query/accelerator_spec.h"
#include "sightline/query/primitives_of.h"
#include "viz/build/build_tree.h"
#include "viz/build/replay.h"

namespace sightline::viz {

struct BuildStep {
  std::size_t node = 0;  ///< Index into BuildTree::nodes.
  std::optional<std::size_t> step;
  Decision decision;
  std::string title, command;
};

/// A structure, the tree it is, and its builder to be asked again.
class BuildStory {
 public:
  /// \throws std::invalid_argument for a structure that cannot be asked.
  BuildStory(std::shared_ptr<const TriangleMesh> mesh, const AcceleratorSpec& structure, std::string scene,
             std::string flags);

  const TriangleMesh& mesh() const { return *mesh_; }
  const BuildTree& tree() const { return tree_; }
  const AcceleratorSpec& structure() const { return structure_; }
  const std::string& scene() const { return scene_; }
  /// What is weighed at the node with this index.
  BuildStep step_at(std::size_t node) const;

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  AcceleratorSpec structure_;
  std::string scene_, flags_;
  PrimitivesOf<TriangleMesh> primitives_;
  std::unique_ptr<Tracer> tracer_;
  BuildTree tree_;
  std::unique_ptr<BuildReplay> replay_;
};

/// Lines about a step: counts, and what was weighed.
std::vector<std::string> facts_of(const BuildStory& story, const BuildStep& step);

/// The step with its candidates. Appears when whole. \throws FileError
void write_step_json(const std::filesystem::path& path, const BuildStory& story, const BuildStep& step);
void write_step_csv(const std::filesystem::path& path, const BuildStep& step);

}  // namespace sightline::viz
