#include "viz/render_tool/picture_files.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "sightline/math/random.h"
#include "viz/color_ramp.h"

namespace sightline::render_tool {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

std::string date() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  char text[32];
  const std::size_t size = std::strftime(text, sizeof text, "%Y:%m:%d %H:%M:%S", localtime_r(&now, &local));
  return {text, size};
}

Attributes attributes_of(const Request& request, const Provenance& provenance,
                         const std::vector<std::string>& channels) {
  Attributes told{{"scene", request.scene}};
  told.insert(told.end(), request.told.begin(), request.told.end());
  told.emplace_back("samples", std::to_string(provenance.samples));
  if (provenance.share < 1) {
    told.emplace_back("unfinished", std::to_string(static_cast<int>(100 * provenance.share)) + "% of the samples");
  }
  std::string names;
  for (const std::string& channel : channels) names += (names.empty() ? "" : " ") + channel;
  told.emplace_back("channels", names);
  if (request.is_dated) told.emplace_back("seconds", std::to_string(provenance.seconds));

  Attributes attributes{{"Software", "Sightline " SIGHTLINE_VERSION}};
  std::string description;
  for (const auto& [name, value] : told) {
    description += (description.empty() ? "" : "; ") + name + " " + value;
    attributes.emplace_back("sightline:" + name, value);
  }
  attributes.emplace_back("ImageDescription", description);
  if (request.is_dated) attributes.emplace_back("DateTime", date());
  return attributes;
}

void put(LayeredImage& image, const viz::Rgb& color) {
  for (const double component : color) image.pixels.push_back(static_cast<float>(component));
}

/// Dark to light on a logarithmic scale up to the largest; less than 1 is black.
void put_counts(LayeredImage& image, const std::vector<float>& counts) {
  const double highest = std::max(2.0f, *std::max_element(counts.begin(), counts.end()));
  for (const float count : counts) {
    put(image, count < 1 ? viz::Rgb{} : viz::ramp(std::log(count) / std::log(highest), 0.15, 0.93));
  }
}

void put_depths(LayeredImage& image, const std::vector<float>& depths) {
  float nearest = INFINITY, farthest = 0;
  for (const float depth : depths) {
    if (!std::isfinite(depth)) continue;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  constexpr double darkest = 0.1;  // so that what is far is not taken for nothing
  for (const float depth : depths) {
    const double share = farthest > nearest ? (depth - nearest) / (farthest - nearest) : 0;
    const double gray = std::isfinite(depth) ? 1 - (1 - darkest) * share : 0;
    put(image, {gray, gray, gray});
  }
}

void put_ids(LayeredImage& image, const std::vector<float>& ids) {
  for (const float id : ids) {
    const std::uint64_t bits = id < 0 ? 0 : Random::hash(static_cast<std::uint64_t>(id) + 1);
    const auto component = [&](int byte) { return 0.25 + 0.75 * static_cast<double>(bits >> (8 * byte) & 255) / 255; };
    put(image, id < 0 ? viz::Rgb{} : viz::Rgb{component(0), component(1), component(2)});
  }
}

std::filesystem::path file_of(const std::filesystem::path& picture, Aov aov) {
  std::filesystem::path path = picture;
  return path.replace_extension("." + std::string(info_of(aov).name) + picture.extension().string());
}

}  // namespace

LayeredImage visible(const FilmState& film, Aov aov) {
  const LayeredImage raw = picture_of(film, aov);
  LayeredImage image{film.width, film.height, {"R", "G", "B"}, {}, true, {}};
  image.pixels.reserve(film.sums.size() * 3);
  switch (aov) {
    case Aov::depth:
      put_depths(image, raw.pixels);
      break;
    case Aov::normal:
      for (const PixelFacts& facts : film.facts) {
        const bool is_any = facts.normal != Vec3f(0);
        for (int i = 0; i < 3; ++i) image.pixels.push_back(is_any ? (facts.normal[i] + 1) / 2 : 0);
      }
      break;
    case Aov::id:
      put_ids(image, raw.pixels);
      break;
    case Aov::cost:
    case Aov::samples:
      put_counts(image, raw.pixels);
  }
  return image;
}

std::vector<std::filesystem::path> picture_files(const Request& request) {
  std::vector<std::filesystem::path> files{request.out};
  if (holds_floats(request.out)) return files;
  for (const Aov aov : request.aovs) files.push_back(file_of(request.out, aov));
  return files;
}

void write_pictures(const Request& request, const FilmState& film, const Provenance& provenance) {
  const auto write = [&](const std::filesystem::path& path, LayeredImage image) {
    image.attributes = attributes_of(request, provenance, image.channels);
    write_layers(path, image);
  };
  if (holds_floats(request.out)) {
    write(request.out, picture_of(film, request.exposure, request.aovs));
    return;
  }
  write(request.out, picture_of(film, request.exposure));
  for (const Aov aov : request.aovs) write(file_of(request.out, aov), visible(film, aov));
}

}  // namespace sightline::render_tool
