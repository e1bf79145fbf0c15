// Documents in and out of files.
//
// Before it: a file that a person, an editor or a program wrote.  After it: core/scene/document.h, checked.
//
//     {
//       "seesaw": 1,
//       "dimension": 2,
//       "kernel": "thin_plate_spline",
//       "smoothing": 0,
//       "constraints": [
//         {"kind": "boundary", "at": [0, 1], "normal": [0, 1], "offset": 0.01, "value": 1},
//         {"kind": "interior", "at": [0, 0], "value": 1},
//         {"kind": "exterior", "at": [2, 2], "value": -1}
//       ]
//     }
//
// "seesaw" (the version), "dimension" and "constraints" must be there; the kernel defaults to the papers'
// kernel of the dimension, smoothing to 0. Of a boundary constraint, "normal", "offset" and "value" describe
// its normal constraint: f = value at `at - offset * normal` (0.01 and 1 where they are missing). "value"
// defaults to 1 for interior, -1 for exterior. A constraint may have "highlight": true, "highlight_normal":
// true and a "label". Beside them a document may have "title", "figure", "description", "display" and, in 3D,
// "camera": {"position", "target", "up", "field_of_view"}; see document.h.
//
// Keys that this version does not know (in 2D, "camera" is one) are kept, at every level, and written back
// after those it knows. Everything else is refused with the line and the path of the culprit:
//     shape.json:12: constraints[3].at: expected 2 numbers, found 3
// No more than 256 MiB, 20 million values (some two million constraints) and 64 levels are read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/scene/document.h"

namespace seesaw {

/// The newest version of the format, which is what is written.
inline constexpr int document_version = 1;

/// The document that `text` holds, UTF-8 with or without a byte order mark. `name` is what errors call it.
/// Throws FileError.
AnyDocument parse_document(std::string_view text, const std::string& name = "document");
/// As above, and refuses a document of another dimension. For Dim 2 and 3.
template <int Dim>
Document<Dim> parse_document(std::string_view text, const std::string& name = "document");

/// The document in the file. Throws FileError.
AnyDocument read_document(const std::filesystem::path& path);
/// As above, and refuses a document of another dimension. For Dim 2 and 3.
template <int Dim>
Document<Dim> read_document(const std::filesystem::path& path);

/// The text of a file that holds `document`: the same text for the same document, one constraint a line,
/// every number the shortest that reads back to the same bits. Bytes that are not UTF-8 become U+FFFD. Throws
/// Error, naming the path, for what a reader would refuse (not a number, an interior value below 0, a zero
/// normal).
template <int Dim>
std::string to_json_text(const Document<Dim>& document);
std::string to_json_text(const AnyDocument& document);

/// Writes to_json_text(document) over the file, all or nothing. Throws Error as above before it touches the
/// file, or FileError.
template <int Dim>
void write_document(const std::filesystem::path& path, const Document<Dim>& document);
void write_document(const std::filesystem::path& path, const AnyDocument& document);

}  // namespace seesaw
