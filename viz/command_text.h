#pragma once
/// Command lines as text that a shell takes back.

#include <string>
#include <string_view>
#include <vector>

#include "sightline/math/ray.h"

namespace sightline::viz {

/// In the fewest digits that are read back as the same.
std::string shortest(double number);
std::string shortest(float number);

/// "0.5,1,2,0,0,-1": origin and direction.
std::string text_of(const Ray<float>& ray);
std::string text_of(const Ray<double>& ray);

/// Quoted for a shell where that is needed.
std::string quoted(const std::string& word);

/// " --zoom 2", or " --ray=-1,..." where the value would be taken for an option.
std::string option_text(const std::string& option, const std::string& value);
/// The same, of azimuth, elevation and zoom those that are not the usual ones.
std::string camera_text(double azimuth, double elevation, double zoom);
/// " --size 1200x900"
std::string size_text(int width, int height);

/// What quoted() and spaces have made of words, as these again.
std::vector<std::string> words_of(std::string_view command);

}  // namespace sightline::viz
