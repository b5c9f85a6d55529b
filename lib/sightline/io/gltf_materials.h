#pragma once

#include "sightline/io/gltf_accessors.h"
#include "sightline/io/model.h"

namespace sightline {

/// Materials and the images that they name, lights and cameras of a glTF file.
void read_gltf_surfaces(const JsonValue& document, const GltfAccessors& accessors, Model& model);
void read_gltf_lights(const JsonValue& document, Model& model);
void read_gltf_cameras(const JsonValue& document, Model& model);

}  // namespace sightline
