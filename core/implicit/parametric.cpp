#include "core/implicit/parametric.h"

#include "core/base/error.h"

namespace seesaw {

template <int Dim>
void ParametricField<Dim>::start(Index count) {
  SEESAW_CHECK_LE(0, count);
  frozen_.assign(static_cast<std::size_t>(count), false);
  free_.clear();
  for (Index i = 0; i < count; ++i) free_.push_back(i);
}

template <int Dim>
void ParametricField<Dim>::freeze(Index index, bool frozen) {
  SEESAW_CHECK_LE(0, index);
  SEESAW_CHECK_LT(index, static_cast<Index>(frozen_.size()));
  frozen_[static_cast<std::size_t>(index)] = frozen;
  free_.clear();
  for (std::size_t i = 0; i < frozen_.size(); ++i)
    if (!frozen_[i]) free_.push_back(static_cast<Index>(i));
}

template <int Dim>
bool ParametricField<Dim>::is_frozen(Index index) const {
  SEESAW_CHECK_LE(0, index);
  SEESAW_CHECK_LT(index, static_cast<Index>(frozen_.size()));
  return frozen_[static_cast<std::size_t>(index)];
}

template <int Dim>
Values ParametricField<Dim>::q() const {
  return all()(free_);
}

template <int Dim>
void ParametricField<Dim>::set_q(const Eigen::Ref<const Values>& q) {
  SEESAW_CHECK_EQ(q.size(), parameters());
  if (!q.allFinite())
    throw Error("a parameter of the surface would not be a finite number; move the surface more slowly");
  Values values = all();
  values(free_) = q;
  set_all(values);
}

template <int Dim>
Eigen::MatrixXd ParametricField<Dim>::q_gradients(const PointsRef<Dim>& points) const {
  return all_gradients(points)(free_, Eigen::all);
}

template <int Dim>
Values ParametricField<Dim>::rates(const PointsRef<Dim>& points,
                                   const Eigen::Ref<const Values>& q_rates) const {
  SEESAW_CHECK_EQ(q_rates.size(), parameters());
  Values rates = Values::Zero(static_cast<Index>(frozen_.size()));
  rates(free_) = q_rates;
  return all_rates(points, rates);
}

template <int Dim>
Values ParametricField<Dim>::all_rates(const PointsRef<Dim>& points, const Values& rates) const {
  return all_gradients(points).transpose() * rates;
}

template <int Dim>
void append_coordinate_names(const std::string& prefix, std::vector<std::string>& names) {
  for (int d = 0; d < Dim; ++d) names.push_back(prefix + '.' + "xyz"[d]);
}

template class ParametricField<2>;
template class ParametricField<3>;
template void append_coordinate_names<2>(const std::string&, std::vector<std::string>&);
template void append_coordinate_names<3>(const std::string&, std::vector<std::string>&);

}  // namespace seesaw
