#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace washtub {

// How numbers become small integers; viewer/src/model/bundle.ts has the inverses. What is no
// finite number becomes 0.

/// q stands for lower + q (upper - lower)/65535; `value` within the span.
std::uint16_t quantise_linear(double value, double lower, double upper);

/// q stands for largest (q/65535)^2; `value` from 0 to largest.
std::uint16_t quantise_root(double value, double largest);

/// q stands for sign(q) largest (q/127)^2; |value| up to largest.
std::int8_t quantise_companded(double value, double largest);

/// The largest finite |value|, 0 where there is none.
double largest_magnitude(std::span<const float> values);

}  // namespace washtub
