// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/membrane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/SparseCholesky>
#include <span>
#include <unordered_map>
#include <utility>

namespace relievo {
namespace {

struct Weighted {
  int dcol = 0, drow = 0;
  double weight = 0;
};
// Second differences; the mixed one counts twice in the energy, hence sqrt(2).
constexpr double kSqrt2 = 1.4142135623730951;
constexpr std::array<Weighted, 3> kAlongX{{{-1, 0, 1}, {0, 0, -2}, {1, 0, 1}}};
constexpr std::array<Weighted, 3> kAlongY{{{0, -1, 1}, {0, 0, -2}, {0, 1, 1}}};
constexpr std::array<Weighted, 4> kMixed{
    {{0, 0, kSqrt2}, {1, 0, -kSqrt2}, {0, 1, -kSqrt2}, {1, 1, kSqrt2}}};

class Plate {
 public:
  Plate(const std::vector<std::size_t>& hole, const Rim& rim, GridSize size)
      : size_(size), right_(Eigen::VectorXd::Zero(count(hole))) {
    cells_.reserve(hole.size() + rim.size());
    int unknown = 0;
    for (const std::size_t cell : hole) cells_.emplace(cell, Height{.unknown = unknown++});
    for (const auto& [cell, z] : rim) cells_.emplace(cell, Height{.z = z});
    for (const std::size_t cell : hole) {
      const auto cols = static_cast<std::size_t>(size.cols);
      const Cell at{.col = static_cast<int>(cell % cols), .row = static_cast<int>(cell / cols)};
      // Every difference that touches this cell, each counted with its first unknown cell only.
      for (const Weighted& w : kAlongX) add(kAlongX, {at.col - w.dcol, at.row - w.drow}, cell);
      for (const Weighted& w : kAlongY) add(kAlongY, {at.col - w.dcol, at.row - w.drow}, cell);
      for (const Weighted& w : kMixed) add(kMixed, {at.col - w.dcol, at.row - w.drow}, cell);
    }
  }

  /// Empty where the rim does not determine the plate.
  Eigen::VectorXd solved() const {
    const Eigen::Index count = right_.size();
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) return {};
    const Eigen::VectorXd& pivots = solver.vectorD();
    // A plate that can still be tilted or lifted has pivots of rounding size only.
    if (!(pivots.minCoeff() > 1e-10 * pivots.maxCoeff())) return {};
    Eigen::VectorXd heights = solver.solve(right_);
    if (!heights.allFinite()) return {};
    return heights;
  }

 private:
  static Eigen::Index count(const std::vector<std::size_t>& hole) {
    return static_cast<Eigen::Index>(hole.size());
  }

  /// One of the unknowns, or known.
  struct Height {
    int unknown = -1;
    float z = 0;
  };

  /// One squared difference of the energy, unless a cell of it has no height at all.
  void add(std::span<const Weighted> difference, Cell at, std::size_t for_cell) {
    double fixed = 0;
    std::array<std::pair<int, double>, 4> unknowns{};
    std::size_t count = 0;
    for (const Weighted& w : difference) {
      const Cell cell{.col = at.col + w.dcol, .row = at.row + w.drow};
      if (!size_.contains(cell)) return;
      const std::size_t index = size_.index(cell);
      const auto found = cells_.find(index);
      if (found == cells_.end()) return;
      const Height& height = found->second;
      if (height.unknown >= 0) {
        if (count == 0 && index != for_cell) return;
        unknowns[count++] = {height.unknown, w.weight};
      } else {
        fixed += w.weight * static_cast<double>(height.z);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      right_[unknowns[i].first] -= unknowns[i].second * fixed;
      for (std::size_t j = 0; j < count; ++j) {
        entries_.emplace_back(unknowns[i].first, unknowns[j].first,
                              unknowns[i].second * unknowns[j].second);
      }
    }
  }

  GridSize size_;
  std::unordered_map<std::size_t, Height> cells_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

}  // namespace

std::vector<float> membraneOver(const std::vector<std::size_t>& hole, const Rim& rim, GridSize size,
                                const Task& task) {
  task.check();
  if (hole.empty() || hole.size() > kMostMembraneCells) return {};
  const Eigen::VectorXd solved = Plate(hole, rim, size).solved();
  task.check();
  std::vector<float> heights(static_cast<std::size_t>(solved.size()));
  std::transform(solved.begin(), solved.end(), heights.begin(),
                 [](double z) { return static_cast<float>(z); });
  return heights;
}

}  // namespace relievo
