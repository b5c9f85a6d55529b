#pragma once
/// The answers to one workload, against which every contender's are held.

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/contender.h"
#include "bench/verify.h"

namespace sightline::bench {

/// One way to ask for both kinds of answers: the nearest hit, or whether there is one.
inline void ask(const Built& built, std::span<const Ray<float>> rays, std::span<Hit<float>> answers) {
  built.closest_hits(rays, answers);
}
inline void ask(const Built& built, std::span<const Ray<float>> rays, std::span<std::uint8_t> answers) {
  built.any_hits(rays, answers);
}
inline std::optional<TraversalStats> count(const Built& built, std::span<const Ray<float>> rays,
                                           std::span<Hit<float>> answers) {
  return built.count_closest(rays, answers);
}
inline std::optional<TraversalStats> count(const Built& built, std::span<const Ray<float>> rays,
                                           std::span<std::uint8_t> answers) {
  return built.count_any(rays, answers);
}
inline bool is_hit(const Hit<float>& answer) { return answer.is_hit(); }
inline bool is_hit(std::uint8_t answer) { return answer != 0; }
inline std::string answer_text(const Hit<float>& answer) { return hit_text(answer); }
inline std::string answer_text(std::uint8_t answer) { return answer ? "a hit" : "no hit"; }

/// Answer is Hit<float> or std::uint8_t. Brute force answers the rays of the sample, and any other ray about which two
/// structures differ, so that the message names the one that is wrong.
template <class Answer>
class Checks {
 public:
  /// Refers to all but `sample`. `place` is for messages, such as "dragon:3 primary".
  Checks(std::string place, const TriangleMesh& mesh, std::span<const Ray<float>> rays, const Built& reference,
         const Built& oracle, std::vector<std::size_t> sample)
      : place_(std::move(place)),
        mesh_(mesh),
        rays_(rays),
        oracle_(oracle),
        sample_(std::move(sample)),
        reference_(rays.size()),
        sure_(sample_.size()) {
    ask(reference, rays_, std::span<Answer>(reference_));
    std::vector<Ray<float>> sampled;
    for (const std::size_t i : sample_) sampled.push_back(rays_[i]);
    ask(oracle_, sampled, std::span<Answer>(sure_));
  }

  double hit_share() const {
    const auto hits = std::count_if(reference_.begin(), reference_.end(), [](const Answer& a) { return is_hit(a); });
    return reference_.empty() ? 0 : static_cast<double>(hits) / static_cast<double>(reference_.size());
  }

  /// answers[k] belong to the ray indices[k], or to ray k when there are no indices.
  /// \throws WrongHits naming `who` and the ray.
  void require_right(const std::string& who, std::span<const Answer> answers,
                     std::span<const std::size_t> indices = {}) const {
    if (indices.empty()) {
      if (answers.size() != rays_.size()) throw std::invalid_argument("answers to different numbers of rays");
      for (std::size_t k = 0; k < sample_.size(); ++k) {
        if (!is_same(answers[sample_[k]], sure_[k])) refuse(who, sample_[k], sure_[k], answers[sample_[k]]);
      }
    }
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const std::size_t ray = indices.empty() ? k : indices[k];
      if (is_same(answers[k], reference_[ray])) continue;
      Answer truth{};
      ask(oracle_, rays_.subspan(ray, 1), std::span<Answer>(&truth, 1));
      if (!is_same(answers[k], truth)) refuse(who, ray, truth, answers[k]);
      refuse("the structure that all are compared with", ray, truth, reference_[ray]);
    }
  }

  /// How many of a peer's answers are other than ours beyond rounding. Indices as above.
  std::size_t disagreeing(std::span<const Answer> answers, std::span<const std::size_t> indices = {}) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const std::size_t ray = indices.empty() ? k : indices[k];
      if constexpr (std::is_same_v<Answer, std::uint8_t>) {
        count += answers[k] != reference_[ray];
      } else {
        count += !agrees(mesh_, rays_[ray], reference_[ray], answers[k]);
      }
    }
    return count;
  }

 private:
  static bool is_same(const Hit<float>& a, const Hit<float>& b) { return bench::is_same(a, b); }
  static bool is_same(std::uint8_t a, std::uint8_t b) { return a == b; }

  [[noreturn]] void refuse(const std::string& who, std::size_t ray, const Answer& expected, const Answer& found) const {
    throw WrongHits(who + " is wrong, so no times are shown: " + place_ + " ray " + std::to_string(ray) +
                    ": expected " + answer_text(expected) + ", found " + answer_text(found));
  }

  std::string place_;
  const TriangleMesh& mesh_;
  std::span<const Ray<float>> rays_;
  const Built& oracle_;
  std::vector<std::size_t> sample_;
  std::vector<Answer> reference_;  ///< To all rays.
  std::vector<Answer> sure_;       ///< Of brute force, to those of the sample.
};

}  // namespace sightline::bench
