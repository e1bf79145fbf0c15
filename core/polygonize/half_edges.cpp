#include "core/polygonize/half_edges.h"

#include "core/base/parallel.h"

namespace seesaw {

HalfEdges::HalfEdges(const Faces& faces, Index vertices)
    : origin_(faces.data(), faces.data() + faces.size()),
      twin_(static_cast<std::size_t>(faces.size()), -1),
      leaving_(static_cast<std::size_t>(vertices), -1) {
  // The half-edges that leave each vertex, one run a vertex.
  std::vector<int> start(leaving_.size() + 1, 0), run(origin_.size()), ends(origin_.size());
  for (const int v : origin_) ++start[slot(v) + 1];
  for (std::size_t v = 0; v < leaving_.size(); ++v) start[v + 1] += start[v];
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (int h = 0; h < size(); ++h) {
    const std::size_t place = slot(fill[slot(origin(h))]++);
    run[place] = h;
    ends[place] = target(h);
  }
  parallel_blocks(size(), 3 * 4096, [&](Index begin, Index end) {
    for (int h = static_cast<int>(begin); h < static_cast<int>(end); ++h) {
      const int from = target(h);
      for (int i = start[slot(from)]; i < start[slot(from) + 1]; ++i)
        if (ends[slot(i)] == origin(h)) twin_[slot(h)] = run[slot(i)];
    }
  });
  for (int h = size() - 1; h >= 0; --h) {
    int& first = leaving_[slot(origin(h))];
    if (first < 0 || twin(h) < 0 || twin(first) >= 0) first = h;
  }
}

bool HalfEdges::are_neighbors(int a, int b) const {
  return any_leaving(a, [&](int h) { return target(h) == b || origin(previous(h)) == b; });
}

bool HalfEdges::can_collapse(int h) const {
  const int t = twin(h), a = origin(h), b = target(h), c = origin(previous(h));
  const int d = t < 0 ? -1 : origin(previous(t));
  if (c == d) return false;
  if (t < 0) {
    if (twin(next(h)) < 0 && twin(previous(h)) < 0) return false;  // a triangle by itself
  } else if (is_boundary(b)) {
    return false;
  }
  int common = 0;
  const auto look_at = [&](int v) {
    if (v != a && (v == c || v == d || are_neighbors(a, v))) ++common;
  };
  for_each_leaving(b, [&](int g) {
    look_at(target(g));
    if (twin(previous(g)) < 0) look_at(origin(previous(g)));  // the last neighbor on a boundary
  });
  if (common != (t < 0 ? 1 : 2)) return false;
  // Vertices c and d lose a neighbor each; with three they would have two, and two faces lie on each other.
  return keeps_three(c) && (d < 0 || keeps_three(d));
}

// Whether v has more than three neighbors (on the boundary, two).
bool HalfEdges::keeps_three(int v) const {
  const int least = is_boundary(v) ? 2 : 4;
  int faces = 0;
  return any_leaving(v, [&](int) { return ++faces == least; });
}

// Makes g and h twins; either may be -1.
void HalfEdges::join(int g, int h) {
  if (g >= 0) twin_[slot(g)] = h;
  if (h >= 0) twin_[slot(h)] = g;
}

void HalfEdges::collapse(int h) {
  const int t = twin(h), a = origin(h), b = target(h), c = origin(previous(h));
  const int d = t < 0 ? -1 : origin(previous(t));
  const int x = twin(next(h)), y = twin(previous(h));  // c to b and a to c, seen from outside
  const int z = t < 0 ? -1 : twin(next(t)), w = t < 0 ? -1 : twin(previous(t));  // d to a and b to d
  moved_.clear();
  for_each_leaving(b, [&](int g) { moved_.push_back(g); });
  for (const int g : moved_) origin_[slot(g)] = a;
  join(x, y);
  join(w, z);
  // x leads from c and, by now, w from a. On the boundary the first half-edge must stay the one without a
  // twin: that is w where a lost next(t), and what was the first of b where the edge was a boundary edge.
  if (leaving(c) == previous(h)) leaving_[slot(c)] = x;
  if (t < 0) {
    leaving_[slot(a)] = x < 0 ? y : leaving(b);  // x < 0: b was the tip of an ear
  } else {
    if (leaving(d) == previous(t)) leaving_[slot(d)] = z;
    if (leaving(a) == h || leaving(a) == next(t)) leaving_[slot(a)] = w;
  }
  leaving_[slot(b)] = -1;
  const auto kill = [&](int f) {
    for (int k = 0; k < 3; ++k) origin_[slot(3 * f + k)] = twin_[slot(3 * f + k)] = -1;
  };
  kill(h / 3);
  if (t >= 0) kill(t / 3);
}

bool HalfEdges::can_flip(int h) const {
  const int t = twin(h);
  if (t < 0) return false;
  const int c = origin(previous(h)), d = origin(previous(t));
  if (c == d || are_neighbors(c, d)) return false;
  // The ends lose a neighbor each.
  return keeps_three(origin(h)) && keeps_three(target(h));
}

void HalfEdges::flip(int h) {
  const int t = twin(h), hn = next(h), hp = previous(h), tn = next(t), tp = previous(t);
  const int a = origin(h), b = origin(t), c = origin(hp), d = origin(tp);
  const int bc = twin(hn), ca = twin(hp), ad = twin(tn), db = twin(tp);
  // Face of h: d, c, a. Face of t: c, d, b.
  origin_[slot(h)] = d;
  origin_[slot(hn)] = c;
  origin_[slot(hp)] = a;
  origin_[slot(t)] = c;
  origin_[slot(tn)] = d;
  origin_[slot(tp)] = b;
  join(hn, ca);
  join(hp, ad);
  join(tn, db);
  join(tp, bc);
  // Who led from where before: h and tn from a, t and hn from b, hp from c, tp from d.
  const int from_a = leaving(a), from_b = leaving(b), from_c = leaving(c), from_d = leaving(d);
  if (from_a == h || from_a == tn) leaving_[slot(a)] = hp;
  if (from_b == t || from_b == hn) leaving_[slot(b)] = tp;
  if (from_c == hp) leaving_[slot(c)] = hn;
  if (from_d == tp) leaving_[slot(d)] = tn;
}

Faces HalfEdges::faces() const {
  Faces result(3, size() / 3);
  Index kept = 0;
  for (int f = 0; f < size() / 3; ++f)
    if (is_alive(3 * f)) {
      for (int k = 0; k < 3; ++k) result(k, kept) = origin(3 * f + k);
      ++kept;
    }
  result.conservativeResize(3, kept);
  return result;
}

}  // namespace seesaw
