// Who is there: how floaters begin, divide, die and are lost. The rest of floaters.h.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/particles/floaters.h"
#include "core/particles/landing.h"
#include "core/particles/neighbors.h"
#include "core/particles/same_sheet.h"
#include "core/particles/walk.h"

namespace seesaw {
namespace {

constexpr int patience = 10;        // steps astray
constexpr double farthest = 4;      // from where it was last on the surface, in desired radii
constexpr double seed_spacing = 2;  // in radii

double size_of(const Field<3>& field) {
  const Box<3> box = field.bounding_box();
  const double longest = box.isEmpty() ? 1.0 : box.sizes().maxCoeff();
  return longest > 0 && std::isfinite(longest) ? longest : 1.0;
}

void check(const FloaterOptions& options) {
  for (const double positive :
       {options.desired_radius, options.time_step, options.amplitude, options.desired_energy,
        options.softening, options.largest_radius, options.death_radius, options.smallest_fraction})
    SEESAW_CHECK_LT(0.0, positive);
  for (const double number : {options.diameter, options.adhesion_gain, options.radius_gain, options.turn,
                              options.equilibrium_speed, options.fission_energy, options.simple_radius})
    SEESAW_CHECK_LE(0.0, number);
}

}  // namespace

Floaters::Floaters(const Field<3>& field, const FloaterOptions& options)
    : Floaters(field, Points<3>(3, 0), options) {}

Floaters::Floaters(const Field<3>& field, const PointsRef<3>& seeds, const FloaterOptions& options)
    : options_(options),
      diameter_(options.diameter > 0 ? options.diameter : size_of(field)),
      random_(options.seed) {
  check(options);
  if (seed(field, seeds) > 0) return;
  if (const auto point = some_point_on(field, random_)) seed(field, *point);
}

void Floaters::set_options(const FloaterOptions& options) {
  check(options);
  options_ = options;
  if (options.diameter > 0) diameter_ = options.diameter;
  quiet_steps_ = 0;
}

Index Floaters::seed(const Field<3>& field, const PointsRef<3>& points) {
  Index added = 0;
  const double leash = desired_radius();
  const PutOn put = put_on(field, points, Values::Constant(points.cols(), leash),
                           Values::Constant(points.cols(), walk_tolerance * leash));
  // In the first generation of global fissioning the radius must let a few floaters feel each other: the
  // paper's 0.3 sqrt(area / number), with the area of a sphere of this diameter.
  const bool adaptive = options_.repulsion == Repulsion::adaptive;
  const double first = adaptive ? desired_radius()
                       : options_.repulsion == Repulsion::simple && options_.simple_radius > 0
                           ? options_.simple_radius * diameter_
                           : 0.3 * std::sqrt(std::numbers::pi) * diameter_;
  const double radius = size() > 0 ? std::min(first, crowd_.radii.mean()) : first;
  const Neighbors neighbors(crowd_.positions, crowd_.radii);
  const Index before = size();
  for (Index k = 0; k < points.cols(); ++k) {
    if (!put.on[static_cast<std::size_t>(k)]) continue;
    const Point<3> at = put.positions.col(k), normal = -put.gradients.col(k).normalized();
    const auto on_sheet = [&](Index i) {
      return same_sheet(at - crowd_.positions.col(i), normal, crowd_.normals.col(i)) > 0.5;
    };
    const auto near = [&](Index i) {
      const double spacing =
          seed_spacing * (adaptive ? std::max(crowd_.radii[i], desired_radius()) : desired_radius());
      return (at - crowd_.positions.col(i)).squaredNorm() < spacing * spacing && on_sheet(i);
    };
    bool taken = neighbors.nearest_squared(at, -1, [&](int i) { return near(i); }) < INFINITY;
    for (Index i = before; i < size() && !taken; ++i) taken = near(i);
    if (taken) continue;
    add(at, normal, radius);
    ++added;
  }
  if (added > 0 && options_.repulsion != Repulsion::adaptive && before == 0)
    crowd_.radii /= std::sqrt(static_cast<double>(added));
  counts_.seeded += added;
  if (added > 0) quiet_steps_ = 0, tangent_.resize(3, 0);
  return added;
}

void Floaters::start_again(const Field<3>& field) {
  if (const auto point = some_point_on(field, random_, true)) seed(field, *point);
}

void Floaters::add(const Points<3>& positions, const Points<3>& normals, double radius) {
  const Index before = size(), more = positions.cols();
  const auto append = [&](Points<3>& all, const Points<3>& last) {
    all.conservativeResize(3, before + more);
    all.rightCols(more) = last;
  };
  append(crowd_.positions, positions);
  append(crowd_.normals, normals);
  append(velocities_, Points<3>::Zero(3, more));
  append(heading_, Points<3>::Zero(3, more));
  append(home_, positions);
  const auto append_number = [&](Values& all, double number) {
    all.conservativeResize(before + more);
    all.tail(more).setConstant(number);
  };
  append_number(crowd_.radii, radius);
  append_number(curvature_, 0.0);
  append_number(pace_, 1.0);
  append_number(allowed_, 1.0);
  astray_.conservativeResize(before + more);
  astray_.tail(more).setZero();
}

void Floaters::select(const std::vector<Index>& sources) {
  const auto columns = [&](Points<3>& all) { all = Points<3>(all(Eigen::all, sources)); };
  const auto rows = [&](auto& all) { all = std::decay_t<decltype(all)>(all(sources)); };
  for (Points<3>* all : {&crowd_.positions, &crowd_.normals, &velocities_, &heading_, &home_}) columns(*all);
  rows(crowd_.radii);
  rows(curvature_);
  rows(pace_);
  rows(allowed_);
  rows(astray_);
}

void Floaters::count_astray(const std::vector<char>& on) {
  for (Index i = 0; i < size(); ++i)
    if (on[static_cast<std::size_t>(i)]) {
      home_.col(i) = crowd_.positions.col(i);
      astray_[i] = 0;
    } else {
      ++astray_[i];
    }
}

void Floaters::live_and_die(const Field<3>& field) {
  const bool adaptive = options_.repulsion == Repulsion::adaptive;
  std::vector<Fate> fate(static_cast<std::size_t>(size()), Fate::stays);
  const Values desired = desired_radii();
  if (adaptive) {
    const double energy = options_.desired_energy * options_.amplitude;
    const LifeRule rule = {options_.equilibrium_speed, largest_radius(), options_.fission_energy * energy,
                           options_.death_radius};
    const Values speeds = velocities_.colwise().norm();
    fate = fates(crowd_.radii, desired, sums_.own, speeds, rule, random_);
  } else if (options_.repulsion == Repulsion::global_fissioning && crowd_.radii[0] > desired_radius() &&
             quiet_steps_ > 3 && median_speed() < options_.generation_speed) {
    fate.assign(fate.size(), Fate::divides);
  }
  for (Index i = 0; i < size(); ++i)
    if (astray_[i] > 0) {
      const bool far = (crowd_.positions.col(i) - home_.col(i)).norm() > farthest * desired[i];
      const bool dies = astray_[i] > patience || far;
      counts_.lost += dies;
      counts_.deaths -= dies;  // carry_out counts it among them
      fate[static_cast<std::size_t>(i)] = dies ? Fate::dies : Fate::stays;
    }
  carry_out(field, fate);
}

void Floaters::carry_out(const Field<3>& field, const std::vector<Fate>& fate) {
  std::vector<Index> parents;
  Index dying = 0;
  for (Index i = 0; i < size(); ++i) {
    if (fate[static_cast<std::size_t>(i)] == Fate::divides) parents.push_back(i);
    dying += fate[static_cast<std::size_t>(i)] == Fate::dies;
  }
  if (parents.empty() && dying == 0) return;

  // Both children of each parent set out at once, in opposite directions.
  const Index count = std::ssize(parents);
  Ways ways = {Points<3>(3, 2 * count), Points<3>(3, 2 * count), Points<3>(3, 2 * count), Values(2 * count),
               Values(2 * count)};
  const Values desired = desired_radii();
  for (Index k = 0; k < count; ++k) {
    const Index i = parents[static_cast<std::size_t>(k)];
    const Point<3> way = birth_distance / std::numbers::sqrt2 * crowd_.radii[i] *
                         tangent_direction(crowd_.normals.col(i), random_);
    for (const Index child : {2 * k, 2 * k + 1}) {
      ways.from.col(child) = crowd_.positions.col(i);
      ways.normals.col(child) = crowd_.normals.col(i);
      ways.by.col(child) = child % 2 == 0 ? way : Point<3>(-way);
      ways.grain[child] = desired[i];
      ways.leashes[child] = 0;
    }
  }
  const Walked walked = walk(field, ways);

  std::vector<Index> sources, children;  // `children`: which of `walked` each new floater is, or -1
  for (Index i = 0, k = 0; i < size(); ++i) {
    if (fate[static_cast<std::size_t>(i)] == Fate::dies) {
      ++counts_.deaths;
      continue;
    }
    if (fate[static_cast<std::size_t>(i)] == Fate::divides) {
      const Index first = 2 * k++;
      // Children that could not get away from each other would never part.
      if ((walked.positions.col(first) - walked.positions.col(first + 1)).norm() > 0) {
        ++counts_.births;
        sources.insert(sources.end(), 2, i);
        children.insert(children.end(), {first, first + 1});
        continue;
      }
    }
    sources.push_back(i);
    children.push_back(-1);
  }
  select(sources);
  crowd_.scales.resize(0);
  for (Index i = 0; i < size(); ++i) {
    const Index child = children[static_cast<std::size_t>(i)];
    if (child < 0) continue;
    crowd_.positions.col(i) = home_.col(i) = walked.positions.col(child);
    crowd_.normals.col(i) = walked.normals.col(child);
    crowd_.radii[i] /= std::numbers::sqrt2;
    heading_.col(i).setZero();
    pace_[i] = 1;
  }
  if (options_.repulsion == Repulsion::global_fissioning && size() > 0)
    crowd_.radii.setConstant(crowd_.radii.minCoeff());
  quiet_steps_ = 0;
}

}  // namespace seesaw
