// What "Export" writes, by the ending of the name: a picture, the curve as numbers, or the scene.
//
// Before it: the editor's document, whose display.view is the part that is shown, and its function.
// After it: a file for slides, a paper or another program.
//
//     Document<2> shown = desk.to_save();
//     shown.display.view = ...;
//     export_document("curve.pdf", shown, *desk.shape().function);
//
// Pictures are those of core/scene/document_picture.h, as `figures render` makes them; numbers those of
// `seesaw contour -o curve.csv`.
#pragma once

#include <filesystem>
#include <vector>

#include "core/contour/contour.h"
#include "core/scene/document_picture.h"
#include "sandbox2d/folder_listing.h"

namespace seesaw {

struct ExportOptions {
  double size = usual_picture_size;    ///< the longer side of a picture, points
  double pixels_per_point = 2;         ///< of .png
  int cells = ContourOptions().cells;  ///< along the longer side of the view, for .csv
};

/// What can be written, for a file dialog: PNG, SVG, PDF, CSV, JSON.
const std::vector<FileKind>& export_kinds();

/// Writes the file as a whole or not at all. `function` is the document's. Throws Error for an ending that is
/// none of export_kinds() or a picture that is too large, FileError where nothing can be written.
void export_document(const std::filesystem::path& path, const Document<2>& document, const Field<2>& function,
                     const ExportOptions& options = {});

}  // namespace seesaw
