#pragma once
/// A walk as data.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "viz/walk/walk_model.h"

namespace sightline::viz {

/// All steps and cells; `pending` are nodes, the next to be taken up first. What is infinite is null. The keys are told
/// in viz/README.md.
nlohmann::ordered_json walk_json(const WalkModel& model);

/// The surfaces of the cells that the walk has come across by the end of the step, with `state`, the place of its name
/// in state_names. \throws FileError, std::runtime_error
void write_walk_vtp(const std::filesystem::path& path, const WalkModel& model, std::size_t step);
/// Mesh and outlines of these cells. \throws FileError, std::runtime_error
void write_walk_gltf(const std::filesystem::path& path, const WalkModel& model, std::size_t step);

}  // namespace sightline::viz
