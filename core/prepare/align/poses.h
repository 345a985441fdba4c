// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/prepare/recipe.h"

namespace relievo {

/// First `b`, then `a`.
constexpr Pose after(const Pose& a, const Pose& b) noexcept {
  Pose product;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t col = 0; col < 4; ++col) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += a.m[4 * row + k] * b.m[4 * k + col];
      product.m[4 * row + col] = sum;
    }
  }
  return product;
}

}  // namespace relievo
