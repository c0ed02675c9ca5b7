#pragma once
#include <span>

namespace washtub {

/// offset + exp(-decay t) (cosine cos 2 pi frequency t + sine sin 2 pi frequency t), with t from
/// the first sample.
struct Oscillation {
  double frequency = 0;  ///< [1/s]
  double decay = 0;      ///< [1/s], negative where the oscillation grows
  double offset = 0, cosine = 0, sine = 0;
};

/// The least-squares fit to samples at ascending times, evenly spaced or not. Zero crossings about
/// the mean give a first frequency; a search around it, with the linear coefficients solved for,
/// gives the start of a Levenberg-Marquardt iteration for all five.
/// @throws InputError where the samples do not show one and a half oscillations
Oscillation fit_oscillation(std::span<const double> times, std::span<const double> values);

}  // namespace washtub
