#include "figures/facts.h"

#include "core/base/text.h"

namespace seesaw {

Facts fit_facts(const FitReport& report) {
  Facts facts = Facts::object();
  facts["constraints"] = {{"boundary", report.boundary},
                          {"interior", report.interior},
                          {"exterior", report.exterior},
                          {"normal", report.normal},
                          {"total", report.constraints()}};
  facts["kernel"] = name_of(report.kernel);
  facts["max_residual"] = report.max_residual;
  facts["reciprocal_condition"] = report.reciprocal_condition;
  facts["energy"] = report.energy;
  facts["fit_seconds"] = report.seconds;
  return facts;
}

void add_curve_facts(Facts& facts, const Contour& curve) {
  Index outer = 0, holes = 0;
  for (const Polyline& polyline : curve.polylines)
    if (polyline.closed) (signed_area(polyline) > 0 ? outer : holes) += 1;
  facts["components"] = curve.components;
  facts["closed"] = curve.closed;
  facts["euler_characteristic"] = outer - holes;
  facts["genus"] = 0;
  facts["boundary_edges"] = 2 * (curve.components - curve.closed);
  facts["area"] = curve.area;
  facts["length"] = curve.length;
}

Check residual_check(const std::string& panel, const FitReport& report) {
  return at_most(panel + ": max |f(c) - h|", report.max_residual, report.constraints() <= 50 ? 1e-12 : 2e-8);
}

std::string in_words(double value, int digits) {
  std::string text = to_text(value, digits);
  std::string exponent;
  if (const auto e = text.find('e'); e != std::string::npos) {
    exponent = std::to_string(std::stoi(text.substr(e + 1)));
    text.resize(e);
  }
  const auto signed_text = [](const std::string& t) { return t[0] == '-' ? "\u2212" + t.substr(1) : t; };
  if (exponent.empty()) return signed_text(text);
  static const char* const raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                       "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string power;
  for (const char c : exponent) power += c == '-' ? "\u207b" : raised[c - '0'];
  return signed_text(text) + "\u00d710" + power;
}

}  // namespace seesaw
