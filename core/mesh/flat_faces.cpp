#include "core/mesh/flat_faces.h"

#include <algorithm>
#include <cstddef>

#include "core/mesh/edge_table.h"
#include "core/mesh/predicates.h"

namespace seesaw {

namespace {

using Face = std::array<int, 3>;

bool on_one_line(const Point<3>& a, const Point<3>& b, const Point<3>& c) {
  for (int d = 0; d < 3; ++d) {
    const auto flat = [d](const Point<3>& p) { return Point<2>(p[d], p[(d + 1) % 3]); };
    if (side_of_line(flat(a), flat(b), flat(c)) != 0) return false;
  }
  return true;
}

class FlatFaces {
 public:
  FlatFaces(const Eigen::Ref<const Points<3>>& points, std::vector<Face>& faces)
      : points_(points), faces_(faces) {}

  Index remove() {
    Index removed = 0;
    // A joined face may be flat in turn, one step farther along the line; who needs more steps is dropped.
    for (int round = 0; round < 32; ++round) {
      const std::vector<int> flat = find();
      if (flat.empty()) return removed;
      if (round == 0) removed = static_cast<Index>(flat.size());
      join(flat);
    }
    for (const int f : find()) faces_[static_cast<std::size_t>(f)] = dropped;
    std::erase(faces_, dropped);
    return removed;
  }

 private:
  static constexpr Face dropped = {0, 0, 0};

  std::vector<int> find() const {
    std::vector<int> flat;
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (on_one_line(points_.col(faces_[f][0]), points_.col(faces_[f][1]), points_.col(faces_[f][2])))
        flat.push_back(static_cast<int>(f));
    return flat;
  }

  void join(const std::vector<int>& flat) {
    const Faces columns =
        Eigen::Map<const Faces>(faces_.data()->data(), 3, static_cast<Index>(faces_.size()));
    const EdgeTable table(columns, points_.cols());
    std::vector<char> touched(faces_.size(), 0);
    for (const int f : flat) {
      const auto here = static_cast<std::size_t>(f);
      if (touched[here]) continue;
      const int long_side = longest_side(faces_[here]);
      const int h = 3 * f + long_side;
      const auto halves = table.halves(table.edge_of(h));
      const int middle = faces_[here][static_cast<std::size_t>((long_side + 2) % 3)];
      bool joined = false;
      if (halves.size() == 2) {
        const int other = halves[0] == h ? halves[1] : halves[0];
        const auto there = static_cast<std::size_t>(other / 3);
        if (touched[there]) continue;  // in the next round
        const auto k = static_cast<std::size_t>(other % 3);
        const int from = faces_[there][k], to = faces_[there][(k + 1) % 3], tip = faces_[there][(k + 2) % 3];
        joined = tip != middle && table.find(tip, middle) < 0;
        if (joined) {
          faces_[there] = {from, middle, tip};
          faces_[here] = {middle, to, tip};
          touched[there] = 1;
        }
      }
      touched[here] = 1;
      if (!joined) faces_[here] = dropped;
    }
    std::erase(faces_, dropped);
  }

  int longest_side(const Face& face) const {
    double best = -1;
    int side = 0;
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double length = (points_.col(face[(i + 1) % 3]) - points_.col(face[i])).cwiseAbs().maxCoeff();
      if (length > best) {
        best = length;
        side = k;
      }
    }
    return side;
  }

  const Eigen::Ref<const Points<3>>& points_;
  std::vector<Face>& faces_;
};

}  // namespace

Index remove_flat_faces(const Eigen::Ref<const Points<3>>& points, std::vector<std::array<int, 3>>& faces) {
  return FlatFaces(points, faces).remove();
}

}  // namespace seesaw
