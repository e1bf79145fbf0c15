// Which faces come near a box? A tree of boxes around the faces of a mesh.
//
// Before it: a mesh.  After it: self_intersections.h asks with the box of a face, shells.h with a ray.
//
// The faces are halved at the median of their middles along the longest side until a handful is left in each
// leaf: the tree depends on the mesh alone.
#pragma once

#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

class FaceBoxes {
 public:
  /// Of the faces `chosen` of `mesh`, which need not outlive the tree. O(F log F).
  FaceBoxes(const TriangleMesh& mesh, const std::vector<int>& chosen);

  /// Calls `visit(face)` for every face whose box has a point in common with `box`.
  template <class Visit>
  void visit(const Box<3>& box, Visit&& visitor) const {
    if (nodes_.empty()) return;
    int stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(stack[--depth])];
      if (!node.box.intersects(box)) continue;
      if (node.right < 0) {
        for (int i = node.begin; i < node.end; ++i)
          if (entries_[static_cast<std::size_t>(i)].box.intersects(box))
            visitor(entries_[static_cast<std::size_t>(i)].face);
      } else {
        stack[depth++] = node.right;
        stack[depth++] = static_cast<int>(&node - nodes_.data()) + 1;
      }
    }
  }

 private:
  struct Node {
    Box<3> box;
    int begin, end;  // of its entries
    int right;       // the second child, or -1 in a leaf; the first child stands next to its parent
  };
  struct Entry {
    Box<3> box;
    int face;
  };
  void build(int begin, int end);

  std::vector<Entry> entries_;
  std::vector<Node> nodes_;
};

}  // namespace seesaw
