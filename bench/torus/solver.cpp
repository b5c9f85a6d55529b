#include "bench/torus/solver.h"

#include "bench/peers/ferrari.h"

namespace sightline::bench {
namespace {

class LevelSolver final : public TorusSolver {
 public:
  explicit LevelSolver(Level level) : level_(level) {}
  RootList solve(const Torus& torus, const Ray<double>& ray) const override { return torus_roots(torus, ray, level_); }
  std::size_t count_all(const Torus& torus, std::span<const Ray<double>> rays) const override {
    std::size_t count = 0;
    for (const Ray<double>& ray : rays) count += static_cast<std::size_t>(torus_roots(torus, ray, level_).count);
    return count;
  }

 private:
  Level level_;
};

class FerrariSolver final : public TorusSolver {
 public:
  RootList solve(const Torus& torus, const Ray<double>& ray) const override {
    std::array<double, 4> roots;
    const int count = ferrari_roots(torus, ray, roots);
    RootList list;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (i == 0 || roots[i] != roots[i - 1]) list.add({roots[i], 0, 1});
    }
    return list;
  }
  std::size_t count_all(const Torus& torus, std::span<const Ray<double>> rays) const override {
    std::array<double, 4> roots;
    std::size_t count = 0;
    for (const Ray<double>& ray : rays) count += static_cast<std::size_t>(ferrari_roots(torus, ray, roots));
    return count;
  }
};

}  // namespace

std::unique_ptr<TorusSolver> make_torus_solver(std::optional<Level> level) {
  if (level) return std::make_unique<LevelSolver>(*level);
  return std::make_unique<FerrariSolver>();
}

}  // namespace sightline::bench
