// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/light_rows.h"

#include <algorithm>

#include "core/depth/colours/colours.h"

namespace relievo {

template <std::size_t Size>
LightOfRows<Size>::LightOfRows(const Transfer& transfer, bool finest) : transfer_(&transfer) {
  constexpr float kNextToNothing = 1.0F / 4096;
  for (std::size_t i = 0; i < light_.size(); ++i) {
    light_[i] = transfer.light[i];
    weights_[i] = static_cast<float>(i) / 255;
  }
  if (finest) weights_[kBetweenAlpha] = kNextToNothing;
}

template <std::size_t Size>
void LightOfRows<Size>::split(const Pixel* pixels, std::size_t cols, float* planes) const {
  for (std::size_t i = 0; i < cols; ++i) {
    const float weight = weights_[pixels[i][Size - 1]];
    for (std::size_t k = 0; k + 1 < Size; ++k) {
      planes[k * cols + i] = weight * light_[pixels[i][k]];
    }
    planes[(Size - 1) * cols + i] = weight;
  }
}

template <std::size_t Size>
void LightOfRows<Size>::join(const std::array<const float*, Size>& planes, std::size_t cols,
                             Pixel* pixels) const {
  const float* const share = planes[Size - 1];
  for (std::size_t i = 0; i < cols; ++i) {
    pixels[i] = {};
    if (!(share[i] > 0)) continue;
    for (std::size_t k = 0; k + 1 < Size; ++k) {
      pixels[i][k] = transfer_->storedOf(planes[k][i] / share[i]);
    }
    const float alpha = std::clamp(255 * share[i] + 0.5F, 1.0F, 255.0F);
    pixels[i][Size - 1] = static_cast<std::uint8_t>(alpha);
  }
}

template class LightOfRows<4>;
template class LightOfRows<2>;

}  // namespace relievo
