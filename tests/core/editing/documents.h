// Documents to edit, and what "to the bit" means.
#pragma once

#include <cmath>
#include <string>

#include "core/base/random.h"
#include "core/editing/editor.h"
#include "core/scene/document_json.h"

namespace seesaw {

/// Everything that is in the document, -0.0 told from 0.0: the text has the shortest numbers that read back
/// to the same bits.
template <int Dim>
std::string bits_of(const Document<Dim>& document) {
  return to_json_text(document);
}

/// T&O 2002, section 5: a sculpting session begins with four boundary constraints at the vertices of a unit
/// tetrahedron, in eight exterior ones at the corners of a cube of side 6. In the plane: four in a circle.
template <int Dim>
Document<Dim> start_document();

template <>
inline Document<3> start_document<3>() {
  Document<3> document;
  const double a = 1 / std::sqrt(8.0);
  for (const Point<3>& corner :
       {Point<3>(a, a, a), Point<3>(a, -a, -a), Point<3>(-a, a, -a), Point<3>(-a, -a, a)})
    document.constraints.push_back({.constraint = boundary<3>(corner)});
  for (int i = 0; i < 8; ++i)
    document.constraints.push_back(
        {.constraint = exterior<3>({i & 1 ? 3.0 : -3.0, i & 2 ? 3.0 : -3.0, i & 4 ? 3.0 : -3.0})});
  document.title = "start";
  document.constraints[0].label = "first";
  return document;
}

template <>
inline Document<2> start_document<2>() {
  Document<2> document;
  for (const Point<2>& corner : {Point<2>(1, 0.1), Point<2>(0, 0.7), Point<2>(-0.9, 0), Point<2>(0.2, -0.6)})
    document.constraints.push_back({.constraint = boundary<2>(corner)});
  for (int i = 0; i < 8; ++i)
    document.constraints.push_back(
        {.constraint = exterior<2>({3 * std::cos(0.25 * M_PI * i), 3 * std::sin(0.25 * M_PI * i)})});
  document.constraints[2].highlight = true;
  return document;
}

/// The greatest difference of two functions at 2,000 points of `box`.
template <int Dim>
double greatest_change(const Field<Dim>& f, const Field<Dim>& g, const Box<Dim>& box) {
  Random random(1);
  const Points<Dim> points = random.points_in<Dim>(box, 2000);
  return (f.values(points) - g.values(points)).cwiseAbs().maxCoeff();
}

/// What f may change by where it should not: both are solved to about eps / (reciprocal condition) of the
/// values, which grow to `largest` in the box.
template <int Dim>
double rounding(const FitReport& report, const Field<Dim>& f, const Box<Dim>& box) {
  Random random(1);
  const double largest = f.values(random.points_in<Dim>(box, 2000)).cwiseAbs().maxCoeff();
  return 2.3e-16 / report.reciprocal_condition * largest;
}

}  // namespace seesaw
