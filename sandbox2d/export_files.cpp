#include "sandbox2d/export_files.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/document_json.h"

namespace seesaw {

const std::vector<FileKind>& export_kinds() {
  static const std::vector<FileKind> kinds = {{".png", "Picture"},
                                              {".svg", "Drawing"},
                                              {".pdf", "Page"},
                                              {".csv", "Curve as numbers"},
                                              {".json", "Scene"}};
  return kinds;
}

void export_document(const std::filesystem::path& path, const Document<2>& document, const Field<2>& function,
                     const ExportOptions& options) {
  const std::string ending = ending_of(path);
  refuse_unless_writable(path);
  if (ending == ".json") {
    write_document(path, document);
  } else if (ending == ".csv") {
    const Contour curve = contour(document, function, view_box(document, function), {.cells = options.cells});
    write_file(path, to_csv(curve.polylines));
  } else if (kind_of(path, export_kinds()) >= 0) {
    picture_of(document, function, options.size).save(path, options.pixels_per_point);
  } else {
    throw Error(path.filename().string() + ": expected a name that ends in .png, .svg, .pdf, .csv or .json");
  }
}

}  // namespace seesaw
