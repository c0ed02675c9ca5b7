#pragma once
#include <algorithm>

#include "grid/block.hpp"
#include "grid/halo.hpp"

namespace washtub {

/// Runs `stages` dependent passes over a block while its planes are still in cache.
/// Stage s at a row reads stage s-1 of the rows next to it. Along sides whose ghosts come from an
/// exchange, a shell of rows goes first, one exchange per stage; the inner rows then follow plane
/// by plane, each stage one plane behind the one before.
///
/// `stage(s, k, j0, j1)` works on the rows [j0, j1) of plane k; `exchange(s)` fills the ghosts
/// after stage s; `finish(k)` runs once per plane after the last stage of the planes k-1, k, k+1.
template <int D, class Stage, class Exchange, class Finish>
void wavefront(const Block<D>& block, const Halo<D>& halo, int stages, Stage&& stage,
               Exchange&& exchange, Finish&& finish) {
  const int rows = block.rows(), planes = block.planes();
  const bool below = halo.shared(D - 1, 0), above = halo.shared(D - 1, 1);
  const bool front = D == 3 && halo.shared(1, 0), back = D == 3 && halo.shared(1, 1);
  const bool shell = below || above || front || back;
  const bool thin =
      ((below || above) && planes < 2 * stages + 2) || ((front || back) && rows < 2 * stages + 2);

  const auto depth = [&](int s, bool side) { return side ? stages - s : 0; };
  if (shell) {
    for (int s = 0; s < stages; ++s) {
      const int lo = depth(s, front), hi = rows - depth(s, back);
      for (int k = 0; k < planes; ++k) {
        const bool whole = thin || k < depth(s, below) || k >= planes - depth(s, above);
        if (whole) {
          stage(s, k, 0, rows);
        } else {
          if (lo > 0) stage(s, k, 0, lo);
          if (hi < rows) stage(s, k, hi, rows);
        }
      }
      exchange(s);
    }
  }
  for (int t = 0; t <= planes + stages; ++t) {
    for (int s = 0; s < stages && !thin; ++s) {
      const int k = t - s;
      if (k >= depth(s, below) && k < planes - depth(s, above))
        stage(s, k, depth(s, front), rows - depth(s, back));
    }
    const int k = t - stages;
    if (k >= 0 && k < planes) finish(k);
  }
}

}  // namespace washtub
