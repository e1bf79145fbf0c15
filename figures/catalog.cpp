#include "figures/catalog.h"

namespace seesaw {

Figure turk2002_fig01(const FigureContext&);
Figure turk2002_fig02(const FigureContext&);
Figure turk2002_fig03(const FigureContext&);
Figure turk2002_fig04(const FigureContext&);
Figure turk2002_fig05(const FigureContext&);
Figure turk2002_fig06(const FigureContext&);
Figure turk2002_fig07(const FigureContext&);
Figure turk2002_fig08(const FigureContext&);
Figure turk2002_fig09(const FigureContext&);
Figure turk2002_fig10(const FigureContext&);
Figure witkin1994_fig1(const FigureContext&);
Figure witkin1994_fig2(const FigureContext&);
Figure seesaw_figure(const FigureContext&);
Figure energy_figure(const FigureContext&);
Figure knot_insertion(const FigureContext&);
Figure height_field(const FigureContext&);
Figure kernels_figure(const FigureContext&);
Figure blend_bulge(const FigureContext&);
Figure interference_figure(const FigureContext&);
Figure sphere_tracing(const FigureContext&);
Figure bunny_timing(const FigureContext&);
Figure fission_figure(const FigureContext&);
Figure slippery_figure(const FigureContext&);

const std::vector<FigureEntry>& catalog() {
  static const std::vector<FigureEntry> entries = {
      {"turk2002-fig01", "curves from boundary constraints and one interior constraint", turk2002_fig01},
      {"turk2002-fig02", "surfaces from interior constraints", turk2002_fig02},
      {"turk2002-fig03", "a fist, polygons and the surface through them", turk2002_fig03},
      {"turk2002-fig04", "curves inside a cage of exterior constraints", turk2002_fig04},
      {"turk2002-fig05", "one normal constraint bends a curve", turk2002_fig05},
      {"turk2002-fig06", "the bunny, polygons and the surface through them", turk2002_fig06},
      {"turk2002-fig07", "a ball, and a torus sculpted from it", turk2002_fig07},
      {"turk2002-fig08", "a normal constraint is turned", turk2002_fig08},
      {"turk2002-fig09", "three tori, blended", turk2002_fig09},
      {"turk2002-fig10", "two surfaces ray traced, and constructive solid geometry", turk2002_fig10},
      {"witkin1994-fig1", "floaters on a cylinder that is stretched", witkin1994_fig1},
      {"witkin1994-fig2", "blobby cylinders, shaped by control points", witkin1994_fig2},
      {"seesaw", "each boundary constraint acts much like a see-saw", seesaw_figure},
      {"energy", "bending energy from the weights and by quadrature", energy_figure},
      {"knot-insertion", "new boundary constraints leave the curve unchanged", knot_insertion},
      {"height-field", "a thin-plate height field, and why it cannot close", height_field},
      {"kernels", "the same constraints under three kernels", kernels_figure},
      {"blend-bulge", "summed blobbies bulge, the interpolating blend does not", blend_bulge},
      {"interference", "two solids moved together: where they interfere", interference_figure},
      {"sphere-tracing", "sphere tracing by samples and by proven bounds", sphere_tracing},
      {"bunny-timing", "solving and extracting the bunny, then and now", bunny_timing},
      {"fission", "repulsion, global fissioning and adaptive repulsion from one place", fission_figure},
      {"slippery", "the same drag on a blobby model and on an interpolating surface", slippery_figure},
  };
  return entries;
}

const FigureEntry* figure_named(const std::string& id) {
  for (const FigureEntry& entry : catalog())
    if (entry.id == id) return &entry;
  return nullptr;
}

}  // namespace seesaw
