#include "core/mesh/face_boxes.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace seesaw {

FaceBoxes::FaceBoxes(const TriangleMesh& mesh, const std::vector<int>& chosen) {
  entries_.reserve(chosen.size());
  for (const int f : chosen) {
    Box<3> box;
    for (int k = 0; k < 3; ++k) box.extend(Point<3>(mesh.vertices.col(mesh.faces(k, f))));
    entries_.push_back({box, f});
  }
  if (!entries_.empty()) build(0, static_cast<int>(entries_.size()));
}

void FaceBoxes::build(int begin, int end) {
  constexpr int leaf = 4;
  const std::size_t here = nodes_.size();
  Node node{{}, begin, end, -1};
  for (int i = begin; i < end; ++i) node.box.extend(entries_[static_cast<std::size_t>(i)].box);
  nodes_.push_back(node);
  if (end - begin <= leaf) return;
  Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  const auto place = [&](const Entry& entry) {
    return entry.box.min()[axis] / 2 + entry.box.max()[axis] / 2;
  };
  std::nth_element(entries_.begin() + begin, entries_.begin() + middle, entries_.begin() + end,
                   [&](const Entry& a, const Entry& b) {
                     return std::pair(place(a), a.face) < std::pair(place(b), b.face);
                   });
  build(begin, middle);
  nodes_[here].right = static_cast<int>(nodes_.size());
  build(middle, end);
}

}  // namespace seesaw
