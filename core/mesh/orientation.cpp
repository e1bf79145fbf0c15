#include "core/mesh/orientation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/face_boxes.h"
#include "core/mesh/predicates.h"

namespace seesaw {

namespace {

class Orienter {
 public:
  explicit Orienter(TriangleMesh& mesh)
      : mesh_(mesh), table_(mesh.faces, mesh.vertices.cols()), patch_of_(slot(mesh.faces.cols()), -1) {}

  OrientationReport run() {
    for (Index f = 0; f < mesh_.faces.cols(); ++f)
      if (patch_of_[slot(f)] < 0 && !table_.skipped(f)) flood(f);
    find_closed();
    turn_inside_out();
    return report_;
  }

 private:
  struct Patch {
    std::vector<int> faces;
    bool closed = true;
    double volume = 0;
    Box<3> box;
    std::vector<int> around;  // the closed patches that contain it
  };

  void flood(Index start) {
    Patch patch;
    const auto number = static_cast<int>(patches_.size());
    bool one_sided = false;
    std::vector<char>& turned = turned_;
    turned.resize(slot(mesh_.faces.cols()), 0);
    patch.faces.push_back(static_cast<int>(start));
    patch_of_[slot(start)] = number;
    Index turned_count = 0;
    for (std::size_t i = 0; i < patch.faces.size(); ++i) {
      const int f = patch.faces[i];
      for (int k = 0; k < 3; ++k) {
        const int h = 3 * f + k;
        const auto halves = table_.halves(table_.edge_of(h));
        if (halves.size() != 2) continue;
        const int other = halves[0] == h ? halves[1] : halves[0], g = other / 3;
        const bool agree = start_of(mesh_.faces, h) != start_of(mesh_.faces, other);
        const char expected = static_cast<char>(turned[slot(f)] ^ static_cast<char>(!agree));
        if (patch_of_[slot(g)] < 0) {
          patch_of_[slot(g)] = number;
          turned[slot(g)] = expected;
          turned_count += expected;
          patch.faces.push_back(g);
        } else if (turned[slot(g)] != expected) {
          one_sided = true;
        }
      }
    }
    if (one_sided) {
      ++report_.one_sided;
      patch.closed = false;
    } else {
      // The fewer are turned; of two halves the one without the first face.
      const auto all = static_cast<Index>(patch.faces.size());
      const char minority = 2 * turned_count > all ? 0 : 1;
      for (const int f : patch.faces) {
        if (turned[slot(f)] != minority) continue;
        turn(f);
        ++report_.turned_faces;
      }
    }
    patches_.push_back(std::move(patch));
  }

  void turn(Index f) { std::swap(mesh_.faces(1, f), mesh_.faces(2, f)); }

  // Closed: at every edge, as many of the patch's faces run one way as the other.
  void find_closed() {
    const EdgeTable table(mesh_.faces, mesh_.vertices.cols());
    std::vector<std::pair<int, int>> balance;  // patch, direction
    for (Index e = 0; e < table.edges(); ++e) {
      balance.clear();
      for (const int h : table.halves(e))
        balance.emplace_back(patch_of_[slot(h / 3)], start_of(mesh_.faces, h) == table.ends(e).a ? 1 : -1);
      std::sort(balance.begin(), balance.end());
      for (std::size_t i = 0; i < balance.size();) {
        const int patch = balance[i].first;
        int sum = 0;
        for (; i < balance.size() && balance[i].first == patch; ++i) sum += balance[i].second;
        if (sum != 0) patches_[slot(patch)].closed = false;
      }
    }
    for (Patch& patch : patches_) {
      if (!patch.closed) continue;
      for (const int f : patch.faces)
        for (int k = 0; k < 3; ++k) patch.box.extend(corner(f, k));
      const Point<3> middle = patch.box.min() / 2 + patch.box.max() / 2;
      // In units of the patch: a model of size 1e-150 has a volume too.
      const double size = patch.box.sizes().maxCoeff();
      for (const int f : patch.faces)
        patch.volume += ((corner(f, 0) - middle) / size)
                            .dot(((corner(f, 1) - middle) / size).cross((corner(f, 2) - middle) / size));
    }
  }

  Point<3> corner(Index f, int k) const { return mesh_.vertices.col(mesh_.faces(k, f)); }

  // Which closed patches does a ray from p along +x leave an odd number of times?
  std::vector<int> containers(const FaceBoxes& tree, const Point<3>& p, int but) const {
    Box<3> ray(p, Point<3>(infinity, p.y(), p.z()));
    std::vector<int> crossed;
    tree.visit(ray, [&](int f) {
      const int patch = patch_of_[slot(f)];
      if (patch != but && crosses(f, p)) crossed.push_back(patch);
    });
    std::sort(crossed.begin(), crossed.end());
    std::vector<int> odd;
    for (const int patch : crossed) {
      if (!odd.empty() && odd.back() == patch)
        odd.pop_back();
      else
        odd.push_back(patch);
    }
    return odd;
  }

  // Every edge is taken as lying a hair to one side of the ray, the same for the two faces it belongs to: a
  // ray through an edge or a vertex leaves the patch as often as its neighbors do.
  bool crosses(int f, const Point<3>& p) const {
    const Point<2> q(p.y(), p.z());
    int winding = 0;
    Point<2> flat[3];
    for (int k = 0; k < 3; ++k) flat[k] = corner(f, k).tail<2>();
    for (int k = 0; k < 3; ++k) {
      const Point<2>&a = flat[k], &b = flat[(k + 1) % 3];
      if ((a.y() <= q.y()) == (b.y() <= q.y())) continue;
      const int side = side_of_line(a, b, q);
      if (a.y() < b.y() && side > 0) ++winding;
      if (a.y() > b.y() && side < 0) --winding;
    }
    // Where the face's normal points to +x its image runs counter-clockwise, and p must lie below its plane.
    return winding != 0 && side_of_plane(corner(f, 0), corner(f, 1), corner(f, 2), p) == -winding;
  }

  void turn_inside_out() {
    std::vector<int> chosen;
    bool any = false;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (!patches_[i].closed) continue;
      chosen.insert(chosen.end(), patches_[i].faces.begin(), patches_[i].faces.end());
      any = any || patches_[i].volume < 0;
    }
    if (!any) return;
    std::sort(chosen.begin(), chosen.end());
    const FaceBoxes tree(mesh_, chosen);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      Patch& patch = patches_[i];
      if (!patch.closed) continue;
      for (const int c : containers(tree, corner(patch.faces.front(), 0), static_cast<int>(i)))
        // Shapes that merely overlap do not contain one another.
        if (patches_[slot(c)].box.contains(patch.box)) patch.around.push_back(c);
    }
    std::vector<char> turns(patches_.size(), 0);
    for (std::size_t i = 0; i < patches_.size(); ++i)
      turns[i] = patches_[i].closed && patches_[i].around.empty() && patches_[i].volume < 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const Patch& patch = patches_[i];
      const bool outermost_turns = std::any_of(patch.around.begin(), patch.around.end(), [&](int c) {
        return patches_[slot(c)].around.empty() && turns[slot(c)];
      });
      const bool should_look_in = patch.around.size() % 2 == 1;
      if (outermost_turns) turns[i] = should_look_in ? patch.volume > 0 : patch.volume < 0;
    }
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (!turns[i]) continue;
      ++report_.turned_patches;
      for (const int f : patches_[i].faces) turn(f);
    }
  }

  TriangleMesh& mesh_;
  EdgeTable table_;
  std::vector<int> patch_of_;
  std::vector<char> turned_;
  std::vector<Patch> patches_;
  OrientationReport report_;
};

}  // namespace

OrientationReport orient_faces(TriangleMesh& mesh) { return Orienter(mesh).run(); }

}  // namespace seesaw
