#include "core/raytrace/bound_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace seesaw {

struct BoundTree::Facts {
  double bound = 0;
  bool empty = false, cut = false;
};

// Nothing here ever waits: a thread that finds facts half written works them out for itself. (It must not
// wait: evaluating a field runs other tasks of the same pool, which might be those that would have to be
// waited for.)
struct BoundTree::Node {
  enum State { unknown, being_written, known };
  std::atomic<int> state = unknown;
  double middle = 0, slope = 0;  // f and |grad f| in the middle
  Facts facts;
  std::atomic<Children*> children = nullptr;

  ~Node();
};

struct BoundTree::Children {
  std::array<Node, 8> nodes;
};

BoundTree::Node::~Node() { delete children.load(); }

BoundTree::BoundTree(std::shared_ptr<const Field<3>> field, const Box<3>& box,
                     const BoundTreeOptions& options)
    : field_(std::move(field)), box_(box), options_(options), root_(std::make_unique<Node>()) {
  SEESAW_CHECK_EQ(box.isEmpty(), false);
  // Boxes without end would take memory without end.
  SEESAW_CHECK_LE(1e-6, options.smallest_side);
  SEESAW_CHECK_LE(1.0, options.inherits);
  root_->middle = field_->value(box.center());
  root_->slope = field_->gradient(box.center()).norm();
}

BoundTree::~BoundTree() = default;

namespace {

// Octant `k` of the box: bit d says the upper half along d.
Box<3> octant(const Box<3>& box, int k) {
  const Point<3> middle = box.center();
  Box<3> result = box;
  for (int d = 0; d < 3; ++d) (k & (1 << d) ? result.min() : result.max())[d] = middle[d];
  return result;
}

}  // namespace

BoundTree::Children& BoundTree::children_of(Node& node, const Box<3>& box) const {
  Children* all = node.children.load(std::memory_order_acquire);
  if (all) return *all;
  // Eight points at once cost a field hardly more than one.
  Points<3> middles(3, 8), gradients(3, 8);
  Values values(8);
  for (int k = 0; k < 8; ++k) middles.col(k) = octant(box, k).center();
  field_->evaluate(middles, values, gradients);
  auto made = std::make_unique<Children>();
  for (int k = 0; k < 8; ++k) {
    made->nodes[static_cast<std::size_t>(k)].middle = values[k];
    made->nodes[static_cast<std::size_t>(k)].slope = gradients.col(k).norm();
  }
  if (node.children.compare_exchange_strong(all, made.get(), std::memory_order_acq_rel)) all = made.release();
  return *all;
}

BoundTree::Facts BoundTree::facts_of(Node& node, const Box<3>& box, double inherited) const {
  if (node.state.load(std::memory_order_acquire) == Node::known) return node.facts;
  // A hair more than the half diagonal: the box's own corners are rounded.
  const double radius = 0.5 * box.sizes().norm() * (1 + 1e-12);
  const double value = std::abs(node.middle);
  Facts facts;
  facts.bound = inherited;
  const auto loose = [&] { return !(facts.bound <= options_.pays * node.slope); };
  const bool asks = !(facts.bound * radius < options_.inherits * value) && loose();
  if (asks) facts.bound = std::min(inherited, field_->gradient_bound(box));
  facts.empty = value > facts.bound * radius;
  facts.cut =
      !facts.empty && loose() && box.sizes().maxCoeff() > options_.smallest_side * box_.sizes().maxCoeff();
  int expected = Node::unknown;
  if (node.state.compare_exchange_strong(expected, Node::being_written)) {
    node.facts = facts;
    node.state.store(Node::known, std::memory_order_release);
    ++boxes_;
    if (facts.empty) ++empty_boxes_;
    if (asks) ++bounds_;
  }
  return facts;
}

BoundTree::Leaf BoundTree::leaf_at(const Point<3>& point, const Point<3>& direction) const {
  Node* node = root_.get();
  Box<3> box = box_;
  double bound = infinity;
  for (;;) {
    const Facts facts = facts_of(*node, box, bound);
    if (!facts.cut) return {box, facts.bound, node->middle, facts.empty};
    bound = facts.bound;
    const Point<3> middle = box.center();
    int k = 0;
    for (int d = 0; d < 3; ++d)
      if (point[d] > middle[d] || (point[d] == middle[d] && direction[d] > 0)) k |= 1 << d;
    node = &children_of(*node, box).nodes[static_cast<std::size_t>(k)];
    box = octant(box, k);
  }
}

}  // namespace seesaw
