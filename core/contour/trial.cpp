#include "core/contour/trial.h"

#include <span>

#include "core/contour/place.h"

namespace seesaw {
namespace {

constexpr double least_chord_cosine = 0.978;  // 12 degrees
constexpr double sample_cosine = 0.866;       // 30 degrees
constexpr double corner_cosine = 0.9986;      // 3 degrees; a smooth curve turns less in a 32nd of its chords
constexpr double size_factor = 3;
// Where the trials look, as fractions of the way from the seed to A or B. The last is 2e-7.
constexpr double first_trial[] = {0.5, 0.125, 0x1p-6};
constexpr double second_trial[] = {0x1p-6, 0x1p-9, 0x1p-12, 0x1p-15, 0x1p-18, 0x1p-22};
// Points beside the chords, this far from the seed (as a fraction of the chord) and off it by `aside` of
// that. A loop through the seed is betrayed by points at 0.6 to 7 times its radius, so factors of 11 leave
// none out.
constexpr double side_fractions[] = {0.1, 9e-3, 8e-4, 7e-5, 6e-6};
constexpr double aside = 0.3;

double cosine(const Point<2>& a, const Point<2>& b) {
  const double norms = a.norm() * b.norm();
  return norms > 0 ? a.dot(b) / norms : 0;
}

enum class Verdict { fits, wrong_size, wrong };

struct Judgement {
  Verdict verdict = Verdict::fits;
  bool corner = false;  // the gradients nearest to the seed differ from side to side
};

// Judges the chords of each trial by the gradients at `fractions` of them, all in one batch. Sizes are
// compared with the seed's gradient, or, `among_themselves`, with the outermost one of the same chord.
std::vector<Judgement> judge(Crossings& curve, const std::vector<Trial>& trials,
                             std::span<const double> fractions, bool among_themselves) {
  std::vector<Point<2>> samples;
  for (const Trial& trial : trials)
    for (const int end : {trial.before, trial.after})
      if (end >= 0)
        for (const double fraction : fractions)
          samples.push_back(trial.seed->at + fraction * (curve[end].position - trial.seed->at));
  Points<2> at(2, static_cast<Index>(samples.size())), gradients;
  for (Index k = 0; k < at.cols(); ++k) at.col(k) = samples[static_cast<std::size_t>(k)];
  Values f;
  curve.sampler().evaluate(at, f, gradients);

  std::vector<Judgement> judgements;
  Index first = 0;
  for (const Trial& trial : trials) {
    Judgement judgement;
    Verdict& verdict = judgement.verdict;
    std::vector<Point<2>> nearest;
    for (const int end : {trial.before, trial.after}) {
      if (end < 0) continue;
      const Point<2> to_end = curve[end].position - trial.seed->at;
      const Point<2> left = left_of(end == trial.after ? to_end : Point<2>(-to_end));
      if (!curve[end].gradient.isZero(0) && cosine(curve[end].gradient, left) < least_chord_cosine)
        verdict = Verdict::wrong;
      if (trial.seed->gradient.dot(left) <= 0) verdict = Verdict::wrong;
      const double size = among_themselves ? gradients.col(first).norm() : trial.seed->gradient.norm();
      for (std::size_t k = 0; k < fractions.size(); ++k, ++first) {
        const Point<2> gradient = gradients.col(first);
        if (cosine(gradient, left) < sample_cosine) verdict = Verdict::wrong;
        const double norm = gradient.norm();
        if (!(norm * size_factor >= size && norm <= size * size_factor) && verdict == Verdict::fits)
          verdict = Verdict::wrong_size;
      }
      nearest.push_back(gradients.col(first - 1));
    }
    judgement.corner = nearest.size() == 2 && cosine(nearest[0], nearest[1]) < corner_cosine;
    judgements.push_back(judgement);
  }
  return judgements;
}

// Inside lies left of the chords near the seed, outside right of them: true for a curve that runs along them,
// and wrong beside a loop that only touches them, or between two curves that cross at the seed.
std::vector<bool> sides_fit(Crossings& curve, const std::vector<Trial>& trials) {
  struct Sample {
    std::size_t trial;
    bool inside;
  };
  std::vector<Sample> expected;
  std::vector<Point<2>> samples;
  const Lattice& lattice = curve.mesh().lattice();
  for (std::size_t k = 0; k < trials.size(); ++k)
    for (const int end : {trials[k].before, trials[k].after}) {
      if (end < 0) continue;
      const Point<2> to_end = curve[end].position - trials[k].seed->at;
      const Point<2> left = left_of(end == trials[k].after ? to_end : Point<2>(-to_end));
      for (const double fraction : side_fractions)
        for (const double side : {aside, -aside}) {
          const Point<2> p = trials[k].seed->at + fraction * (to_end + side * left);
          // Beyond the box, or too near for the coordinates' digits, there is nothing to learn.
          if (!lattice.box.contains(p) || aside * fraction * to_end.norm() < 8 * lattice.grain) continue;
          samples.push_back(p);
          expected.push_back({k, side > 0});
        }
    }
  Points<2> at(2, static_cast<Index>(samples.size()));
  for (Index k = 0; k < at.cols(); ++k) at.col(k) = samples[static_cast<std::size_t>(k)];
  Values f;
  curve.sampler().evaluate(at, f);
  std::vector<bool> fit(trials.size(), true);
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (is_inside(f[static_cast<Index>(k)]) != expected[k].inside) fit[expected[k].trial] = false;
  return fit;
}

}  // namespace

std::vector<bool> prove(Crossings& curve, const std::vector<Trial>& trials) {
  std::vector<bool> proved(trials.size(), false);
  if (trials.empty()) return proved;
  std::vector<Trial> fitting, doubtful;
  std::vector<std::size_t> fitting_index, doubtful_index;
  std::vector<Judgement> judgements = judge(curve, trials, first_trial, false);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const Verdict verdict = judgements[k].verdict;
    trials[k].seed->corner = judgements[k].corner || verdict == Verdict::wrong_size;
    if (verdict == Verdict::wrong) continue;
    (verdict == Verdict::fits ? fitting : doubtful).push_back(trials[k]);
    (verdict == Verdict::fits ? fitting_index : doubtful_index).push_back(k);
  }
  judgements = judge(curve, doubtful, second_trial, true);
  for (std::size_t k = 0; k < doubtful.size(); ++k)
    if (judgements[k].verdict == Verdict::fits) {
      fitting.push_back(doubtful[k]);
      fitting_index.push_back(doubtful_index[k]);
    }
  const std::vector<bool> fit = sides_fit(curve, fitting);
  for (std::size_t k = 0; k < fitting.size(); ++k) proved[fitting_index[k]] = fit[k];
  return proved;
}

}  // namespace seesaw
