#include <algorithm>
#include <memory>
#include <numbers>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/chance.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/oracle.h"
#include "bench/accuracy/triangle_tests.h"
#include "sightline/query/leaves.h"

namespace sightline::bench {
namespace {

constexpr std::size_t around = 8;  ///< Triangles around a common corner: a leaf.

struct Fan {
  std::array<Triangle, around> triangles;
  std::vector<float> block = std::vector<float>(TriangleBlock::rows * around + TriangleBlock::lanes);
  Aabb bounds;
};
struct Question {
  Ray<float> ray;
  std::size_t fan;
};
struct Questions {
  std::vector<Fan> fans;
  std::vector<Question> asked;
};
using Answers = std::array<TestedCrossing<double>, around>;

Fan fan_of(Chance& chance) {
  Fan fan;
  const Vec3d middle = chance.point(10), normal = chance.direction();
  const Vec3d side = glm::normalize(glm::cross(normal, chance.direction())), up = glm::cross(normal, side);
  std::array<Vec3f, around> rim;
  for (std::size_t i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + chance.between(0, 0.7)) / around;
    const double reach = chance.scale(0.1, 1);
    rim[i] =
        Vec3f(middle + reach * (std::cos(angle) * side + std::sin(angle) * up + chance.between(-0.3, 0.3) * normal));
  }
  for (std::size_t i = 0; i < around; ++i) {
    fan.triangles[i] = {Vec3f(middle), rim[i], rim[(i + 1) % around]};
    fan.bounds.extend(bounds_of(fan.triangles[i]));
    TriangleBlock::store(fan.triangles[i], static_cast<std::uint32_t>(i), fan.block.data(), around,
                         static_cast<std::uint32_t>(i));
  }
  return fan;
}

/// At points of edges between two triangles, every fourth at the common corner; or at points inside.
Questions questions_of(const Effort& effort, bool at_edges) {
  Chance chance(effort.seed);
  Questions questions;
  for (std::size_t i = 0; i < 64; ++i) questions.fans.push_back(fan_of(chance));
  const std::size_t count = effort.count(16'000, 2'000);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t f = chance.below(questions.fans.size());
    const Triangle& triangle = questions.fans[f].triangles[chance.below(around)];
    const double along = at_edges && i % 4 == 0 ? 0 : chance.unit(), share = at_edges ? 0 : chance.unit();
    const Vec3d a(triangle.a), b(triangle.b), c(triangle.c);
    const double root = std::sqrt(along);
    const Vec3d to = at_edges ? a + along * (b - a) : a + root * ((1 - share) * (b - a) + share * (c - a));
    const Vec3f from(to + chance.scale(3, 30) * chance.direction());
    questions.asked.push_back({{from, Vec3f(to - Vec3d(from))}, f});
  }
  return questions;
}

/// A test from a textbook, with what it keeps of a triangle made beforehand.
template <class Test>
class Textbook {
 public:
  explicit Textbook(const Questions& questions) {
    for (const Fan& fan : questions.fans) {
      for (const Triangle& triangle : fan.triangles) prepared_.emplace_back(triangle);
    }
  }
  template <class See>
  void ask(const Question& question, const Fan&, const See& see) const {
    const Test test(question.ray);
    for (std::size_t i = 0; i < around; ++i) {
      const auto found = test(prepared_[question.fan * around + i]);
      if (found.is_hit) see(i, found.t, found.u, found.v);
    }
  }

 private:
  std::vector<typename Test::Prepared> prepared_;
};

template <Level level, class T>
class Ours {
 public:
  explicit Ours(const Questions&) {}
  template <class See>
  void ask(const Question& question, const Fan& fan, const See& see) const {
    const Ray<T> ray{Vec3<T>(question.ray.origin), Vec3<T>(question.ray.direction)};
    PreparedTriangles<T> prepared(ray, fan.bounds);
    auto all = [&](std::uint32_t id, const Crossing& crossing) {
      see(id, static_cast<T>(crossing.t), static_cast<T>(crossing.u), static_cast<T>(crossing.v));
      return true;
    };
    detail::cross_block<level>(prepared, TriangleBlock(fan.block.data(), around), std::numeric_limits<T>::infinity(),
                               all);
  }
};

using Truths = std::vector<std::array<std::optional<TrueCrossing>, around>>;

Truths truths_of(const Questions& questions) {
  Truths truths(questions.asked.size());
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const Question& question = questions.asked[i];
    for (std::size_t k = 0; k < around; ++k) {
      truths[i][k] = true_crossing(questions.fans[question.fan].triangles[k], to_double(question.ray));
    }
  }
  return truths;
}

template <class Asker>
Choice choice_of(const std::string& name, const std::shared_ptr<const Questions>& questions, const Truths& truths) {
  const Asker asker(*questions);
  ErrorSum sum;
  std::size_t leaks = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    Answers answers;
    const Question& question = questions->asked[i];
    asker.ask(question, questions->fans[question.fan], [&](std::size_t k, double t, double u, double v) {
      answers[k] = {true, t, u, v};
    });
    bool is_seen = false, is_there = false;
    for (std::size_t k = 0; k < around; ++k) {
      const auto& truth = truths[i][k];
      sum.decide(answers[k].is_hit == truth.has_value());
      is_seen |= answers[k].is_hit, is_there |= truth.has_value();
      if (!answers[k].is_hit || !truth) continue;
      sum.add(std::max({std::fabs(truth->t.off(answers[k].t)), std::fabs(truth->u.off(answers[k].u)),
                        std::fabs(truth->v.off(answers[k].v))}));
    }
    leaks += is_there && !is_seen;
  }
  const auto pass = [asker, questions] {
    double all = 0;
    for (const Question& question : questions->asked) {
      asker.ask(question, questions->fans[question.fan],
                [&](std::size_t, double t, double u, double v) { all += t + u + v; });
    }
    return all;
  };
  const double per_million = ErrorSum::million / static_cast<double>(truths.size());
  return {name, sum.errors(), pass, {{"leaks/million rays", per_million * static_cast<double>(leaks)}}};
}

Panel panel_of(const Effort& effort, bool at_edges) {
  effort.say(at_edges ? "rays at edges" : "rays inside");
  const auto questions = std::make_shared<const Questions>(questions_of(effort, at_edges));
  const Truths truths = truths_of(*questions);
  Panel panel{
      at_edges ? "at edges" : "inside",
      at_edges ? "rays at edges and corners that eight triangles share" : "rays inside of one of eight triangles",
      "test",
      "of t (in lengths of the direction), u and v",
      at_edges ? ErrorKind::wrong : ErrorKind::maximum,
      static_cast<double>(truths.size() * around)};
  panel.choices = {
      choice_of<Textbook<MoellerTrumbore<float>>>("Moeller-Trumbore float", questions, truths),
      choice_of<Textbook<MoellerTrumbore<double>>>("Moeller-Trumbore double", questions, truths),
      choice_of<Textbook<BaldwinWeber<float>>>("Baldwin-Weber float", questions, truths),
      choice_of<Textbook<BaldwinWeber<double>>>("Baldwin-Weber double", questions, truths),
      choice_of<Textbook<Pluecker<float>>>("Pluecker float", questions, truths),
      choice_of<Textbook<Woop<float>>>("Woop float", questions, truths),
      choice_of<Textbook<Woop<double>>>("Woop double", questions, truths),
      choice_of<Ours<Level::fast, float>>("ours fast", questions, truths),
      choice_of<Ours<Level::watertight, float>>("ours watertight", questions, truths),
      choice_of<Ours<Level::watertight, double>>("ours double", questions, truths),
  };
  return panel;
}

}  // namespace

Axis triangle_axis() {
  return {"triangle", "how a ray is tested against a triangle", [](const Effort& effort) {
            return std::vector{panel_of(effort, true), panel_of(effort, false)};
          }};
}

}  // namespace sightline::bench
