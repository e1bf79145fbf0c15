// A decimal comma in the locale changes nothing in a file.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>
#include <utility>

#include "core/base/file.h"
#include "core/scene/document_json.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

const char* const locale_text = R"({
  "seesaw": 1,
  "dimension": 2,
  "kernel": "cubic",
  "smoothing": 0.5,
  "mine": [0.25, -1.5e-07, 1234567.5],
  "constraints": [
    {"kind": "interior", "at": [12345.75, -0.001], "value": 1e-20}
  ]
}
)";

void expect_the_same_as_ever() {
  const auto document = parse_document<2>(locale_text);
  EXPECT_EQ(document.smoothing, 0.5);
  EXPECT_EQ(document.constraints.at(0).constraint.at, Point<2>(12345.75, -0.001));
  EXPECT_EQ(document.constraints.at(0).constraint.value, 1e-20);
  EXPECT_EQ(to_json_text(document), locale_text);
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(DocumentLocale, ALocaleOfTheStreamsChangesNothing) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  expect_the_same_as_ever();
  std::locale::global(before);
}

/// Makes a locale with this decimal point (in localedef's writing), which setlocale finds by the path
/// LOCPATH.
bool make_locale(const std::filesystem::path& folder, const std::string& name, const std::string& point) {
  write_file(folder / (name + ".source"), "LC_NUMERIC\ndecimal_point \"" + point +
                                              "\"\nthousands_sep \"\"\ngrouping -1\nEND LC_NUMERIC\n");
  // Warnings that the other categories are missing count as failure: whether it worked, setlocale will say.
  return std::system(("cd '" + folder.string() + "' && localedef -c -f UTF-8 -i " + name + ".source ./" +
                      name + " >/dev/null 2>&1")
                         .c_str()) != -1;
}

TEST(DocumentLocale, ALocaleOfTheProgramChangesNothing) {
  const ScratchFolder folder;
  ::setenv("LOCPATH", folder.path().c_str(), 1);
  int tried = 0;
  // A comma, and a decimal point of two bytes as fa_IR and ps_AF have it.
  for (const auto& [name, point] : {std::pair("comma", ","), std::pair("momayyez", "<U066B>")}) {
    if (!make_locale(folder.path(), name, point) || !std::setlocale(LC_NUMERIC, name)) continue;
    ++tried;
    SCOPED_TRACE(name);
    EXPECT_STRNE(std::localeconv()->decimal_point, ".");
    expect_the_same_as_ever();
    // And it is still the program's locale afterward.
    EXPECT_EQ(std::strtod("0.5", nullptr), 0.0);
  }
  std::setlocale(LC_NUMERIC, "C");
  ::unsetenv("LOCPATH");
  if (tried == 0) GTEST_SKIP() << "localedef makes no locale here";
}

}  // namespace
}  // namespace seesaw
