#pragma once
/// Options of textures that describe themselves: their names, limits and meaning serve validation, help and command
/// lines alike.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "sightline/noise/noise_options.h"
#include "sightline/texture/color.h"
#include "sightline/texture/waves.h"

namespace sightline {

/// Where an option is kept.
using TextureSlot = std::variant<double*, int*, std::uint64_t*, Color*, NoiseKind*, Wave*>;

/// One field of an options struct O. Limits are of numbers and of a color's components; others have none.
template <class O>
struct TextureField {
  std::string_view name;
  TextureSlot (*slot)(O&);
  double lowest, highest;
  std::string_view help;
};

/// A field without its struct, for those who list them.
struct TextureOptionInfo {
  std::string_view name;
  std::string default_value;
  std::string allowed;
  std::string_view help;
};

namespace detail {

/// "a number from 0 to 1", "sine, sawtooth or crease".
std::string allowed_text(const TextureSlot& slot, double lowest, double highest);
std::string value_text(const TextureSlot& slot);
bool is_allowed(const TextureSlot& slot, double lowest, double highest);
/// False, and nothing changes, where `text` is no allowed value.
bool assign(const TextureSlot& slot, std::string_view text, double lowest, double highest);
[[noreturn]] void refuse(std::string_view texture, std::string_view option, std::string_view value,
                         const std::string& allowed);

}  // namespace detail

/// \throws std::invalid_argument naming texture, option, value and what is allowed. NaN is never allowed.
template <class O>
void validate_texture(std::string_view texture, O options) {
  for (const TextureField<O>& field : O::fields()) {
    const TextureSlot slot = field.slot(options);
    if (detail::is_allowed(slot, field.lowest, field.highest)) continue;
    detail::refuse(texture, field.name, detail::value_text(slot),
                   detail::allowed_text(slot, field.lowest, field.highest));
  }
}

/// Sets the option called `name` from text; a color is "0.7/0.4/0.2".
/// \throws std::invalid_argument when there is no such option (the message lists them) or the text is no allowed value
/// of it; the options are then as before.
template <class O>
void set_texture_option(std::string_view texture, O& options, std::string_view name, std::string_view text) {
  std::string known;
  for (const TextureField<O>& field : O::fields()) {
    known += (known.empty() ? "" : ", ") + std::string(field.name);
    if (field.name != name) continue;
    const TextureSlot slot = field.slot(options);
    if (!detail::assign(slot, text, field.lowest, field.highest)) {
      detail::refuse(texture, name, text, detail::allowed_text(slot, field.lowest, field.highest));
    }
    return;
  }
  detail::refuse(texture, name, text, "one of " + known);
}

}  // namespace sightline
