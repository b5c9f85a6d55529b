#include "viz/compare/findings.h"

#include <array>
#include <cstdio>

#include "viz/partition_picture.h"

namespace sightline::viz {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string counted(std::uint64_t count, const std::string& one, const std::string& more) {
  return with_commas(count) + ' ' + (count == 1 ? one : more);
}

Verdict verdict_of(std::span<const Compared> compared, const CompareFindings& findings) {
  Verdict verdict;
  std::vector<std::string> others;
  for (const std::size_t i : dissenters(findings.walks)) others.push_back(compared[i].label);
  if (!others.empty()) {
    return {false, joined(others) + (others.size() == 1 ? " has" : " have") + " another hit of the ray than " +
                       compared.front().label};
  }
  std::size_t pixels = 0;
  for (std::size_t i = 1; i < findings.traced.size(); ++i) {
    const std::size_t differing = differing_pixels(findings.traced[i], findings.traced.front());
    if (differing > 0) others.push_back(compared[i].label + " at " + counted(differing, "pixel", "pixels"));
    pixels = findings.traced[i].hits.size();
  }
  if (!others.empty()) return {false, joined(others) + ": other hits than " + compared.front().label};
  const Hit<float>& hit = findings.walks.front().hit;
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "The ray hits triangle %u at t = %.7g", hit.prim_id, double(hit.t));
  verdict.text = hit.is_hit() ? text.data() : "The ray hits nothing";
  if (compared.size() == 1) {
    verdict.text += '.';  // beside nothing there is nothing to agree with
    return verdict;
  }
  if (pixels > 0) verdict.text += "; it and the rays of " + with_commas(pixels) + " pixels";
  verdict.text += pixels > 0 ? " have hits of the same bits in all " : ": the same bits in all ";
  verdict.text += std::to_string(compared.size()) + " structures.";
  return verdict;
}

}  // namespace sightline::viz
