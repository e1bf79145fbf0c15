#include "core/rbf/dense_steps.h"

#include <mutex>

#if defined(SEESAW_HAS_LAPACK)
#include <cblas.h>
#include <lapacke.h>
#else
#include <Eigen/Cholesky>
#endif

namespace seesaw::dense {

#if defined(SEESAW_HAS_LAPACK)

extern "C" {  // where BLAS is OpenBLAS; other libraries may lack them
void openblas_set_num_threads(int) __attribute__((weak));
int openblas_get_num_threads(void) __attribute__((weak));
}

namespace {

int as_int(Index n) { return static_cast<int>(n); }

std::mutex mutex;
int users = 0, threads_before = 1;

}  // namespace

OneThread::OneThread() {
  const std::scoped_lock lock(mutex);
  if (users++ == 0 && openblas_set_num_threads && openblas_get_num_threads) {
    threads_before = openblas_get_num_threads();
    openblas_set_num_threads(1);
  }
}
OneThread::~OneThread() {
  const std::scoped_lock lock(mutex);
  if (--users == 0 && openblas_set_num_threads && openblas_get_num_threads)
    openblas_set_num_threads(threads_before);
}

bool factor(const Block& a) {
  return LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', as_int(a.rows), a.data, as_int(a.stride)) == 0;
}
void divide_right(const Block& x, const ConstBlock& l) {
  cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, as_int(x.rows),
              as_int(x.columns), 1.0, l.data, as_int(l.stride), x.data, as_int(x.stride));
}
void divide(const ConstBlock& l, double* x) {
  cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, as_int(l.rows), l.data, as_int(l.stride),
              x, 1);
}
void divide_transposed(const ConstBlock& l, double* x) {
  cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, as_int(l.rows), l.data, as_int(l.stride),
              x, 1);
}
void add_symmetric(const ConstBlock& a, const double* x, double* y) {
  cblas_dsymv(CblasColMajor, CblasLower, as_int(a.rows), 1.0, a.data, as_int(a.stride), x, 1, 1.0, y, 1);
}
void subtract_square(const Block& a, const ConstBlock& u) {
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, as_int(a.rows), as_int(u.columns), -1.0, u.data,
              as_int(u.stride), 1.0, a.data, as_int(a.stride));
}
void subtract_both(const Block& a, const ConstBlock& u, const ConstBlock& v) {
  cblas_dsyr2k(CblasColMajor, CblasLower, CblasNoTrans, as_int(a.rows), as_int(u.columns), -1.0, u.data,
               as_int(u.stride), v.data, as_int(v.stride), 1.0, a.data, as_int(a.stride));
}
void subtract_product(const Block& a, const ConstBlock& u, const ConstBlock& v) {
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, as_int(a.rows), as_int(a.columns), as_int(u.columns),
              -1.0, u.data, as_int(u.stride), v.data, as_int(v.stride), 1.0, a.data, as_int(a.stride));
}
void add_product(double sign, const ConstBlock& a, const double* x, double* y) {
  cblas_dgemv(CblasColMajor, CblasNoTrans, as_int(a.rows), as_int(a.columns), sign, a.data, as_int(a.stride),
              x, 1, 1.0, y, 1);
}
void add_transposed(double sign, const ConstBlock& a, const double* x, double* y) {
  cblas_dgemv(CblasColMajor, CblasTrans, as_int(a.rows), as_int(a.columns), sign, a.data, as_int(a.stride), x,
              1, 1.0, y, 1);
}
void divide(const ConstBlock& l, const Block& x) {
  cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, as_int(x.rows),
              as_int(x.columns), 1.0, l.data, as_int(l.stride), x.data, as_int(x.stride));
}
void divide_transposed(const ConstBlock& l, const Block& x) {
  cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasTrans, CblasNonUnit, as_int(x.rows),
              as_int(x.columns), 1.0, l.data, as_int(l.stride), x.data, as_int(x.stride));
}
void subtract_times(const Block& y, const ConstBlock& a, const ConstBlock& x) {
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, as_int(y.rows), as_int(y.columns), as_int(a.columns),
              -1.0, a.data, as_int(a.stride), x.data, as_int(x.stride), 1.0, y.data, as_int(y.stride));
}
void subtract_transposed_times(const Block& y, const ConstBlock& a, const ConstBlock& x) {
  cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, as_int(y.rows), as_int(y.columns), as_int(a.rows),
              -1.0, a.data, as_int(a.stride), x.data, as_int(x.stride), 1.0, y.data, as_int(y.stride));
}

const char* name() { return "BLAS"; }

#else

namespace {

auto map(const Block& a) {
  return Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<> >(a.data, a.rows, a.columns,
                                                               Eigen::OuterStride<>(a.stride));
}
auto map(const ConstBlock& a) {
  return Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<> >(a.data, a.rows, a.columns,
                                                                     Eigen::OuterStride<>(a.stride));
}
auto map(double* x, Index n) { return Eigen::Map<Values>(x, n); }
auto map(const double* x, Index n) { return Eigen::Map<const Values>(x, n); }

}  // namespace

OneThread::OneThread() = default;
OneThread::~OneThread() = default;

bool factor(const Block& a) {
  auto matrix = map(a);
  return Eigen::LLT<Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<> > >(matrix).info() == Eigen::Success;
}
void divide_right(const Block& x, const ConstBlock& l) {
  map(l).transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(map(x));
}
void divide(const ConstBlock& l, double* x) {
  auto its = map(x, l.rows);
  map(l).triangularView<Eigen::Lower>().solveInPlace(its);
}
void divide_transposed(const ConstBlock& l, double* x) {
  auto its = map(x, l.rows);
  map(l).transpose().triangularView<Eigen::Upper>().solveInPlace(its);
}
void add_symmetric(const ConstBlock& a, const double* x, double* y) {
  map(y, a.rows) += map(a).selfadjointView<Eigen::Lower>() * map(x, a.rows);
}
void subtract_square(const Block& a, const ConstBlock& u) {
  map(a).selfadjointView<Eigen::Lower>().rankUpdate(map(u), -1.0);
}
void subtract_both(const Block& a, const ConstBlock& u, const ConstBlock& v) {
  map(a).triangularView<Eigen::Lower>() -= map(u) * map(v).transpose();
  map(a).triangularView<Eigen::Lower>() -= map(v) * map(u).transpose();
}
void subtract_product(const Block& a, const ConstBlock& u, const ConstBlock& v) {
  map(a).noalias() -= map(u) * map(v).transpose();
}
void add_product(double sign, const ConstBlock& a, const double* x, double* y) {
  map(y, a.rows).noalias() += sign * (map(a) * map(x, a.columns));
}
void add_transposed(double sign, const ConstBlock& a, const double* x, double* y) {
  map(y, a.columns).noalias() += sign * (map(a).transpose() * map(x, a.rows));
}
void divide(const ConstBlock& l, const Block& x) {
  auto its = map(x);
  map(l).triangularView<Eigen::Lower>().solveInPlace(its);
}
void divide_transposed(const ConstBlock& l, const Block& x) {
  auto its = map(x);
  map(l).transpose().triangularView<Eigen::Upper>().solveInPlace(its);
}
void subtract_times(const Block& y, const ConstBlock& a, const ConstBlock& x) {
  map(y).noalias() -= map(a) * map(x);
}
void subtract_transposed_times(const Block& y, const ConstBlock& a, const ConstBlock& x) {
  map(y).noalias() -= map(a).transpose() * map(x);
}

const char* name() { return "Eigen"; }

#endif

}  // namespace seesaw::dense
