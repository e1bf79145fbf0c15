#include "core/mesh/polyline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"

namespace seesaw {
namespace {

// The exact sign of a sum of numbers, by the transformation of Rump, Ogita and Oishi in its plainest form:
// error-free additions until the leading number outweighs all others together.
int exact_sign_of_sum(std::array<double, 12> terms) {
  for (int pass = 0;; ++pass) {
    double rest = 0;
    for (std::size_t i = 1; i < terms.size(); ++i) {
      const double a = terms[i - 1], b = terms[i];
      const double sum = a + b;
      const double part = sum - a;
      terms[i - 1] = (a - (sum - part)) + (b - part);
      terms[i] = sum;
    }
    for (std::size_t i = 0; i + 1 < terms.size(); ++i) rest += std::abs(terms[i]);
    const double lead = terms.back();
    // Two or three passes are usual; each makes the leading number at least weigh more, so the bound is never
    // met.
    if (rest == 0 || std::abs(lead) > 2 * rest || pass == 100) return (lead > 0) - (lead < 0);
  }
}

// On which side of the directed line a -> b the point lies: 1 left, -1 right, 0 on it. Plain rounding decides
// unless the result is within its error bound (Shewchuk 1997, section 4.3), then exact products do.
int side_of(const Point<2>& a, const Point<2>& b, const Point<2>& p) {
  const double left = (a.x() - p.x()) * (b.y() - p.y());
  const double right = (a.y() - p.y()) * (b.x() - p.x());
  const double determinant = left - right;
  if (std::abs(determinant) > 4e-16 * (std::abs(left) + std::abs(right))) return determinant > 0 ? 1 : -1;
  // a x b + b x p + p x a, each product split into its rounded value and its exact error.
  std::array<double, 12> terms;
  std::size_t count = 0;
  const auto product = [&](double x, double y) {
    terms[count++] = x * y;
    terms[count++] = std::fma(x, y, -(x * y));
  };
  product(a.x(), b.y()), product(-a.y(), b.x());
  product(b.x(), p.y()), product(-b.y(), p.x());
  product(p.x(), a.y()), product(-p.y(), a.x());
  return exact_sign_of_sum(terms);
}

template <class Visit>
void for_each_segment(const Polyline& polyline, Visit&& visit) {
  const Index n = polyline.vertices.cols();
  for (Index i = 0; i < polyline.segments(); ++i)
    visit(Point<2>(polyline.vertices.col(i)), Point<2>(polyline.vertices.col(i + 1 < n ? i + 1 : 0)));
}

}  // namespace

double signed_area(const Polyline& polyline) {
  if (polyline.vertices.cols() < 3) return 0;
  // From the first vertex, so that a small loop far from the origin keeps its digits.
  const Point<2> origin = polyline.vertices.col(0);
  double twice = 0;
  for_each_segment(polyline,
                   [&](const Point<2>& a, const Point<2>& b) { twice += cross(a - origin, b - origin); });
  return 0.5 * twice;
}

double length(const Polyline& polyline) {
  double sum = 0;
  for_each_segment(polyline, [&](const Point<2>& a, const Point<2>& b) { sum += (b - a).norm(); });
  return sum;
}

Box<2> bounding_box(const Polyline& polyline) { return bounding_box_of<2>(polyline.vertices); }

int winding_number(const Polyline& polyline, const Point<2>& point) {
  if (!polyline.closed) return 0;
  // Segments that cross the ray from the point toward +x, upward minus downward. Half open in y, so a vertex
  // on the ray counts once.
  int winding = 0;
  for_each_segment(polyline, [&](const Point<2>& a, const Point<2>& b) {
    const bool a_below = a.y() <= point.y(), b_below = b.y() <= point.y();
    if (a_below == b_below) return;
    const int side = side_of(a, b, point);
    if (a_below && side > 0) ++winding;
    if (b_below && side < 0) --winding;
  });
  return winding;
}

int winding_number(const std::vector<Polyline>& polylines, const Point<2>& point) {
  int sum = 0;
  for (const Polyline& polyline : polylines) sum += winding_number(polyline, point);
  return sum;
}

double distance(const Polyline& polyline, const Point<2>& point) {
  double nearest = infinity;
  if (polyline.vertices.cols() > 0) nearest = (polyline.vertices.col(0) - point).norm();
  for_each_segment(polyline, [&](const Point<2>& a, const Point<2>& b) {
    const Point<2> along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + t * along - point).norm());
  });
  return nearest;
}

std::string to_csv(const std::vector<Polyline>& polylines) {
  std::string text = "polyline,closed,x,y\n";
  for (std::size_t k = 0; k < polylines.size(); ++k)
    for (Index i = 0; i < polylines[k].vertices.cols(); ++i)
      text += std::to_string(k) + (polylines[k].closed ? ",1," : ",0,") +
              to_text(polylines[k].vertices(0, i), 17) + ',' + to_text(polylines[k].vertices(1, i), 17) +
              '\n';
  return text;
}

}  // namespace seesaw
