#pragma once
/// What a scene file may say, in one place: the reader refuses all else by it, and data/scene.schema.json is held
/// against it.

#include <span>
#include <string_view>

#include "sightline/io/json_value.h"

namespace sightline {

/// The members of one kind of object.
struct SceneMembers {
  std::string_view kind;  ///< Also the name of its definition in the schema.
  std::span<const std::string_view> names;
};

/// All kinds but solids, which solid_file.h describes.
std::span<const SceneMembers> scene_members();

/// \throws FileError for what is not an object, and for a member that the kind does not have, naming those that it has
/// and, where one is close, the one that may be meant.
void check_members(const JsonValue& json, std::string_view kind);

/// The one member of these that an object has; \throws FileError where there is none or more than one.
std::string_view one_member(const JsonValue& json, std::span<const std::string_view> names);

}  // namespace sightline
