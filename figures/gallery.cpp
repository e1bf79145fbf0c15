#include "figures/gallery.h"

#include "core/base/text.h"
#include "figures/facts.h"

namespace seesaw {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string shown(const Facts& value) {
  if (value.is_number_float()) return in_words(value.get<double>(), 4);
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_object()) {
    std::string text;
    for (const auto& [key, inner] : value.items())
      text += (text.empty() ? "" : ", ") + escaped(key) + " " + shown(inner);
    return text;
  }
  if (value.is_array()) {
    std::string text;
    for (const auto& inner : value) text += (text.empty() ? "" : ", ") + shown(inner);
    return text;
  }
  return escaped(value.dump());
}

const char* const head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Seesaw: the figures</title>
<style>
  body { margin: 0 auto; max-width: 62rem; padding: 2rem 1.2rem 4rem; font: 16px/1.55 system-ui, sans-serif; color: #1b1f24; background: #fff; }
  h1 { font-size: 1.7rem; margin-bottom: .2rem; }
  h2 { font-size: 1.2rem; margin: 0 0 .3rem; }
  .lead, .source { color: #59616b; }
  nav { columns: 18rem; margin: 1.5rem 0 2.5rem; }
  nav a { display: block; text-decoration: none; color: #0072b2; }
  section { border-top: 1px solid #dde1e6; padding: 2rem 0; }
  img { width: 100%; height: auto; border: 1px solid #dde1e6; border-radius: 6px; }
  table { border-collapse: collapse; font-size: .9rem; margin: .6rem 0; width: 100%; }
  th, td { text-align: left; padding: .2rem .8rem .2rem 0; border-bottom: 1px solid #eef0f2; vertical-align: top; }
  th { font-weight: 600; color: #59616b; }
  td.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
  .holds { color: #00694f; } .fails { color: #cc3311; font-weight: 700; }
  details { margin-top: .6rem; } summary { cursor: pointer; }
</style>
</head>
<body>
)";

std::string table_of_checks(const Facts& figure) {
  std::string html = "<table><tr><th>check</th><th>measured</th><th></th><th>bound</th><th></th></tr>\n";
  for (const auto& check : figure["checks"]) {
    const bool holds = check["holds"].get<bool>();
    html += "<tr><td>" + shown(check["name"]) + "</td><td class=number>" + shown(check["value"]) +
            "</td><td>" + shown(check["relation"]) + "</td><td class=number>" + shown(check["bound"]) +
            "</td><td class=" + (holds ? "holds>holds" : "fails>FAILS") + "</td></tr>\n";
  }
  return html + "</table>\n";
}

std::string table_of_facts(const Facts& panel) {
  std::string html =
      "<table><tr><th colspan=2>" + shown(panel["name"]) + ": " + shown(panel["title"]) + "</th></tr>\n";
  for (const auto& [key, value] : panel["facts"].items())
    html += "<tr><td>" + escaped(key) + "</td><td class=number>" + shown(value) + "</td></tr>\n";
  return html + "</table>\n";
}

}  // namespace

std::string gallery_page(const std::vector<Facts>& descriptions) {
  std::size_t checks = 0, held = 0;
  for (const Facts& figure : descriptions)
    for (const auto& check : figure["checks"]) {
      ++checks;
      held += check["holds"].get<bool>();
    }
  std::string html = head;
  html +=
      "<h1>Seesaw: the figures</h1>\n<p class=lead>Interpolating implicit curves and surfaces, after Turk "
      "&amp; "
      "O\u2019Brien (2002) and Witkin &amp; Heckbert (1994). " +
      std::to_string(descriptions.size()) + " figures, " + std::to_string(held) + " of " +
      std::to_string(checks) + " checks hold.</p>\n<nav>\n";
  for (const Facts& figure : descriptions)
    html += "<a href=\"#" + shown(figure["figure"]) + "\">" + shown(figure["title"]) + "</a>\n";
  html += "</nav>\n";
  for (const Facts& figure : descriptions) {
    const std::string id = shown(figure["figure"]);
    if (figure.contains("missing")) {
      html += "<section id=\"" + id + "\">\n<h2>" + shown(figure["title"]) +
              "</h2>\n<p>Not made: " + shown(figure["missing"]) + ".</p>\n</section>\n";
      continue;
    }
    html += "<section id=\"" + id + "\">\n<h2>" + shown(figure["title"]) + "</h2>\n<p class=source>" +
            shown(figure["paper"]) + " \u00b7 <code>" + id + "</code></p>\n<p>" + shown(figure["shows"]) +
            "</p>\n<a href=\"" + id + ".png\"><img src=\"" + id + ".png\" alt=\"" + shown(figure["title"]) +
            "\"></a>\n" + table_of_checks(figure) + "<details><summary>All facts</summary>\n";
    for (const auto& panel : figure["panels"]) html += table_of_facts(panel);
    html += "<p><a href=\"" + id + ".json\">" + id + ".json</a></p></details>\n</section>\n";
  }
  return html + "</body>\n</html>\n";
}

}  // namespace seesaw
