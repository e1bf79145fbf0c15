#include "core/rbf/dense.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "core/base/parallel.h"
#include "core/rbf/dense_steps.h"

namespace seesaw::dense {

namespace {

constexpr Index strip = Symmetric::strip;
// Panels so narrow that they stay in the second-level cache until all that is to be done with them is done.
constexpr Index panel_width = 32;
// Of such a panel so many rows that they stay in the first-level cache.
constexpr Index chunk_rows = 128;

Block block(Symmetric& a, Index i, Index j, Index rows, Index columns) {
  return {a.at(i, j), rows, columns, a.stride(j)};
}
ConstBlock block(const Symmetric& a, Index i, Index j, Index rows, Index columns) {
  return {a.at(i, j), rows, columns, a.stride(j)};
}
ConstBlock rows_of(const Eigen::MatrixXd& m, Index i, Index rows) {
  return {m.data() + i, rows, m.cols(), m.rows()};
}

// Calls work(j, w) for panels of columns j .. j + w - 1 from `begin` up to `end`, at multiples of `width`.
template <class Work>
void for_panels(Index begin, Index end, Index width, const Work& work) {
  for (Index j = begin; j < end;) {
    const Index w = std::min((j / width + 1) * width, end) - j;
    work(j, w);
    j += w;
  }
}

// Asks a listener, who is to hear of it in the thread that waits for the work, whether the work of all
// threads shall go on.
class Watch {
 public:
  explicit Watch(const Progress& progress) : progress_(progress) {}

  /// To be asked before every piece of work, which is left undone where it says so.
  bool stopped() {
    if (!stopped_ && progress_ && std::this_thread::get_id() == listener_ && !progress_(fraction_))
      stopped_ = true;
    return stopped_;
  }
  /// From the thread that waits.
  void reached(double fraction) {
    fraction_ = fraction;
    if (stopped()) throw Cancelled();
  }

 private:
  const Progress& progress_;
  std::thread::id listener_ = std::this_thread::get_id();
  double fraction_ = 0.0;
  std::atomic<bool> stopped_ = false;
};

// The sum of what every strip has to add: work(begin, count) returns rows begin .. n - 1. In parallel, added
// up in one order.
template <class Work>
Eigen::MatrixXd sum_of_strips(Index n, Index columns, const Work& work) {
  const Index strips = (n + strip - 1) / strip;
  std::vector<Eigen::MatrixXd> parts(static_cast<std::size_t>(strips));
  parallel_blocks(strips, 1, [&](Index begin, Index end) {
    for (Index t = begin; t < end; ++t)
      parts[static_cast<std::size_t>(t)] = work(t * strip, std::min(strip, n - t * strip));
  });
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, columns);
  for (const Eigen::MatrixXd& part : parts) sum.bottomRows(part.rows()) += part;
  return sum;
}

// Adds the absolute values in columns j .. j + w - 1 and rows i .. i + rows - 1, on and below the diagonal,
// and their mirror images to the column sums of the block that begins at `first`; sums[0] is that of column
// j.
void add_column_sums(Symmetric& a, Index first, Index j, Index w, Index i, Index rows,
                     Eigen::Ref<Eigen::MatrixXd> sums) {
  for (Index c = std::max(j, first); c < j + w; ++c) {
    const Index from = std::max(i, c), count = i + rows - from, mirrored = from == c ? count - 1 : count;
    const auto column = a.column_from(from, c).head(count);
    sums(c - j, 0) += column.lpNorm<1>();
    sums.col(0).segment(i + rows - mirrored - j, mirrored) += column.tail(mirrored).cwiseAbs();
  }
}

}  // namespace

Eigen::MatrixXd fill_and_multiply(Symmetric& a, const FillColumns& fill, const Eigen::MatrixXd& x,
                                  const Progress& progress) {
  const OneThread alone;
  Watch watch(progress);
  const Index n = a.size(), m = x.cols();
  // A panel, its diagonal block and what lies below, counts as itself and as its mirror image.
  const Eigen::MatrixXd product = sum_of_strips(n, m, [&](Index begin, Index count) {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(n - begin, m);
    for_panels(begin, begin + count, panel_width, [&](Index j, Index w) {
      if (watch.stopped()) return;
      fill(j, w);
      const ConstBlock diagonal = block(a, j, j, w, w);
      const auto x_at = [&](Index i, Index k) { return x.col(k).data() + i; };
      const auto y_at = [&](Index i, Index k) { return sums.col(k).data() + (i - begin); };
      for (Index k = 0; k < m; ++k) add_symmetric(diagonal, x_at(j, k), y_at(j, k));
      for_panels(j + w, n, chunk_rows, [&](Index i, Index rows) {
        const ConstBlock below = block(a, i, j, rows, w);
        for (Index k = 0; k < m; ++k) {
          add_product(1.0, below, x_at(j, k), y_at(i, k));
          add_transposed(1.0, below, x_at(i, k), y_at(j, k));
        }
      });
    });
    return sums;
  });
  watch.reached(1.0);
  return product;
}

double subtract_products(Symmetric& a, const Eigen::MatrixXd& u, const Eigen::MatrixXd& v, Index first,
                         const Progress& progress) {
  const OneThread alone;
  Watch watch(progress);
  const Index n = a.size();
  // U V' + V U' = [U V] [V U]', in one pass over the matrix.
  Eigen::MatrixXd both(n, 2 * u.cols()), other(n, 2 * u.cols());
  both << u, v;
  other << v, u;
  const Eigen::MatrixXd sums = sum_of_strips(n, 1, [&](Index begin, Index count) {
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(n - begin, 1);
    for_panels(begin, begin + count, panel_width, [&](Index j, Index w) {
      if (watch.stopped()) return;
      subtract_both(block(a, j, j, w, w), rows_of(u, j, w), rows_of(v, j, w));
      add_column_sums(a, first, j, w, j, w, part.bottomRows(n - j));
      for_panels(j + w, n, chunk_rows, [&](Index i, Index rows) {
        subtract_product(block(a, i, j, rows, w), rows_of(both, i, rows), rows_of(other, j, w));
        add_column_sums(a, first, j, w, i, rows, part.bottomRows(n - j));
      });
    });
    return part;
  });
  watch.reached(1.0);
  return sums.maxCoeff();
}

namespace {

// The part of the matrix in columns `from` .. `to` - 1, from their diagonal down, less panel panel': the
// panel is columns j .. j + w - 1, rows `from` .. n - 1. In tiles, in parallel.
void subtract_panel(Symmetric& a, Index j, Index w, Index from, Index to, Watch& watch) {
  // BLAS copies the sides of a tile before it multiplies them: tall tiles, but several for several cores.
  // (Measured on one core: with 768 rows a factorization takes 8 % longer at N = 3000, 12 % at 6000.)
  constexpr Index tile_rows = 3072;
  struct Tile {
    Index row, rows, column, columns;
  };
  std::vector<Tile> tiles;
  const Index n = a.size();
  for_panels(from, to, strip, [&](Index c, Index columns) {
    for (Index r = c; r < n; r += tile_rows) tiles.push_back({r, std::min(tile_rows, n - r), c, columns});
  });
  parallel_blocks(static_cast<Index>(tiles.size()), 1, [&](Index begin, Index end) {
    for (Index t = begin; t < end && !watch.stopped(); ++t) {
      auto [row, rows, column, columns] = tiles[static_cast<std::size_t>(t)];
      const ConstBlock right = block(a, column, j, columns, w);
      if (row == column) {
        subtract_square(block(a, row, column, columns, columns), right);
        row += columns, rows -= columns;
      }
      if (rows > 0) subtract_product(block(a, row, column, rows, columns), block(a, row, j, rows, w), right);
    }
  });
}

}  // namespace

// Right-looking at two scales. A narrow panel is a small factorization and a triangular solve, and brings the
// rest of its wide panel up to date; a finished wide panel does so for all that lies to the right of it,
// which is nearly all the work and reads and writes the matrix once a wide panel. (Measured with AVX-512 on
// one core, at N = 3000 and 6000: 0.79 and 0.89 of the time of OpenBLAS 0.3.21's dpotrf.)
bool cholesky(Symmetric& a, Index first, const Progress& progress) {
  const OneThread alone;
  Watch watch(progress);
  constexpr Index narrow = 32, wide = 384;
  static_assert(strip % wide == 0 && wide % narrow == 0);
  const Index n = a.size();
  bool definite = true;
  for_panels(first, n, wide, [&](Index from, Index width) {
    for_panels(from, from + width, narrow, [&](Index j, Index w) {
      definite = definite && factor(block(a, j, j, w, w));
      if (!definite) return;
      const ConstBlock diagonal = block(a, j, j, w, w);
      parallel_blocks(n - j - w, 256, [&](Index begin, Index end) {
        divide_right(block(a, j + w + begin, j, end - begin, w), diagonal);
      });
      subtract_panel(a, j, w, j + w, from + width, watch);
    });
    if (!definite) return;
    subtract_panel(a, from, width, from + width, n, watch);
    const double left = static_cast<double>(n - from - width) / static_cast<double>(n - first);
    watch.reached(1.0 - left * left * left);
  });
  return definite;
}

// A few columns wait for the matrix to come from memory, and go through a panel one by one; many wait for the
// processor, and go through together. (One column takes as long either way; 80 together take half as long.)
void solve(const Symmetric& a, Index first, Eigen::Ref<Eigen::MatrixXd> x, const Progress& progress) {
  const OneThread alone;
  Watch watch(progress);
  constexpr Index many = 3;
  const Index n = a.size(), m = x.cols();
  std::vector<std::pair<Index, Index>> panels;
  for_panels(first, n, panel_width, [&](Index j, Index w) { panels.emplace_back(j, w); });
  const auto rows_from = [&](Index i, Index count) -> Block {
    return {x.data() + (i - first), count, m, x.outerStride()};
  };
  // The first half of the panels have three quarters of the numbers, and go first.
  const auto reached = [&](Index j, bool forward) {
    const double left = static_cast<double>(n - j) / static_cast<double>(n - first);
    watch.reached(0.5 * (forward ? 1.0 - left * left : 1.0 + left * left));
  };
  for (const auto& [j, w] : panels) {
    reached(j, true);
    const ConstBlock diagonal = block(a, j, j, w, w);
    const Index rest = n - j - w;
    if (m < many) {
      for (Index k = 0; k < m; ++k) {
        double* y = x.col(k).data() + (j - first);
        divide(diagonal, y);
        if (rest > 0) add_product(-1.0, block(a, j + w, j, rest, w), y, y + w);
      }
    } else {
      divide(diagonal, rows_from(j, w));
      if (rest > 0) subtract_times(rows_from(j + w, rest), block(a, j + w, j, rest, w), rows_from(j, w));
    }
  }
  for (auto panel = panels.rbegin(); panel != panels.rend(); ++panel) {
    const auto& [j, w] = *panel;
    reached(j, false);
    const ConstBlock diagonal = block(a, j, j, w, w);
    const Index rest = n - j - w;
    if (m < many) {
      for (Index k = 0; k < m; ++k) {
        double* y = x.col(k).data() + (j - first);
        if (rest > 0) add_transposed(-1.0, block(a, j + w, j, rest, w), y + w, y);
        divide_transposed(diagonal, y);
      }
    } else {
      if (rest > 0)
        subtract_transposed_times(rows_from(j, w), block(a, j + w, j, rest, w), rows_from(j + w, rest));
      divide_transposed(diagonal, rows_from(j, w));
    }
  }
}

}  // namespace seesaw::dense
