// Fits four boundary constraints about one interior constraint, and draws the curve.
#include <core/rbf/fit.h>
#include <core/scene/picture.h>

#include <iostream>

int main(int, char** argv) {
  using namespace seesaw;
  Document<2> document;
  for (const Point<2> at : {Point<2>(-1, 0), Point<2>(0, -1), Point<2>(1, 0), Point<2>(0, 1)})
    document.constraints.push_back({.constraint = boundary<2>(at)});
  document.constraints.push_back({.constraint = interior<2>({0, 0})});
  const Fit<2> fitted = fit(document);
  Canvas canvas(200, 200);
  const DrawnPicture drawn = draw_document(canvas, canvas.bounds(), document, fitted.function);
  canvas.save(argv[1]);
  std::cout << drawn.curve.components << " closed curve, area " << drawn.curve.area << '\n';
  return drawn.curve.closed == 1 && fitted.report.max_residual < 1e-14 ? 0 : 1;
}
