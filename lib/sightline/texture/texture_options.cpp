#include "sightline/texture/texture_options.h"

#include <array>
#include <charconv>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace sightline::detail {
namespace {

template <class T>
std::string number_text(T value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

template <class T>
bool parse_number(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

bool parse_color(std::string_view text, Color& color) {
  for (int i = 0; i < 3; ++i) {
    const auto end = i < 2 ? text.find('/') : text.size();
    if (end == std::string_view::npos || !parse_number(text.substr(0, end), color[i])) return false;
    text.remove_prefix(i < 2 ? end + 1 : end);
  }
  return true;
}

/// What an enumeration's values are called, in their order.
std::vector<std::string_view> names_of(NoiseKind) {
  std::vector<std::string_view> names;
  for (const NoiseInfo& info : noise_infos) names.push_back(info.name);
  return names;
}
std::vector<std::string_view> names_of(Wave) { return {wave_names.begin(), wave_names.end()}; }

template <class T>
constexpr bool is_number = std::is_same_v<T, double> || std::is_same_v<T, int>;

template <class T>
bool is_within(const T& value, double lowest, double highest) {
  const auto holds = [&](double x) { return x >= lowest && x <= highest; };
  if constexpr (is_number<T>) return holds(value);
  if constexpr (std::is_same_v<T, Color>) return holds(value.x) && holds(value.y) && holds(value.z);
  if constexpr (std::is_enum_v<T>) return static_cast<std::size_t>(value) < names_of(value).size();
  return true;
}

}  // namespace

std::string allowed_text(const TextureSlot& slot, double lowest, double highest) {
  const std::string range = " from " + number_text(lowest) + " to " + number_text(highest);
  return std::visit(
      [&]<class T>(const T* place) -> std::string {
        if constexpr (std::is_same_v<T, double>) return "a number" + range;
        if constexpr (std::is_same_v<T, int>) return "a whole number" + range;
        if constexpr (std::is_same_v<T, std::uint64_t>) return "a whole number from 0 to 2^64 - 1";
        if constexpr (std::is_same_v<T, Color>) return "a color R/G/B of numbers" + range;
        if constexpr (std::is_enum_v<T>) {
          const auto names = names_of(*place);
          std::string text;
          for (std::size_t i = 0; i < names.size(); ++i) {
            text += i == 0 ? "" : i + 1 < names.size() ? ", " : " or ";
            text += names[i];
          }
          return text;
        }
      },
      slot);
}

std::string value_text(const TextureSlot& slot) {
  return std::visit(
      []<class T>(const T* place) -> std::string {
        if constexpr (std::is_same_v<T, Color>) {
          return number_text(place->x) + '/' + number_text(place->y) + '/' + number_text(place->z);
        } else if constexpr (std::is_enum_v<T>) {
          const auto names = names_of(*place);
          const auto index = static_cast<std::size_t>(*place);
          return index < names.size() ? std::string(names[index]) : "number " + number_text(index);
        } else {
          return number_text(*place);
        }
      },
      slot);
}

bool is_allowed(const TextureSlot& slot, double lowest, double highest) {
  return std::visit([&](const auto* place) { return is_within(*place, lowest, highest); }, slot);
}

bool assign(const TextureSlot& slot, std::string_view text, double lowest, double highest) {
  return std::visit(
      [&]<class T>(T* place) {
        T value{};
        if constexpr (std::is_same_v<T, Color>) {
          if (!parse_color(text, value)) return false;
        } else if constexpr (std::is_enum_v<T>) {
          const auto names = names_of(value);
          std::size_t index = 0;
          while (index < names.size() && names[index] != text) ++index;
          value = static_cast<T>(index);
        } else {
          if (!parse_number(text, value)) return false;
        }
        if (!is_within(value, lowest, highest)) return false;
        *place = value;
        return true;
      },
      slot);
}

void refuse(std::string_view texture, std::string_view option, std::string_view value, const std::string& allowed) {
  throw std::invalid_argument(std::string(texture) + ": " + std::string(option) + " = " + std::string(value) +
                              " is not allowed; expected " + allowed);
}

}  // namespace sightline::detail
