// Floaters: particles that spread evenly over a surface and stay on it while it moves.
//
// Before it: any Field<3>, and whoever moves it: nobody, an editor that fits again, or control points
// (control_points.h).  After it: discs for display, measures.h, integrals.h.
//
//     Floaters floaters(field, {.desired_radius = 0.05});
//     floaters.equilibrate(field);
//     const Discs discs = floaters.discs();
//
// One step is Witkin & Heckbert's (1994, section 5), in their order, in two halves between which the surface
// moves:
//
//     choose_velocities(field, f_t)   repulsion sets desired velocities               (eq. 9,  repulsion.h)
//                                     the surface's motion makes actual ones of them   (eq. 5,  adhesion.h)
//     ... the surface moves by time_step ...
//     move(field)                     positions, by Euler and then Newton              (walk.h)
//                                     radii                                            (eqs. 10-13, radii.h)
//                                     fission and death             (section 4.4, birth_and_death.h)
//
// step(field) does both for a surface at rest, or for one that somebody has moved since by less than about a
// desired radius.
//
// What the paper does not say, and we do:
//   - Repulsion acts between floaters of one sheet only (same_sheet.h).
//   - No step leads to another sheet or component (walk.h), and no radius makes a step longer than half of
//     it.
//   - A floater that wants to go back where it came from has gone too far: Euler's step is too long there, on
//     sharp edges and around limbs thinner than a radius. It then takes shorter steps, and longer ones again
//     as it goes on.
//   - A floater whose surface has gone is *astray*: it tries to come back for ten steps and as far as four
//     desired radii, then it is *lost*: it dies, and is counted. So when a component vanishes its floaters
//     do; they do not settle elsewhere. When the last one is lost, every step looks for a surface anew.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/random.h"
#include "core/implicit/field.h"
#include "core/particles/adhesion.h"
#include "core/particles/birth_and_death.h"
#include "core/particles/floater_options.h"
#include "core/particles/repulsion.h"

namespace seesaw {

/// Oriented discs, as plain arrays: what a ray tracer or a graphics card draws.
struct Discs {
  Points<3> centers = Points<3>(3, 0);  ///< 3 x N, scene units
  Points<3> normals = Points<3>(3, 0);  ///< 3 x N, outward, unit
  Values radii;                         ///< N, scene units
};

/// What became of floaters since they began.
struct FloaterCounts {
  Index seeded = 0;
  Index births = 0;  ///< divisions
  Index deaths = 0;  ///< of crowding
  Index lost = 0;    ///< because their surface had gone
};

class Floaters {
 public:
  /// One floater, somewhere on the surface; none where the field has no surface that can be found.
  explicit Floaters(const Field<3>& field, const FloaterOptions& options = {});
  /// One at each of `seeds` (3 x N) that is near the surface, thinned as `seed` does; where none is, as
  /// above. Boundary constraints make good seeds: every component that they lie on is found.
  Floaters(const Field<3>& field, const PointsRef<3>& seeds, const FloaterOptions& options = {});

  /// Further floaters at those of `points` (3 x N) that are within a desired radius of f = 0, and that no
  /// floater of the same sheet is near: two desired radii, or two of its own. Returns how many. To be called
  /// between steps, after an edit that may have made new components.
  Index seed(const Field<3>& field, const PointsRef<3>& points);

  /// The first half of a step. `rates`: f_t = f_q . q' at `positions()`, N, value per unit of time; empty for
  /// a surface at rest.
  void choose_velocities(const Field<3>& field, const Values& rates = {});
  /// The second half, with the surface as it is one time step later.
  void move(const Field<3>& field);
  /// Both.
  void step(const Field<3>& field) {
    choose_velocities(field);
    move(field);
  }
  /// Steps until at rest, at most `most` times; returns how many. Throws Cancelled.
  Index equilibrate(const Field<3>& field, Index most = 3000, const Progress& progress = {});

  /// Nobody was born, died or was lost in the last 100 steps, and the median speed along the surface is
  /// below 0.05 radii per unit of time.
  bool at_rest() const;

  Index size() const { return crowd_.radii.size(); }
  const Points<3>& positions() const { return crowd_.positions; }  ///< 3 x N, scene units
  const Points<3>& normals() const { return crowd_.normals; }      ///< 3 x N, outward, unit
  const Points<3>& velocities() const { return velocities_; }      ///< 3 x N, scene units per unit of time
  const Values& radii() const { return crowd_.radii; }             ///< sigma_i, N, scene units
  const Crowd& crowd() const { return crowd_; }
  /// sigma-hat for each, N, scene units: the same for all unless options().turn asks for more where it bends.
  Values desired_radii() const;
  /// How many are off the surface at the moment.
  Index astray() const;
  /// Speeds relative to the surface, in radii per unit of time, N.
  Values slide_speeds() const;
  const FloaterCounts& counts() const { return counts_; }

  /// Radii are `size` times sigma_i; neighbors at rest are about 1.9 sigma_i apart.
  Discs discs(double size = 1.0) const;

  const FloaterOptions& options() const { return options_; }
  /// Takes effect from the next step; the diameter stays unless options.diameter sets one.
  void set_options(const FloaterOptions& options);
  /// d, scene units.
  double diameter() const { return diameter_; }

 private:
  double desired_radius() const { return options_.desired_radius * diameter_; }
  double largest_radius() const;
  double median_speed() const;
  /// The new population: floater k is a copy of the old one's `sources[k]`.
  void select(const std::vector<Index>& sources);
  void add(const Points<3>& positions, const Points<3>& normals, double radius);
  void update_radii();
  void count_astray(const std::vector<char>& on);
  void live_and_die(const Field<3>& field);
  void carry_out(const Field<3>& field, const std::vector<Fate>& fates);
  void start_again(const Field<3>& field);

  FloaterOptions options_;
  double diameter_ = 1;
  Random random_;
  FloaterCounts counts_;
  Index quiet_steps_ = 0;  // since somebody was born, died or was lost

  Crowd crowd_;
  Points<3> velocities_ = Points<3>(3, 0);
  Values allowed_;                       // of the scale, by the neighbors'
  Values curvature_;                     // smoothed over steps
  Points<3> home_ = Points<3>(3, 0);     // where each was last on the surface
  Points<3> heading_ = Points<3>(3, 0);  // tangent_ of the step before
  Values pace_;                          // how much of a step each takes
  Eigen::VectorXi astray_;               // steps since

  // From the first half of a step to the second.
  Contact contact_;
  PairSums sums_;
  Points<3> tangent_ = Points<3>(3, 0), normal_ = Points<3>(3, 0);
  Points<3> carried_ = Points<3>(3, 0);  // the part of normal_ that is the surface's motion
};

}  // namespace seesaw
