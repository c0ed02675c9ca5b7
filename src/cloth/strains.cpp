#include "cloth/strains.hpp"

#include <cmath>

namespace washtub {
namespace {

/// |X_r . X_s| / (2 |X_r| |X_s|), signed, of the quad (i, j).
double shear(const Sheet<3>& sheet, std::span<const Vec<3>> X, int i, int j) {
  const Vec<3> a = sheet.place(X, i, j), b = sheet.place(X, i + 1, j);
  const Vec<3> c = sheet.place(X, i, j + 1), d = sheet.place(X, i + 1, j + 1);
  const auto [dr, ds] = sheet.spacing;
  const Vec<3> xr = (b - a + d - c) / (2 * dr), xs = (c - a + d - b) / (2 * ds);
  const double lr = ((b - a).norm() + (d - c).norm()) / (2 * dr);
  const double ls = ((c - a).norm() + (d - b).norm()) / (2 * ds);
  return 0.5 * xr.dot(xs) / (lr * ls);
}

void low_pass(const std::vector<double>& now, double share, std::vector<double>& steady) {
  for (std::size_t i = 0; i < now.size(); ++i) steady[i] += share * (now[i] - steady[i]);
}

}  // namespace

template <int D>
void find_strains(const Sheet<D>& sheet, std::span<const Vec<D>> X, Strains& out) {
  for (auto& along : out.along) along.clear();
  out.shear.clear();
  const auto edge = [&](int axis, int i, int j) {
    const Vec<D> way = sheet.place(X, i + (axis == 0), j + (axis == 1)) - sheet.place(X, i, j);
    const double ds = sheet.spacing[static_cast<std::size_t>(axis)];
    out.along[static_cast<std::size_t>(axis)].push_back(0.5 * (1 - ds * ds / way.squaredNorm()));
  };
  for (int j = 0; j < sheet.extent[1]; ++j)
    for (int i = 0; i < sheet.extent[0]; ++i) {
      const bool r = D == 3 && i < sheet.intervals(0), s = j < sheet.intervals(1);
      if (r) edge(0, i, j);
      if (s) edge(1, i, j);
      if constexpr (D == 3)
        if (r && s) out.shear.push_back(shear(sheet, X, i, j));
    }
}

template <int D>
SteadyStrains<D>::SteadyStrains(const Cloth<D>& cloth, double time)
    : time_(time), pieces_(static_cast<std::size_t>(cloth.pieces())) {
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p)
      find_strains(g.sheet, cloth.piece(g, p),
                   pieces_[static_cast<std::size_t>(g.first_piece + p)]);
}

template <int D>
void SteadyStrains<D>::add(const Cloth<D>& cloth, double dt) {
  const double share = time_ > 0 ? 1 - std::exp(-dt / time_) : 1;
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      find_strains(g.sheet, cloth.piece(g, p), now_);
      Strains& steady = pieces_[static_cast<std::size_t>(g.first_piece + p)];
      for (std::size_t axis = 0; axis < 2; ++axis)
        low_pass(now_.along[axis], share, steady.along[axis]);
      low_pass(now_.shear, share, steady.shear);
    }
}

template <int D>
void SteadyStrains<D>::state(Archive& archive) {
  std::vector<double> all;
  const auto for_all = [&](const auto& visit) {
    for (Strains& piece : pieces_)
      for (auto* list : {&piece.along[0], &piece.along[1], &piece.shear})
        for (double& e : *list) visit(e);
  };
  for_all([&](double& e) { all.push_back(e); });
  archive.same_length("strains", all);
  auto next = all.begin();
  for_all([&](double& e) { e = *next++; });
}

template void find_strains(const Sheet<2>&, std::span<const Vec<2>>, Strains&);
template void find_strains(const Sheet<3>&, std::span<const Vec<3>>, Strains&);
template class SteadyStrains<2>;
template class SteadyStrains<3>;

}  // namespace washtub
