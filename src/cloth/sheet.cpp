#include "cloth/sheet.hpp"

#include <map>
#include <set>

#include "cloth/assembly.hpp"
#include "cloth/elastic.hpp"

namespace washtub {

template <int D>
std::vector<std::pair<int, int>> couplings(const Sheet<D>& sheet) {
  std::set<std::pair<int, int>> pairs;
  const auto couple = [&](const std::set<int>& nodes) {
    for (const int x : nodes)
      for (const int y : nodes)
        if (y <= x) pairs.emplace(x, y);
  };
  const auto couple_legs = [&](const auto& strains) {
    for (const auto& e : strains) {
      std::set<int> nodes;
      for (const auto& leg : e.leg) nodes.insert(leg.begin(), leg.end());
      couple(nodes);
    }
  };
  const auto couple_all = [&](const auto& elements) {
    couple_legs(elements.edges);
    couple_legs(elements.shears);
    couple_legs(elements.dilations);
    for (const auto& e : elements.bends) couple({e.node.begin(), e.node.begin() + e.count});
  };
  couple_all(sheet.inner);
  couple_all(sheet.seam);
  return {pairs.begin(), pairs.end()};
}

template <int D>
double Sheet<D>::smallest_spacing() const {
  return D == 2 ? spacing[1] : std::min(spacing[0], spacing[1]);
}

template <int D>
double Sheet<D>::energy(std::span<const Vec<D>> X) const {
  double W = 0;
  elastic::add_energy<D, 1>(*this, X.front().data(), &W);
  return W;
}

template <int D>
void Sheet<D>::force(std::span<const Vec<D>> X, std::span<Vec<D>> F) const {
  std::fill(F.begin(), F.end(), Vec<D>::Zero());
  elastic::add_force<D, 1>(*this, X.front().data(), F.front().data());
}

template <int D>
double Sheet<D>::largest_strain(std::span<const Vec<D>> X) const {
  double largest = 0;
  elastic::largest_strain<D, 1>(*this, X.front().data(), &largest);
  return largest;
}

template <int D>
Eigen::SparseMatrix<double> Sheet<D>::hessian(std::span<const Vec<D>> X, double floor) const {
  const auto pairs = couplings(*this);
  std::map<std::pair<int, int>, int> index;
  for (const auto& pair : pairs) index.emplace(pair, static_cast<int>(index.size()));
  const auto place = [&](int x, int y) {
    return Place{index.at({std::max(x, y), std::min(x, y)}), x < y};
  };
  std::vector<double> blocks(pairs.size() * D * D);
  const Assembly<D> assembly(*this, static_cast<int>(pairs.size()), place);
  assembly.template assemble<1>(X.front().data(), &floor, blocks.data());

  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const auto [x, y] = pairs[n];
    for (int r = 0; r < D; ++r) {
      for (int c = 0; c < D; ++c) {
        const double value = blocks[(n * D + r) * D + c];
        entries.emplace_back(D * x + r, D * y + c, value);
        if (x != y) entries.emplace_back(D * y + c, D * x + r, value);
      }
    }
  }
  Eigen::SparseMatrix<double> H(D * nodes(), D * nodes());
  H.setFromTriplets(entries.begin(), entries.end());
  return H;
}

template struct Sheet<2>;
template struct Sheet<3>;
template std::vector<std::pair<int, int>> couplings(const Sheet<2>&);
template std::vector<std::pair<int, int>> couplings(const Sheet<3>&);

}  // namespace washtub
