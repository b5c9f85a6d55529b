#pragma once
/// Models as bytes, from the process that dares to run Assimp to the one that does not trust it.

#include <filesystem>
#include <string>
#include <string_view>

#include "sightline/io/model.h"

namespace sightline {

std::string bytes_of(const Model& model);

/// \throws FileError, naming the model's file, where the bytes are not of a model that keeps M1 and M2.
Model model_of(const std::filesystem::path& path, std::string_view bytes);

/// \throws FileError where the model does not keep M1 and M2, has no triangle, or too many where its nodes place them.
void check_model(const std::filesystem::path& path, const Model& model);

}  // namespace sightline
