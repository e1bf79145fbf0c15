#include "core/rbf/dense.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "core/base/parallel.h"

#if defined(SEESAW_HAS_LAPACK)
#include <cblas.h>
#include <lapacke.h>
#else
#include <Eigen/Cholesky>
#endif

namespace seesaw::dense {

Symmetric::Symmetric(Index n) : n_(n) {
  constexpr std::size_t page = std::size_t{1} << 21;
  const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(std::max<Index>(n * n, 1));
  const std::size_t rounded = (bytes + page - 1) / page * page;
  const bool large = bytes >= page;
  void* memory = large ? std::aligned_alloc(page, rounded) : std::malloc(bytes);
  if (!memory) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
  if (large) ::madvise(memory, rounded, MADV_HUGEPAGE);  // a wish: where it is refused, small pages do
#endif
  memory_.reset(static_cast<double*>(memory));
}

void Symmetric::Free::operator()(double* memory) const { std::free(memory); }

namespace {

constexpr Index strip = 256;  // columns or rows in a piece

// Calls work(begin, count) for 0 .. n - 1 cut into pieces, in parallel: the same pieces whatever the threads.
template <class Work>
void for_pieces(Index n, const Work& work) {
  parallel_blocks((n + strip - 1) / strip, 1, [&](Index begin, Index end) {
    for (Index piece = begin; piece < end; ++piece) work(piece * strip, std::min(strip, n - piece * strip));
  });
}

// The sum of what every piece has to add: work(begin, count) returns rows begin .. n - 1. Added up in one
// order.
template <class Work>
Eigen::MatrixXd sum_of_pieces(Index n, Index columns, const Work& work) {
  std::vector<Eigen::MatrixXd> parts(static_cast<std::size_t>((n + strip - 1) / strip));
  for_pieces(n, [&](Index begin, Index count) {
    parts[static_cast<std::size_t>(begin / strip)] = work(begin, count);
  });
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, columns);
  for (const Eigen::MatrixXd& part : parts) sum.bottomRows(part.rows()) += part;
  return sum;
}

// Adds the absolute values of columns j .. j + w - 1, and of the rows that mirror them, to the column sums of
// the block that begins at `first`.
void add_column_sums(const Symmetric& a, Index first, Index j, Index w, Eigen::Ref<Eigen::MatrixXd> sums) {
  const Index n = a.size();
  for (Index c = std::max(j, first); c < j + w; ++c) {
    const Eigen::Map<const Values> column(a.data() + c * (n + 1), n - c);
    sums(c - j, 0) += column.lpNorm<1>();
    sums.col(0).tail(n - c - 1) += column.tail(n - c - 1).cwiseAbs();
  }
}

}  // namespace

#if defined(SEESAW_HAS_LAPACK)

extern "C" {  // where BLAS is OpenBLAS; other libraries may lack them
void openblas_set_num_threads(int) __attribute__((weak));
int openblas_get_num_threads(void) __attribute__((weak));
}

namespace {

int as_int(Index n) { return static_cast<int>(n); }

// While one lives, BLAS works in the calling thread alone. How it cuts work for several threads decides the
// last digits of its results, and ours are to be the same whatever the number of threads; so the cutting is
// ours.
class OneThread {
 public:
  OneThread() {
    const std::scoped_lock lock(mutex_);
    if (users_++ == 0 && openblas_set_num_threads && openblas_get_num_threads) {
      before_ = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
  }
  ~OneThread() {
    const std::scoped_lock lock(mutex_);
    if (--users_ == 0 && openblas_set_num_threads && openblas_get_num_threads)
      openblas_set_num_threads(before_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  static inline std::mutex mutex_;
  static inline int users_ = 0, before_ = 1;
};

}  // namespace

// Both of the following go through a strip in panels so narrow that a panel stays in the second-level cache
// until all that is to be done with it is done: the matrix comes from memory once.
constexpr Index panel_width = 32;

Eigen::MatrixXd fill_and_multiply(Symmetric& a, const FillColumns& fill, const Eigen::MatrixXd& x) {
  const OneThread alone;
  const Index n = a.size(), m = x.cols();
  const int stride = as_int(n);
  // A panel, its diagonal block and what lies below, counts as itself and as its mirror image.
  return sum_of_pieces(n, m, [&](Index strip_begin, Index strip_width) {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(n - strip_begin, m);
    for (Index c = 0; c < strip_width; c += panel_width) {
      const Index j = strip_begin + c, w = std::min(panel_width, strip_width - c), below = n - j - w;
      fill(j, w);
      const double* corner = a.data() + j * (n + 1);
      for (Index k = 0; k < m; ++k) {
        const double *x_here = x.col(k).data() + j, *x_below = x_here + w;
        double *y_here = sums.col(k).data() + c, *y_below = y_here + w;
        cblas_dsymv(CblasColMajor, CblasLower, as_int(w), 1.0, corner, stride, x_here, 1, 1.0, y_here, 1);
        if (below == 0) continue;
        cblas_dgemv(CblasColMajor, CblasNoTrans, as_int(below), as_int(w), 1.0, corner + w, stride, x_here, 1,
                    1.0, y_below, 1);
        cblas_dgemv(CblasColMajor, CblasTrans, as_int(below), as_int(w), 1.0, corner + w, stride, x_below, 1,
                    1.0, y_here, 1);
      }
    }
    return sums;
  });
}

double subtract_products(Symmetric& a, const Eigen::MatrixXd& u, const Eigen::MatrixXd& v, Index first) {
  const OneThread alone;
  const Index n = a.size();
  const int stride = as_int(n), width = as_int(u.cols());
  const Eigen::MatrixXd sums = sum_of_pieces(n, 1, [&](Index strip_begin, Index strip_width) {
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(n - strip_begin, 1);
    for (Index c = 0; c < strip_width; c += panel_width) {
      const Index j = strip_begin + c, w = std::min(panel_width, strip_width - c), below = n - j - w;
      double* corner = a.data() + j * (n + 1);
      cblas_dsyr2k(CblasColMajor, CblasLower, CblasNoTrans, as_int(w), width, -1.0, u.data() + j, stride,
                   v.data() + j, stride, 1.0, corner, stride);
      if (below > 0)
        for (const auto& [left, right] : {std::pair{&u, &v}, std::pair{&v, &u}})
          cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, as_int(below), as_int(w), width, -1.0,
                      left->data() + j + w, stride, right->data() + j, stride, 1.0, corner + w, stride);
      add_column_sums(a, first, j, w, part.bottomRows(n - j));
    }
    return part;
  });
  return sums.maxCoeff();
}

namespace {

// rest := rest - panel panel', of whose `columns` first columns the lower triangle and what lies below it
// count. `rest` is below x below with panel's leading dimension `stride`; panel is below x width.
void subtract_square(double* rest, const double* panel, Index stride, Index below, Index columns,
                     Index width) {
  for_pieces(columns, [&](Index k, Index count) {
    double* corner = rest + k * (stride + 1);
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, as_int(count), as_int(width), -1.0, panel + k,
                as_int(stride), 1.0, corner, as_int(stride));
    const Index rows = below - k - count;
    if (rows > 0)
      cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, as_int(rows), as_int(count), as_int(width), -1.0,
                  panel + k + count, as_int(stride), panel + k, as_int(stride), 1.0, corner + count,
                  as_int(stride));
  });
}

}  // namespace

// Right-looking at two scales. A narrow panel is a small factorization and a triangular solve, and brings the
// rest of its wide panel up to date; a finished wide panel does so for all that lies to the right of it,
// which is nearly all the work and reads and writes the matrix once a wide panel. (Measured at N = 3000 on
// AVX-512: 5 % faster than narrow panels alone, 1.06 times OpenBLAS 0.3.21's dpotrf; on AVX2 all three are
// equal.)
bool cholesky(Symmetric& a, Index first) {
  const OneThread alone;
  constexpr Index narrow = 64, wide = 192;
  const Index n = a.size();
  const int stride = as_int(n);
  for (Index from = first; from < n; from += wide) {
    const Index to = std::min(from + wide, n);
    for (Index j = from; j < to; j += narrow) {
      const Index w = std::min(narrow, to - j), below = n - j - w;
      double* diagonal = a.data() + j * (n + 1);
      if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', as_int(w), diagonal, stride) != 0) return false;
      double* panel = diagonal + w;  // below x w
      for_pieces(below, [&](Index i, Index rows) {
        cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, as_int(rows), as_int(w),
                    1.0, diagonal, stride, panel + i, stride);
      });
      if (j + w < to) subtract_square(panel + w * n, panel, n, below, to - j - w, w);
    }
    if (to < n)
      subtract_square(a.data() + to * (n + 1), a.data() + from * n + to, n, n - to, n - to, to - from);
  }
  return true;
}

// Panels that stay in the second-level cache while each column of x meets them.
void solve(const Symmetric& a, Index first, Eigen::Ref<Eigen::MatrixXd> x) {
  const OneThread alone;
  constexpr Index width = 32;
  const Index n = a.size(), rows = n - first;
  const int stride = as_int(n);
  for (Index j = 0; j < rows; j += width) {
    const Index w = std::min(width, rows - j), below = rows - j - w;
    const double* diagonal = a.data() + (first + j) * (n + 1);
    for (Index k = 0; k < x.cols(); ++k) {
      double* y = x.col(k).data() + j;
      cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, as_int(w), diagonal, stride, y, 1);
      if (below > 0)
        cblas_dgemv(CblasColMajor, CblasNoTrans, as_int(below), as_int(w), -1.0, diagonal + w, stride, y, 1,
                    1.0, y + w, 1);
    }
  }
  for (Index j = (rows - 1) / width * width; j >= 0; j -= width) {
    const Index w = std::min(width, rows - j), below = rows - j - w;
    const double* diagonal = a.data() + (first + j) * (n + 1);
    for (Index k = 0; k < x.cols(); ++k) {
      double* y = x.col(k).data() + j;
      if (below > 0)
        cblas_dgemv(CblasColMajor, CblasTrans, as_int(below), as_int(w), -1.0, diagonal + w, stride, y + w, 1,
                    1.0, y, 1);
      cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, as_int(w), diagonal, stride, y, 1);
    }
  }
}

const char* name() { return "BLAS"; }

#else

namespace {

using Map = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<> >;
using ConstMap = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<> >;

Map block(Symmetric& a, Index first) {
  const Index n = a.size() - first;
  return Map(a.data() + first * (a.size() + 1), n, n, Eigen::OuterStride<>(a.size()));
}
ConstMap block(const Symmetric& a, Index first) {
  const Index n = a.size() - first;
  return ConstMap(a.data() + first * (a.size() + 1), n, n, Eigen::OuterStride<>(a.size()));
}

}  // namespace

Eigen::MatrixXd fill_and_multiply(Symmetric& a, const FillColumns& fill, const Eigen::MatrixXd& x) {
  for_pieces(a.size(), fill);
  return block(a, 0).selfadjointView<Eigen::Lower>() * x;
}

double subtract_products(Symmetric& a, const Eigen::MatrixXd& u, const Eigen::MatrixXd& v, Index first) {
  for (Index k = 0; k < u.cols(); ++k)
    block(a, 0).selfadjointView<Eigen::Lower>().rankUpdate(u.col(k), v.col(k), -1.0);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(a.size(), 1);
  add_column_sums(a, first, 0, a.size(), sums);
  return sums.maxCoeff();
}

bool cholesky(Symmetric& a, Index first) {
  Map matrix = block(a, first);
  return Eigen::LLT<Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<> > >(matrix).info() == Eigen::Success;
}

void solve(const Symmetric& a, Index first, Eigen::Ref<Eigen::MatrixXd> x) {
  const ConstMap l = block(a, first);
  l.triangularView<Eigen::Lower>().solveInPlace(x);
  l.transpose().triangularView<Eigen::Upper>().solveInPlace(x);
}

const char* name() { return "Eigen"; }

#endif

}  // namespace seesaw::dense
