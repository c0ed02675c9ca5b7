#include "grid/halo.hpp"

#include <gtest/gtest.h>

#include "grid/meshes.hpp"

namespace washtub {
namespace {

using testing::any_cut;
using testing::for_cells;
using testing::unit_mesh;

/// A number unique to each cell of the mesh; -1 beyond sides that do not repeat.
template <int D>
double value_at(const Mesh<D>& mesh, Index<D> c) {
  double value = 0;
  for (int d = 0; d < D; ++d) {
    const int n = mesh.cells[d];
    if ((c[d] < 0 || c[d] >= n) && !mesh.periodic[d]) return -1;
    value = 100 * value + (c[d] + n) % n;
  }
  return value;
}

/// What stands for that number in field `array` of values T, bytes included.
template <class T>
T stored(double value, int array) {
  if constexpr (sizeof(T) == 1)
    return value < 0 ? T{255} : static_cast<T>((static_cast<long>(value) + 7 * array) % 251);
  else
    return static_cast<T>(value < 0 ? -1 : value + 0.25 * array);
}

/// Fills `arrays` fields, each shifted by its number, exchanges and compares every ghost.
template <int D, class T>
void check_exchange(const Mesh<D>& mesh, int arrays) {
  const Grid<D> grid(mesh, Parallel(), any_cut<D>());
  const auto& block = grid.block();
  const auto expected = [&](Index<D> c, int a) {
    for (int d = 0; d < D; ++d) c[d] += block.offset[d];
    return stored<T>(value_at<D>(mesh, c), a);
  };
  const auto inside = [&](const Index<D>& c) {
    for (int d = 0; d < D; ++d)
      if (c[d] < 0 || c[d] >= block.count[d]) return false;
    return true;
  };
  std::vector<Storage<T>> fields;
  std::vector<T*> pointers;
  for (int a = 0; a < arrays; ++a) {
    fields.emplace_back(static_cast<std::size_t>(block.size));
    for_cells(block, 1, [&](const Index<D>& c) {
      fields.back()[block.at(c)] = inside(c) ? expected(c, a) : stored<T>(-1, a);
    });
    pointers.push_back(fields.back().data());
  }
  grid.halo().exchange(std::span<T* const>(pointers));
  int wrong = 0;
  for (int a = 0; a < arrays; ++a)
    for_cells(block, 1, [&](const Index<D>& c) {
      const auto at = static_cast<std::size_t>(a);
      wrong += fields[at][block.at(c)] != expected(c, a);
    });
  EXPECT_EQ(wrong, 0) << D << "-D, " << mesh.cells[0] << " cells along x, periodic "
                      << mesh.periodic[0] << mesh.periodic[1] << mesh.periodic[D - 1];
}

/// Widths on and off the vector length, since rows are padded to it.
template <class T>
void check_all_boxes() {
  for (const int width : {10, 16, 32})
    for (const bool x : {false, true})
      for (const bool y : {false, true}) {
        check_exchange<2, T>(unit_mesh<2>({width, 9}, {x, y}), 1);
        for (const bool z : {false, true}) {
          check_exchange<3, T>(unit_mesh<3>({width, 6, 7}, {x, y, z}), 1);
          check_exchange<3, T>(unit_mesh<3>({width, 12, 4}, {x, y, z}), 3);
        }
      }
}

TEST(Halo, FillsFacesEdgesAndCornersInDoublePrecision) { check_all_boxes<double>(); }
TEST(Halo, FillsFacesEdgesAndCornersInSinglePrecision) { check_all_boxes<float>(); }
TEST(Halo, FillsFacesEdgesAndCornersOfBytes) { check_all_boxes<std::uint8_t>(); }

TEST(Halo, TakesAnyNumberOfArrays) {
  for (const int arrays : {0, 4, 5, 9}) {
    check_exchange<2, double>(unit_mesh<2>({16, 9}, {true, true}), arrays);
    check_exchange<3, float>(unit_mesh<3>({16, 6, 7}, {false, true, false}), arrays);
  }
}

TEST(Halo, WrapsOneRowOnlyWhereTheBoxRepeats) {
  for (const bool periodic : {false, true}) {
    const Grid<2> grid(unit_mesh<2>({16, 8}, {periodic, false}), Parallel(), any_cut<2>());
    Field f = grid.make_field();
    double* row = f.data() + grid.block().row(0, 1);
    row[0] = 3;
    row[15] = 5;
    grid.halo().wrap_row(row);
    EXPECT_EQ(row[-1], periodic ? 5 : 0);
    EXPECT_EQ(row[16], periodic ? 3 : 0);
  }
}

}  // namespace
}  // namespace washtub
