#include "core/rbf/parametric_interpolant.h"

namespace seesaw {
namespace {

template <int Dim>
Index count_of(const Constraint<Dim>& constraint) {
  return Dim + 1 + (constraint.normal ? 1 : 0);
}

FitOptions without_condition(FitOptions options) {
  options.condition = false;  // some ten solves, and nobody looks at it between two frames
  return options;
}

template <int Dim>
std::shared_ptr<const FullFit<Dim>> fitted(const Constraints<Dim>& constraints, const FitOptions& options) {
  return std::make_shared<const FullFit<Dim>>(full_fit(constraints, options));
}

}  // namespace

template <int Dim>
ParametricInterpolant<Dim>::ParametricInterpolant(const Constraints<Dim>& constraints,
                                                  const FitOptions& options)
    : constraints_(constraints), options_(without_condition(options)), fit_(fitted(constraints, options_)) {
  Index count = 0;
  for (const Constraint<Dim>& each : constraints_) {
    first_.push_back(count);
    count += count_of(each);
  }
  this->start(count);
}

template <int Dim>
void ParametricInterpolant<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const {
  function().evaluate(points, values);
}

template <int Dim>
void ParametricInterpolant<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                                          Eigen::Ref<Points<Dim>> gradients) const {
  function().evaluate(points, values, gradients);
}

template <int Dim>
double ParametricInterpolant<Dim>::gradient_bound(const Box<Dim>& box) const {
  return function().gradient_bound(box);
}

template <int Dim>
Box<Dim> ParametricInterpolant<Dim>::bounding_box() const {
  return function().bounding_box();
}

template <int Dim>
std::vector<std::string> ParametricInterpolant<Dim>::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const std::string name = "c" + std::to_string(i);
    append_coordinate_names<Dim>(name, names);
    names.push_back(name + ".value");
    if (constraints_[i].normal) names.push_back(name + ".normal_value");
  }
  return names;
}

template <int Dim>
Index ParametricInterpolant<Dim>::position_parameter(Index constraint) const {
  SEESAW_CHECK_LE(0, constraint);
  SEESAW_CHECK_LT(constraint, static_cast<Index>(first_.size()));
  return first_[static_cast<std::size_t>(constraint)];
}

template <int Dim>
Index ParametricInterpolant<Dim>::value_parameter(Index constraint) const {
  return position_parameter(constraint) + Dim;
}

template <int Dim>
std::optional<Index> ParametricInterpolant<Dim>::normal_value_parameter(Index constraint) const {
  const Index value = value_parameter(constraint);
  if (!constraints_[static_cast<std::size_t>(constraint)].normal) return std::nullopt;
  return value + 1;
}

template <int Dim>
void ParametricInterpolant<Dim>::freeze_values(bool frozen) {
  for (Index i = 0; i < static_cast<Index>(constraints_.size()); ++i) {
    this->freeze(value_parameter(i), frozen);
    if (const auto normal = normal_value_parameter(i)) this->freeze(*normal, frozen);
  }
}

template <int Dim>
void ParametricInterpolant<Dim>::freeze_positions(bool frozen) {
  for (Index i = 0; i < static_cast<Index>(constraints_.size()); ++i)
    for (int d = 0; d < Dim; ++d) this->freeze(position_parameter(i) + d, frozen);
}

template <int Dim>
Values ParametricInterpolant<Dim>::all() const {
  Values q(first_.back() + count_of(constraints_.back()));
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const Constraint<Dim>& each = constraints_[i];
    q.template segment<Dim>(first_[i]) = each.at;
    q[first_[i] + Dim] = each.value;
    if (each.normal) q[first_[i] + Dim + 1] = each.normal->value;
  }
  return q;
}

template <int Dim>
void ParametricInterpolant<Dim>::set_all(const Values& q) {
  Constraints<Dim> moved = constraints_;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    Constraint<Dim>& each = moved[i];
    each.at = q.template segment<Dim>(first_[i]);
    each.value = q[first_[i] + Dim];
    if (each.normal) each.normal->value = q[first_[i] + Dim + 1];
  }
  fit_ = fitted(moved, options_);  // may throw: only then is anything changed
  constraints_ = std::move(moved);
  sensitivity_.reset();
}

// The rows that `fit` has made of the constraints, in its order.
template <int Dim>
std::vector<typename ParametricInterpolant<Dim>::RowParameters> ParametricInterpolant<Dim>::row_parameters()
    const {
  std::vector<RowParameters> result;
  for (const auto& origin : fit_->rows.origins) {
    const Index position = position_parameter(origin.constraint);
    result.push_back({position, position + Dim + (origin.normal ? 1 : 0)});
  }
  return result;
}

template <int Dim>
const Sensitivity<Dim>& ParametricInterpolant<Dim>::sensitivity() const {
  if (!sensitivity_) sensitivity_.emplace(fit_);
  return *sensitivity_;
}

template <int Dim>
Eigen::MatrixXd ParametricInterpolant<Dim>::all_gradients(const PointsRef<Dim>& points) const {
  const std::vector<RowParameters> rows = row_parameters();
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(first_.back() + count_of(constraints_.back()), points.cols());
  for (Index k = 0; k < points.cols(); ++k) {
    const auto by_rows = sensitivity().by_rows(points.col(k));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto row = by_rows.col(static_cast<Index>(i));
      result.col(k).template segment<Dim>(rows[i].position) += row.template head<Dim>();
      result(rows[i].value, k) += row[Dim];
    }
  }
  return result;
}

template <int Dim>
Values ParametricInterpolant<Dim>::all_rates(const PointsRef<Dim>& points, const Values& rates) const {
  const std::vector<RowParameters> rows = row_parameters();
  Points<Dim> center_rates(Dim, static_cast<Index>(rows.size()));
  Values value_rates(static_cast<Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    center_rates.col(static_cast<Index>(i)) = rates.template segment<Dim>(rows[i].position);
    value_rates[static_cast<Index>(i)] = rates[rows[i].value];
  }
  return sensitivity().rates(points, center_rates, value_rates);
}

template class ParametricInterpolant<2>;
template class ParametricInterpolant<3>;

}  // namespace seesaw
