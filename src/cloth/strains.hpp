#pragma once
#include <array>
#include <span>
#include <vector>

#include "cloth/cloth.hpp"

namespace washtub {

/// Membrane strains of a deformed sheet, Eq. (12), with their signs: positive where it is
/// stretched.
struct Strains {
  /// Of the edges along r and along s, (1 - 1/|X_s|^2)/2; each by the place (i, j) of its first
  /// node, i going first.
  std::array<std::vector<double>, 2> along;
  /// e_sr of the quads, likewise; none in 2-D.
  std::vector<double> shear;

  std::size_t edges() const { return along[0].size() + along[1].size(); }
};

template <int D>
void find_strains(const Sheet<D>& sheet, std::span<const Vec<D>> X, Strains& out);

/// Strains of all pieces, low-passed in time: s' = (e - s)/T. Elastic waves, which a mean of
/// magnitudes would count as stress, cancel in it.
template <int D>
class SteadyStrains {
 public:
  /// `time`: T [s]; 0: as they are.
  SteadyStrains(const Cloth<D>& cloth, double time);

  /// The cloth has come to where it is in a step dt [s].
  void add(const Cloth<D>& cloth, double dt);
  const Strains& of_piece(int piece) const { return pieces_[static_cast<std::size_t>(piece)]; }
  void state(Archive& archive);

 private:
  double time_;
  std::vector<Strains> pieces_;
  Strains now_;
};

}  // namespace washtub
